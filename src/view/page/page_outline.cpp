// Answers the request `outline`: the structure of the program. Used by view/page/page_session; tested by tests/serve_outline.py.

#include "texts/lsp.h"
#include "view/page/page_inside.h"
#include "view/structure/outline.h"

namespace kadr {
namespace {

constexpr std::uint32_t lines_at_once = 4096;  // lines of the source that are read at once

/// Calls `take` with each line of the text, from 0, as editors divide it: at LF, CR LF and CR. Returns how many there are; a line break at
/// the end begins no line.
template <class Take>
std::size_t each_line(std::string_view text, const Take& take) {
  std::size_t number = 0;
  for (std::size_t from = 0; from < text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", from), text.size());
    take(number, text.substr(from, end - from));
    from = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
  }
  return number;
}

/// Returns what a cycle does, without the block that the name of the entry states already: "CYCL DEF 200: drilling".
std::string without_block(const std::string& meaning) {
  const std::size_t colon = meaning.find(": ");
  return meaning.starts_with("CYCL DEF ") && colon != std::string::npos ? meaning.substr(colon + 2) : meaning;
}

struct OutlineJson {
  const ControlDef& def;
  Lang lang;
  PageJson entries = PageJson::array();

  void add(const std::vector<OutlineEntry>& all, int depth) {
    for (const OutlineEntry& one : all) {
      const std::string name = one.name.empty() ? translated_in(lang, texts::lsp::main_program) : one.name;
      PageJson entry = {{"kind", name_of(one.kind)}, {"name", name}, {"line", one.first + 1}, {"last", one.last + 1}, {"depth", depth}};
      if (const Text* const meaning = meaning_of(def, one)) entry["title"] = without_block(lang == Lang::ru ? meaning->ru : meaning->en);
      entries.push_back(std::move(entry));
      add(one.inside, depth + 1);
    }
  }
};

}  // namespace

/// Returns the outline of the text of the request, or of the program that is open.
PageSession::Inside::Answer PageSession::Inside::outline(const PageJson& question) {
  const ControlDef& def = *run->opened().def;
  const StopToken stop = token();
  Outliner outliner(def);
  const auto take = [&](std::size_t number, std::string_view text) {
    if (!outliner.full() && !stop.requested()) outliner.take(number, names_of_line(def, text));
  };
  std::size_t lines = 0;
  if (question.contains("text")) {
    lines = each_line(value_in<std::string>(question, "text", ""), take);
  } else {
    for (bool more = true; more && !outliner.full() && !stop.requested();) {
      const std::vector<std::string> read = source->from(std::uint32_t(lines + 1), lines_at_once);
      for (const std::string& one : read) take(lines++, one);
      more = read.size() == lines_at_once;
    }
    lines = source->lines();
  }
  OutlineJson json{def, lang};
  json.add(outliner.finish(lines), 0);
  return PageJson{{"entries", std::move(json.entries)}, {"more", outliner.full()}};
}

}  // namespace kadr
