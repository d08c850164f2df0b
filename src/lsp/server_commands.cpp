// LanguageServer: code actions, commands, and requests to the editor. Tested by tests/lsp.py.

#include <fmt/format.h>

#include <algorithm>

#include "config/texts.h"
#include "lsp/features.h"
#include "lsp/language_server.h"
#include "lsp/proven_commands.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr int message_of_warning = 2, message_of_information = 3;  // LSP 3.17, "MessageType"
constexpr std::size_t most_waiting = 100;                          // commands; a person starts one at a time

}  // namespace

// ---- requests to the editor

void LanguageServer::ask(const char* method, LspJson params, std::function<void(const LspJson&)> then) {
  const std::string id = fmt::format("kadr-{}", ++last_asked_);
  asked_[id] = std::move(then);
  send_(dumped_message({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(params)}}));
}

void LanguageServer::take_answer(const LspJson& message) {
  const auto found = message["id"].is_string() ? asked_.find(message["id"].get<std::string>()) : asked_.end();
  if (found == asked_.end()) return;
  const auto then = std::move(found->second);
  asked_.erase(found);
  then(message);
}

void LanguageServer::show(int type, const std::string& text) { notify("window/showMessage", {{"type", type}, {"message", text}}); }

/// Lets the editor apply an edit. When it has done so, it shows the new file.
void LanguageServer::apply(const CommandOutcome& outcome) {
  if (outcome.edit.is_null()) return show(message_of_information, outcome.told);
  ask("workspace/applyEdit", {{"label", outcome.label}, {"edit", outcome.edit}},
      [this, told = outcome.told, created = outcome.created](const LspJson& message) {
        const auto result = message.find("result");
        const bool is_applied = result != message.end() && result->is_object() && result->value("applied", LspJson()) == true;
        if (!is_applied) {
          const auto reason = [&](const char* path) {
            const LspJson::json_pointer pointer(path);
            return message.contains(pointer) && message[pointer].is_string() ? message[pointer].get<std::string>() : std::string();
          };
          return show(message_of_warning, translated(texts::lsp::not_applied, reason("/result/failureReason") + reason("/error/message")));
        }
        if (!created.empty() && editor_.shows_documents)
          ask("window/showDocument", {{"uri", created}, {"takeFocus", true}}, [](const LspJson&) {});
        show(message_of_information, told);
      });
}

// ---- commands

/// Keeps a command until work() executes it.
///   throws  LspFault if the command cannot be executed
void LanguageServer::execute_command(const LspJson& id, const LspJson& params) {
  Waiting waiting{id, text_in(params, "command"), {}, {}};
  const bool converts = waiting.command == convert_command;
  if (!converts && waiting.command != renumber_command)
    throw LspFault{LspFault::invalid_params, translated(texts::lsp::no_such_command, waiting.command)};
  const LspJson& arguments = member(params, "arguments");
  const bool are_texts = arguments.is_array() && arguments.size() == (converts ? 2 : 1) &&
                         std::all_of(arguments.begin(), arguments.end(), [](const LspJson& one) { return one.is_string(); });
  if (!are_texts) throw LspFault{LspFault::invalid_params, translated(texts::lsp::wrong_member, "arguments")};
  waiting.uri = arguments[0];
  if (converts) waiting.argument = arguments[1];
  (void)document_of({{"textDocument", {{"uri", waiting.uri}}}});
  if (!editor_.applies_edits || (converts && !editor_.creates_files) || commands_.size() == most_waiting)
    throw LspFault{LspFault::request_failed, translated(texts::lsp::cannot_apply)};
  commands_.push_back(std::move(waiting));
}

void LanguageServer::work_on_command(const StopToken& stop) {
  const Waiting waiting = commands_.front();
  const auto is_open = [&](const std::string& path) { return documents_.count(uri_of_path(path)) != 0; };
  try {
    const OpenDocument& document = document_of({{"textDocument", {{"uri", waiting.uri}}}});
    const auto outcome = waiting.command == convert_command ? converted_document(document, waiting.argument, is_open, stop)
                                                            : renumbered_document(document, editor_, stop);
    if (!outcome) return;
    commands_.pop_front();
    apply(*outcome);
    answer(waiting.id, "result", nullptr);
  } catch (const LspFault& fault) {
    commands_.pop_front();
    refuse(waiting.id, fault.code, fault.text);
  }
}

/// Removes a command that waits.
LspJson LanguageServer::cancel(const LspJson& params) {
  const LspJson& id = member(params, "id");
  const auto found = std::find_if(commands_.begin(), commands_.end(), [&](const Waiting& one) { return one.id == id; });
  if (found == commands_.end()) return nullptr;  // it has been answered
  const LspJson cancelled = found->id;
  commands_.erase(found);
  refuse_cancelled(cancelled);
  return nullptr;
}

// ---- code actions

LspJson LanguageServer::actions(const LspJson& params) {
  const OpenDocument& document = document_of(params);
  const TextRange range = range_in(member(params, "range"));
  const auto context = params.find("context");
  LspJson only;
  bool automatic = false;  // the editor asks because the cursor has moved, not the user
  if (context != params.end() && context->is_object()) {
    constexpr int triggered_automatically = 2;  // LSP 3.17, "CodeActionTriggerKind"
    only = context->value("only", LspJson());
    automatic = context->value("triggerKind", LspJson()) == triggered_automatically;
  }
  // Kinds are a hierarchy: who asks for "refactor" gets "refactor.rewrite".
  const auto wanted = [&](const std::string& kind) {
    return !only.is_array() || std::any_of(only.begin(), only.end(), [&](const LspJson& one) {
      const std::string name = one.is_string() ? one.get<std::string>() : "?";
      return name.empty() || kind == name || kind.starts_with(name + '.');
    });
  };
  LspJson all = wanted("quickfix") && editor_.code_actions ? actions_json(document, range) : LspJson::array();
  if (automatic && !only.is_array()) return all;
  for (LspJson& one : command_actions_json(document, editor_, [&](const char* kind) { return wanted(kind); }))
    all.push_back(std::move(one));
  return all;
}

}  // namespace kadr
