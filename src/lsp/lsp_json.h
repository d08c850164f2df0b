#pragma once
// Converts positions, ranges and findings to the JSON of the Language Server Protocol, and back.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "lsp/text_document.h"

namespace kadr {

using LspJson = nlohmann::json;

/// A fault of a request. `code` is one of JSON-RPC or of LSP 3.17 ("ErrorCodes").
struct LspFault {
  enum Code : int {
    parse_error = -32700,
    invalid_request = -32600,
    method_not_found = -32601,
    invalid_params = -32602,
    not_initialized = -32002,
    request_cancelled = -32800,
    request_failed = -32803
  };
  Code code = request_failed;
  std::string text;
};

LspJson range_json(const TextRange& range);

/// Returns the position or range in a JSON value.
///   throws  LspFault if the value is not of that form
TextPosition position_in(const LspJson& json);
TextRange range_in(const LspJson& json);

/// Returns the member of an object.
///   throws  LspFault if there is none, or if it is of another type
const LspJson& member(const LspJson& object, const char* name);
std::string text_in(const LspJson& object, const char* name);
/// Returns a text of an object, or `otherwise` if there is none.
std::string text_or(const LspJson& object, const char* name, std::string otherwise);

/// Returns the path of a file: URI, and back. Percent-encoded bytes are decoded (RFC 3986 2.1). Returns nullopt for other schemes.
std::optional<std::string> path_of_uri(std::string_view uri);
std::string uri_of_path(std::string_view path);

/// Converts JSON to text. Bytes that are not UTF-8 are replaced, because JSON requires UTF-8.
std::string dumped_message(const LspJson& json);

}  // namespace kadr
