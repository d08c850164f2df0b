// Commands that convert a program or number its blocks. Used by lsp/language_server; tested by tests/lsp.py.

#include "lsp/proven_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compare/comparison_text.h"
#include "config/control/control_file.h"
#include "config/texts.h"
#include "convert/conversion_text.h"
#include "texts/convert_command.h"
#include "texts/edit_command.h"
#include "texts/lsp.h"
#include "texts/page.h"
#include "view/proven_text.h"

namespace kadr {
namespace {

constexpr std::size_t max_names = 1000;  // names that are tried for a new file

[[noreturn]] void refuse(std::string why) { throw LspFault{LspFault::request_failed, std::move(why)}; }

/// Returns the program of a document; a fault if it has no control, or if it is too long to wait for.
const OpenedProgram& program_of(const OpenDocument& document) {
  if (document.opened() == nullptr) refuse(document.no_control());
  if (document.text().text().size() > max_proven_text) refuse(translated(texts::page::too_long_to_convert));
  return *document.opened();
}

std::string with_line_feeds(std::string_view text) {
  std::string lines;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool is_break = text[at] == '\r';
    lines += is_break ? '\n' : text[at];
    if (is_break && at + 1 < text.size() && text[at + 1] == '\n') ++at;
  }
  return lines;
}

/// Returns a path next to the program that no file has.
std::string new_path(const std::string& path, const std::string& control, const std::function<bool(const std::string&)>& taken) {
  const std::filesystem::path file(path);
  const std::string base = std::filesystem::path(file).replace_extension().string() + '-' + control;
  for (std::size_t n = 1; n < max_names; ++n) {
    std::string name = base + (n == 1 ? "" : fmt::format("-{}", n)) + ".nc";
    std::error_code none;
    if (!taken(name) && !std::filesystem::exists(name, none)) return name;
  }
  refuse(translated(texts::lsp::no_free_name, base));
}

/// Returns the reasons why a program was not converted, a line for each method.
std::string reasons_of(const Converted& made, const ConversionSides& sides) {
  std::string text = nothing_proven();
  std::string last;
  for (const ConversionTry& one : made.tries) {
    const ConversionRefusal why = refusal_of(one, sides);
    std::string reason = why.at.line == 0 ? why.text : fmt::format("{}: {}", translated(texts::lsp::in_line, why.at.line), why.text);
    if (!why.file.empty()) reason = why.file + ": " + reason;
    if (reason != last) text += fmt::format("\n{}: {}", method_in_words(one.as), reason);
    last = std::move(reason);
  }
  return text;
}

/// Returns the edits that make one text of the other. Numbered blocks stay in their lines, so that only these lines are replaced.
LspJson line_edits(const TextDocument& before, const TextDocument& after) {
  LspJson edits = LspJson::array();
  if (before.lines() != after.lines()) {
    const auto last = before.range_of_line(before.lines() - 1).end;
    edits.push_back({{"range", range_json({{0, 0}, last})}, {"newText", after.text()}});
    return edits;
  }
  for (std::size_t n = 0; n < before.lines(); ++n)
    if (before.line(n) != after.line(n))
      edits.push_back({{"range", range_json(before.range_of_line(n))}, {"newText", std::string(after.line(n))}});
  return edits;
}

LspJson action_json(const EditorAbilities& editor, const std::string& title, const char* kind, const char* command, LspJson arguments) {
  LspJson run = {{"title", title}, {"command", command}, {"arguments", std::move(arguments)}};
  if (!editor.code_actions) return run;
  return {{"title", title}, {"kind", kind}, {"command", std::move(run)}};
}

}  // namespace

LspJson command_actions_json(const OpenDocument& document, const EditorAbilities& editor, const std::function<bool(const char*)>& wanted) {
  constexpr const char* kind_of_renumbering = "refactor.rewrite.renumber";
  constexpr const char* kind_of_conversion = "refactor.rewrite.convert";
  LspJson all = LspJson::array();
  if (document.opened() == nullptr || !editor.applies_edits) return all;
  if (wanted(kind_of_renumbering))
    all.push_back(action_json(editor, translated(texts::lsp::renumber), kind_of_renumbering, renumber_command, {document.uri}));
  if (!editor.creates_files || !path_of_uri(document.uri) || !wanted(kind_of_conversion)) return all;
  static const std::vector<std::string> controls = built_in_controls();
  for (const std::string& control : controls)
    if (control != document.opened()->def->id)
      all.push_back(
          action_json(editor, translated(texts::lsp::convert_to, control), kind_of_conversion, convert_command, {document.uri, control}));
  return all;
}

