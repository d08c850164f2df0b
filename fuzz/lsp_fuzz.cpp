// Fuzz target for the language server. The input is any messages, one per line, after `initialize`. Each request must get one answer, with
// a result or an error; all messages must be JSON.

#include <algorithm>
#include <map>
#include <string_view>

#include "lsp/language_server.h"
#include "protocol_watch.h"
#include "require.h"

namespace {

using namespace kadr;

constexpr std::size_t max_lines = 24;                      // messages in an input
constexpr auto patience = std::chrono::milliseconds(150);  // time for the work after a message; then it is stopped
constexpr const char* beginning =
    R"({"jsonrpc":"2.0","id":"begin","method":"initialize","params":{"capabilities":{"workspace":{"applyEdit":true,"workspaceEdit":)"
    R"({"documentChanges":true,"resourceOperations":["create"]}},"textDocument":{"codeAction":{"codeActionLiteralSupport":{}}}}}})";

/// Counts the answers to the requests, by id.
class Answers {
 public:
  void expect(const std::string& message) {
    const LspJson json = LspJson::parse(message, nullptr, false);
    if (!json.is_object() || !json.contains("id")) return;
    const bool is_answer = !(json.contains("method") && json["method"].is_string()) && (json.contains("result") || json.contains("error"));
    if (is_answer) return;
    if (json["id"].is_number() || json["id"].is_string()) ++open_[json["id"].dump()];
  }
  void take(const std::string& message) {
    const LspJson json = LspJson::parse(message, nullptr, false);
    fuzz::require(json.is_object() && json.value("jsonrpc", "") == "2.0", "a message is JSON-RPC 2.0");
    if (json.contains("method")) return;
    fuzz::require(json.contains("result") != json.contains("error"), "an answer has a result or an error");
    if (json["id"].is_null()) return;  // about a message that is none
    fuzz::require(open_[json["id"].dump()]-- > 0, "one answer to each request");
  }
  bool all() const {
    return std::all_of(open_.begin(), open_.end(), [](const auto& one) { return one.second == 0; });
  }

 private:
  std::map<std::string, int> open_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  Answers answers;
  LanguageServer server([&](const std::string& message) { answers.take(message); }, Lang::en, "0");
  const auto take = [&](const std::string& message) {
    answers.expect(message);
    server.take(message);
    const fuzz::ProtocolWatch watch(patience);
    if (server.has_work()) server.work(watch.token());
  };
  take(beginning);
  for (std::size_t count = 0; count < max_lines && !text.empty() && !server.is_over(); ++count) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    take(std::string(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  take(R"({"jsonrpc":"2.0","id":"end","method":"shutdown"})");
  fuzz::require(answers.all(), "each request is answered at the end");
  return 0;
}
