// Answers the requests about punched tape: converts a program of the served folder to the rows of a tape, or a tape to text. The result is
// not saved here; the page saves it if the user requests that. Used by view/page/page_session; tested by tests/serve_making.py.

#include <fmt/core.h>

#include <algorithm>

#include "lang/text/tape_reading.h"
#include "out/text/base64.h"
#include "out/text/tape_text.h"
#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t max_rows = std::size_t{8} << 20;  // greatest number of rows of a tape; so many rows are 21 km long
constexpr std::size_t max_leader = 100'000;
constexpr std::size_t max_faults_reported = 100;

tl::unexpected<Refusal> no_tape(std::string text) { return tl::unexpected(Refusal{std::move(text)}); }

/// Returns the error sentence for a character that the tape code does not have. The sentence states the line and the character.
std::string not_punched(const std::string& file, const std::string& text, Span at, TapeCode code, Lang lang) {
  const auto line = 1 + std::count(text.begin(), text.begin() + std::min<std::ptrdiff_t>(at.begin, std::ssize(text)), '\n');
  return translated_in(lang, texts::page::no_code_on_tape, file, line, text.substr(at.begin, at.end - at.begin), name_for_people(code));
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::tape(const PageJson& question) {
  const std::string task = value_in<std::string>(question, "way", ""), given = value_in<std::string>(question, "code", "");
  const auto code = tape_code_named(given);
  if (question.contains("code") && !code) return no_tape(translated(texts::page::tape_codes));
  if (task == "out") return punch(question, code);
  if (task == "in") return read_punched(value_in<std::string>(question, "file", ""), code);
  return no_tape(translated(texts::page::tape_ways));
}

/// Answers with the rows of a tape, punched with the text of the editor or of the file.
PageSession::Inside::Answer PageSession::Inside::punch(const PageJson& question, std::optional<TapeCode> given) const {
  const std::string file = value_in<std::string>(question, "file", "");
  const auto found = server.folder.read(file, max_rows);
  if (!found) return no_tape(found.error());
  const bool is_edited = question.contains("text") && question["text"].is_string();
  const std::string text = is_edited ? question["text"].get<std::string>() : SourceText(as_text(text_source(found->bytes))).whole();
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return no_tape(translated(texts::page::empty_for_tape, file));
  const TapeCode code = given.value_or(TapeCode::iso);
  constexpr std::uint32_t usual_leader = 100;  // number of blank rows before and after the program
  const std::size_t leader = std::min<std::size_t>(count_in(question, "leader", usual_leader), max_leader);
  const auto rows = encode_tape(text, leader, code);
  if (!rows) return no_tape(not_punched(file, text, rows.error().where, code, lang));
  if (rows->size() > max_rows) return no_tape(translated(texts::page::too_long_for_tape, file));
  return PageJson{{"bytes", base64_of(*rows)}, {"rows", rows->size()}, {"name", free_name(file, ".tape")}};
}

PageSession::Inside::Answer PageSession::Inside::read_punched(const std::string& file, std::optional<TapeCode> given) const {
  const auto found = server.folder.read(file, max_rows);
  if (!found) return no_tape(found.error());
  const TapeReading read = read_tape(found->bytes, given);
  if (!read.looks_like_tape && !given) return no_tape(translated(texts::page::not_a_tape, file));
  PageJson faults = PageJson::array();
  for (std::size_t i = 0; i < std::min(read.faults.size(), max_faults_reported); ++i)
    faults.push_back(fault_in_words(read.faults[i], read.code, lang));
  const bool is_turned = read.orientation != TapeOrientation::right;
  return PageJson{{"text", read.text},
                  {"code", read.code == TapeCode::eia ? "eia" : "iso"},
                  {"lies", is_turned ? translated(texts::page::tape_was, orientation_in_words(read.orientation, lang)) : std::string()},
                  {"faults", std::move(faults)},
                  {"more", read.faults.size() - std::min(read.faults.size(), max_faults_reported)},
                  {"name", free_name(file, ".nc")}};
}

}  // namespace kadr
