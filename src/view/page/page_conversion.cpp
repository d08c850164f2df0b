// Answers the request `convert`: converts a program for another control, and verifies that the result is equivalent. The result is not
// saved here; the page saves it if the user requests that. Used by view/page/page_session; tested by tests/serve_convert.py.

#include <fmt/format.h>

#include <filesystem>

#include "compare/comparison_text.h"
#include "config/control/control_file.h"
#include "convert/conversion_text.h"
#include "lang/text/text_spool.h"
#include "texts/page.h"
#include "view/page/page_inside.h"
#include "view/proven_text.h"

namespace kadr {

/// The two controls of a conversion.
struct PageConversion {
  OpenedProgram from;
  std::shared_ptr<const ControlDef> to;
};

namespace {

constexpr std::size_t max_written_out = 1000;  // greatest number of rewritten lines or groups of lines that the answer lists
constexpr std::size_t most_line = 200;         // greatest length in bytes of a program line that a message quotes

tl::unexpected<Refusal> not_converted(std::string text) { return tl::unexpected(Refusal{std::move(text)}); }

/// Checks that the known keys of the request have values of the right type. A wrong value must not be ignored, because the program will run
/// on a machine.
///   returns  an error sentence; empty if the request is valid
std::string fault_of_request(const PageJson& question) {
  struct Word {
    const char* key;
    bool (PageJson::*is_right)() const noexcept;
  };
  static constexpr Word words[] = {
      {"file", &PageJson::is_string},   {"control", &PageJson::is_string}, {"machine", &PageJson::is_string},
      {"setup", &PageJson::is_string},  {"text", &PageJson::is_string},    {"encoding", &PageJson::is_string},
      {"tables", &PageJson::is_object}, {"to", &PageJson::is_string},      {"flat", &PageJson::is_boolean},
      {"force", &PageJson::is_boolean},
  };
  for (const Word& word : words)
    if (question.contains(word.key) && !(question[word.key].*word.is_right)())
      return translated(texts::page::convert_not_understood, word.key);
  return {};
}

std::string clipped(std::string line) {
  if (line.size() <= most_line) return line;
  std::size_t end = most_line;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
  return line.substr(0, end) + "…";
}

std::string line_of_text(std::string_view text, std::uint32_t line) {
  for (std::uint32_t i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n');
    if (end == text.npos) return {};
    text.remove_prefix(end + 1);
  }
  return clipped(std::string(text.substr(0, text.find('\n'))));
}

std::string too_long_for_the_page() { return translated(texts::page::too_long_to_convert); }

PageJson refusal_json(const ConversionTry& one, const ConversionRefusal& why, const SourceText& source, const ServedFolder& folder) {
  std::vector<std::string> line = why.at.file == 0 && why.at.line > 0 ? source.from(why.at.line, 1) : std::vector<std::string>();
  return {{"as", name_of(one.as)},
          {"way", method_in_words(one.as)},
          {"text", why.text},
          {"line", why.at.line},
          {"file", why.at.file},
          {"file_name", why.file.empty() ? std::string() : folder.shown(why.file)},
          {"line_text", line.empty() ? std::string() : clipped(std::move(line.front()))},
          {"written_line", why.written_line},
          {"written_text", why.written_line == 0 ? std::string() : line_of_text(whole_text(*one.text), why.written_line)}};
}

/// Returns the file name for the result, such as "flange-mach3.nc" for "flange.nc".
std::string name_for(const std::string& file, const ControlDef& to) {
  return fmt::format("{}-{}.nc", std::filesystem::path(file).replace_extension().string(), to.id);
}

/// Returns the lines that were rewritten as a whole, in a conversion that otherwise replaces only words.
PageJson written_out_json(const ConversionTry& one, const ConversionSides& sides) {
  PageJson list = PageJson::array();
  for (const WrittenOut& out : one.written_out) {
    if (list.size() == max_written_out) break;
    list.push_back({{"from", out.lines.first}, {"to", out.lines.last}, {"text", why_written_out(out, sides)}});
  }
  return list;
}

PageJson written_json(const ConversionTry& one, bool is_proven, const Setup& setup, std::string name) {
  return {{"proven", is_proven},
          {"as", name_of(one.as)},
          {"way", method_in_words(one.as)},
          {"program", (is_proven ? std::string() : unproven_mark()) + whole_text(*one.text)},
          {"setup", setup_text(setup)},
          {"name", std::move(name)}};
}

}  // namespace

/// Converts the program that the request names; this page need not have opened the program. A page can therefore convert on a separate
/// connection, so that its other requests need not wait.
PageSession::Inside::Answer PageSession::Inside::convert(const PageJson& question) {
  if (const std::string fault = fault_of_request(question); !fault.empty()) return not_converted(fault);
  const auto request = opening_request_in(question);
  if (!request) return tl::unexpected(request.error());
  std::string name;
  if (const std::string fault = place_of(question, "to", name, true); !fault.empty()) return not_converted(fault);
  if (name.empty()) return not_converted(translated(texts::page::convert_names_no_control));
  auto to = load_control(name, &server.folder);
  if (!to) return not_converted(to.error());
  const auto opened = open_for_page(*request);
  if (!opened) return not_converted(opened.error());
  const SourceText text(opened->text ? OpenedText{text_source(*opened->text), Encoding::utf8}
                                     : open_text(request->path, opened->encoding, &server.folder));
  if (text.bytes() > max_proven_text) return not_converted(too_long_for_the_page());
  const PageConversion conversion{*opened, std::make_shared<const ControlDef>(std::move(*to))};
  const auto made = converted_program(conversion.from, conversion.to, text.whole(), question.value("flat", false), token());
  if (stops) return not_converted(translated(texts::page::interrupted));
  if (!made) return not_converted(made.error());
  return conversion_answer(conversion, *made, text, question);
}

PageSession::Inside::Answer PageSession::Inside::conversion_answer(const PageConversion& conversion, const Converted& made,
                                                                   const SourceText& text, const PageJson& question) const {
  const auto of_target = AlarmTexts::load(conversion.to.get());
  if (!of_target) return not_converted(of_target.error());
  const ConversionSides sides{*conversion.from.def, *conversion.from.texts, *of_target};
  PageJson tries = PageJson::array();
  for (std::size_t i = 0; i < made.tries.size(); ++i)
    if (i != made.taken) tries.push_back(refusal_json(made.tries[i], refusal_of(made.tries[i], sides), text, server.folder));
  const auto taken = made.taken || !question.value("force", false) ? made.taken : best_unproven(made);
  PageJson written;
  if (taken) {
    const ConversionTry& one = made.tries[*taken];
    if (one.text->size() > max_proven_text) return not_converted(too_long_for_the_page());
    const std::string name = name_for(value_in<std::string>(question, "file", ""), *conversion.to);
    written = written_json(one, made.taken.has_value(), made.setup_of(one.as), free_name(name, ".nc"));
    written["note"] = made.taken ? fmt::format("{}", fmt::join(notes_on(made, one), "; ")) : std::string();
    written["written_out"] = written_out_json(one, sides);
  }
  return PageJson{{"text", made.taken ? summary_of(made.tries[*made.taken].proof, lang) : nothing_proven()},
                  {"tolerance", made.tolerance},
                  {"written", std::move(written)},
                  {"tries", std::move(tries)}};
}

}  // namespace kadr
