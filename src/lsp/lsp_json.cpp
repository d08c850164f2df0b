// Conversions between values and the JSON of the Language Server Protocol. Used by the files of lsp; tested by
// tests/lsp.py.

#include "lsp/lsp_json.h"

#include <fmt/core.h>

#include <limits>

#include "base/ascii.h"
#include "config/json_text.h"
#include "config/texts.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr std::string_view file_scheme = "file://";

[[noreturn]] void wrong_member(const char* name) { throw LspFault{LspFault::invalid_params, translated(texts::lsp::wrong_member, name)}; }

/// Reads a whole number that is not negative; a larger one than fits becomes the largest.
std::uint32_t count_in_member(const LspJson& object, const char* name) {
  const LspJson& value = member(object, name);
  if (!value.is_number_integer() || value.get<std::int64_t>() < 0) wrong_member(name);
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(value.get<std::uint64_t>(), std::numeric_limits<std::int32_t>::max()));
}

int digit_of(char c) {
  if (is_digit(c)) return c - '0';
  const char small = to_lower(c);
  return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

}  // namespace

LspJson range_json(const TextRange& range) {
  const auto position = [](const TextPosition& at) { return LspJson{{"line", at.line}, {"character", at.column}}; };
  return {{"start", position(range.start)}, {"end", position(range.end)}};
}

const LspJson& member(const LspJson& object, const char* name) {
  if (!object.is_object()) wrong_member(name);
  const auto found = object.find(name);
  if (found == object.end()) wrong_member(name);
  return *found;
}

std::string text_in(const LspJson& object, const char* name) {
  const LspJson& value = member(object, name);
  if (!value.is_string()) wrong_member(name);
  return value.get<std::string>();
}

std::string text_or(const LspJson& object, const char* name, std::string otherwise) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

TextPosition position_in(const LspJson& json) { return {count_in_member(json, "line"), count_in_member(json, "character")}; }

TextRange range_in(const LspJson& json) { return {position_in(member(json, "start")), position_in(member(json, "end"))}; }

std::optional<std::string> path_of_uri(std::string_view uri) {
  if (!uri.starts_with(file_scheme)) return std::nullopt;
  uri.remove_prefix(file_scheme.size());
  uri.remove_prefix(std::min(uri.find('/'), uri.size()));  // the host: empty, or "localhost"
  std::string path;
  for (std::size_t at = 0; at < uri.size(); ++at) {
    const int high = uri[at] == '%' && at + 2 < uri.size() ? digit_of(uri[at + 1]) : -1;
    const int low = high >= 0 ? digit_of(uri[at + 2]) : -1;
    if (low < 0) {
      path += uri[at];
      continue;
    }
    path += static_cast<char>(high * 16 + low);
    at += 2;
  }
  return path;
}

std::string uri_of_path(std::string_view path) {
  constexpr std::string_view kept = "/-._~";
  std::string uri(file_scheme);
  for (const char c : path) {
    if (is_digit(c) || is_capital(c) || (c >= 'a' && c <= 'z') || kept.find(c) != std::string_view::npos) uri += c;
    else uri += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return uri;
}

std::string dumped_message(const LspJson& json) { return json_text(json); }

}  // namespace kadr