std::optional<CommandOutcome> converted_document(const OpenDocument& document, const std::string& to,
                                                 const std::function<bool(const std::string&)>& taken, const StopToken& stop) {
  OpenedProgram from = program_of(document);
  if (!path_of_uri(document.uri)) refuse(translated(texts::lsp::no_file, document.uri));
  auto control = load_control(to);
  if (!control) refuse(control.error());
  const auto target = std::make_shared<const ControlDef>(std::move(*control));
  const std::string text = with_line_feeds(document.text().text());
  from.text = text;
  const auto made = converted_program(from, target, text, false, stop);
  if (stop.requested()) return std::nullopt;
  if (!made) refuse(made.error());
  const auto of_target = AlarmTexts::load(target.get());
  if (!of_target) refuse(of_target.error());
  if (!made->taken) refuse(reasons_of(*made, {*from.def, *from.texts, *of_target}));
  const ConversionTry& one = made->tries[*made->taken];
  const std::string path = new_path(document.path, target->id, taken);
  CommandOutcome outcome;
  outcome.created = uri_of_path(path);
  outcome.label = translated(texts::lsp::convert_to, to);
  outcome.told = summary_of(one.proof, document.lang()) + '\n' + translated(texts::convert_command::written_as, method_in_words(one.as));
  for (const std::string& note : notes_on(*made, one)) outcome.told += '\n' + note;
  const LspJson whole = {{"range", range_json({})}, {"newText", whole_text(*one.text)}};
  outcome.edit = {{"documentChanges",
                   {{{"kind", "create"}, {"uri", outcome.created}},
                    {{"textDocument", {{"uri", outcome.created}, {"version", nullptr}}}, {"edits", LspJson::array({whole})}}}}};
  return outcome;
}

std::optional<CommandOutcome> renumbered_document(const OpenDocument& document, const EditorAbilities& editor, const StopToken& stop) {
  const OpenedProgram& opened = program_of(document);
  Edits edits;
  edits.numbering = Numbering();
  const auto made = edited_program(opened, document.text().text(), std::move(edits), stop);
  if (stop.requested()) return std::nullopt;
  if (!made) {
    const std::string why = translated(texts::edit_command::not_edited, made.error().why);
    refuse(made.error().line == 0 ? why : fmt::format("{}: {}", translated(texts::lsp::in_line, made.error().line), why));
  }
  if (!made->proof.is_proven()) {
    std::string text;
    for (const EditReason& reason : edit_reasons(made->proof.comparison, opened, document.lang()))
      text += (text.empty() ? "" : "\n") +
              (reason.line == 0 ? reason.text : fmt::format("{}: {}", translated(texts::lsp::in_line, reason.line), reason.text));
    refuse(text);
  }
  CommandOutcome outcome;
  outcome.label = translated(texts::lsp::renumber);
  const LspJson list = line_edits(document.text(), TextDocument(whole_text(*made->text), ColumnUnit::utf8));
  outcome.told = list.empty()
                     ? translated(texts::edit_command::nothing_changes)
                     : translated(texts::edit_command::proven, summary_of(made->proof.comparison, document.lang()), made->proof.states);
  if (made->changes.not_executed > 0) outcome.told += '\n' + counted(texts::edit_command::not_executed, made->changes.not_executed);
  if (list.empty()) return outcome;
  if (!editor.versioned_edits) outcome.edit = {{"changes", {{document.uri, list}}}};
  else
    outcome.edit = {
        {"documentChanges", LspJson::array({{{"textDocument", {{"uri", document.uri}, {"version", document.version}}}, {"edits", list}}})}};
  return outcome;
}

}  // namespace kadr
