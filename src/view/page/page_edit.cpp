// Answers the request `edit_program`: edits a program in one respect, and proves that nothing else has changed. The new text is not saved
// here; the page puts it into its editor if the user takes it over. Used by view/page/page_session; tested by tests/serve_edit.py.

#include "compare/comparison_text.h"
#include "texts/edit.h"
#include "texts/edit_command.h"
#include "texts/page.h"
#include "view/page/page_inside.h"
#include "view/proven_text.h"

namespace kadr {
namespace {

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

PageJson reasons_json(const Comparison& proof, const OpenedProgram& opened, Lang lang) {
  PageJson list = PageJson::array();
  for (EditReason& reason : edit_reasons(proof, opened, lang)) list.push_back(reason_json(std::move(reason.text), reason.line));
  return list;
}

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
  if (old.bytes() > max_proven_text) return refused(translated(texts::page::too_long_to_convert));
  const std::string text = old.whole();
  const auto made = edited_program(*opened, text, std::move(*edits), token());
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
