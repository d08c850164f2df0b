// Answers the request `edit_program`: edits a program in one respect, and proves that nothing else has changed. The new text is not saved
// here; the page puts it into its editor if the user takes it over. Used by view/page/page_session; tested by tests/serve_edit.py.

#include <algorithm>

#include "compare/comparison_text.h"
#include "edit/editing.h"
#include "out/text/alarm_print.h"
#include "texts/edit.h"
#include "texts/edit_command.h"
#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t max_edited = std::size_t{8} << 20;  // greatest size of a program, bytes
constexpr std::size_t max_reasons = 20;                   // greatest number of reasons that the answer lists

/// Reads `edits`: {"feed": ["T3=80%"], "mirror": "X"}, by the names of the options of kadr edit.
///   returns  an error sentence if a name or a word is wrong
tl::expected<Edits, std::string> edits_in(const PageJson& question) {
  const auto found = question.find("edits");
  if (found == question.end() || !found->is_object() || found->empty())
    return tl::unexpected(translated(texts::edit_command::nothing_asked));
  Edits edits;
  for (const auto& [name, value] : found->items()) {
    const PageJson words = value.is_array() ? value : PageJson::array({value});
    for (const PageJson& word : words) {
      if (!word.is_string()) return tl::unexpected(translated(texts::edit::no_such_edit, name, dumped(word)));
      if (auto status = add_edit(edits, name, word.get<std::string>()); !status) return tl::unexpected(status.error());
    }
  }
  if (places_edited(edits) > 1) return tl::unexpected(translated(texts::edit_command::one_at_a_time));
  return edits;
}

PageJson reason_json(std::string text, std::uint32_t line) { return {{"text", std::move(text)}, {"line", line}}; }

/// Returns why the edit is refused: the alarm that stops the program, or the differences that nobody asked for.
PageJson reasons_json(const Comparison& proof, const OpenedProgram& opened, Lang lang) {
  PageJson list = PageJson::array();
  const auto add_alarm = [&](const AlarmReport& report) {
    list.push_back(reason_json(finding_of(report, *opened.texts, lang).text, report.origin.file == 0 ? report.origin.line : 0));
  };
  if (proof.stopped_a) {
    list.push_back(reason_json(translated(texts::edit_command::program_stops), 0));
    add_alarm(*proof.stopped_a);
    return list;
  }
  list.push_back(reason_json(translated(texts::edit_command::not_proven), 0));
  for (std::size_t i = 0; i < std::min(max_reasons, proof.differences.size()); ++i) {
    const CourseDifference& d = proof.differences[i];
    list.push_back(reason_json(sentence_of(d, lang), d.a.file.empty() ? d.a.origin.line : 0));
  }
  if (proof.stopped_b) add_alarm(*proof.stopped_b);
  return list;
}

/// Opens the sessions of a proof: of the program itself, and of another text under the same control.
struct EditSides {
  const OpenedProgram& opened;
  StopToken stop;
  using Side = tl::expected<std::unique_ptr<Session>, std::string>;

  Side of(tl::expected<Program, std::string> program, const Setup& setup) const {
    if (!program) return tl::unexpected(program.error());
    SessionSpec spec = opened.spec(std::move(*program), stop);
    spec.setup = setup;
    auto session = Session::open(std::move(spec));
    if (!session)
      return tl::unexpected(session.error().fault.key + ": " + in_thread_language(session.error().fault.en, session.error().fault.ru));
    return std::move(*session);
  }
};

}  // namespace

/// Edits the program that the request names; this page need not have opened it. A page can therefore edit on a separate connection, so that
/// its other requests need not wait.
PageSession::Inside::Answer PageSession::Inside::edit_program(const PageJson& question) {
  auto edits = edits_in(question);
  if (!edits) return refused(edits.error());
  const auto request = opening_request_in(question);
  if (!request) return tl::unexpected(request.error());
  const auto opened = open_for_page(*request);
  if (!opened) return refused(opened.error());
  const SourceText old(opened->text ? OpenedText{text_source(*opened->text), Encoding::utf8}
                                    : open_text(request->path, opened->encoding, &server.folder));
  if (old.bytes() > max_edited) return refused(translated(texts::page::too_long_to_convert));
  const std::string text = old.whole();
  const EditSides sides{*opened, token()};
  EditSpec spec;
  spec.old_program = [&](const Setup& setup) { return sides.of(opened->program_of(text), setup); };
  spec.new_program = [&](std::shared_ptr<ByteSource> made, const Setup& setup) {
    return sides.of(opened->program_of({shared_source(std::move(made)), Encoding::utf8}), setup);
  };
  spec.source_text = text_source(text);
  spec.setup = opened->setup;
  spec.edits = std::move(*edits);
  spec.stop = token();
  const auto made = edited(spec, {text_source(text), Encoding::utf8, opened->def.get()});
  if (stops) return refused(translated(texts::page::interrupted));
  PageJson json = {{"text", ""}, {"lines", 0}, {"told", ""}, {"note", ""}, {"refused", PageJson::array()}};
  if (!made) {
    json["refused"].push_back(reason_json(made.error().why, made.error().line));
    return json;
  }
  if (!made->proof.is_proven()) {
    json["refused"] = reasons_json(made->proof.comparison, *opened, lang);
    return json;
  }
  json["text"] = whole_text(*made->text);
  json["lines"] = made->changes.lines;
  json["told"] = translated(texts::edit_command::proven, summary_of(made->proof.comparison, lang), made->proof.states);
  if (made->changes.not_executed > 0) json["note"] = counted(texts::edit_command::not_executed, made->changes.not_executed);
  return json;
}

}  // namespace kadr
