// BlockMaker: writes blocks of one control. Used by convert/flat/flat_program; tested by tests/convert.

#include "convert/block_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kadr {

Alarm too_long() {
  constexpr int in_mb = 20;  // shift by this many bits converts bytes to MB
  return alarm(AlarmId::conversion_too_long, {}, double(max_made >> in_mb));
}

void BlockMaker::begin() {
  if (def_.grammar.program_start_required || def_.grammar.percent_number || def_.grammar.percent_frames) (void)put_("%\n");
}

void BlockMaker::close() {
  if (def_.grammar.percent_frames) (void)put_("%\n");
}

std::string BlockMaker::program_label(std::uint32_t number) const { return fmt::format("O{:0{}}", number, def_.behaviour.program_digits); }

Status BlockMaker::code(std::initializer_list<FunctionArg> functions) {
  if (!code_if_there(functions)) return fail(alarm(AlarmId::function_has_no_code, {}, traits_of(functions.begin()->first).name));
  return {};
}

bool BlockMaker::code_if_there(std::initializer_list<FunctionArg> functions) {
  const auto code = code_of(def_, functions);
  if (code) text(*code);
  return code.has_value();
}

Status BlockMaker::word(char letter, double value, int more) {
  const auto& codes = letter == 'F' ? def_.feed_codes : def_.speed_codes;
  if ((letter == 'F' || letter == 'S') && !codes.empty()) {
    const auto coded = code_below(codes, value);
    if (!coded) return fail(alarm(AlarmId::word_has_no_room, {}, letter, value));
    value = *coded;
  }
  // Additional decimals of a feed, down to 0.000001 mm/min, if the word format allows any number of decimals
  constexpr int more_of_feed = 3;
  const Words form(def_, letter, letter == 'F' ? more + more_of_feed : more);
  if (letter == 'F' && value > 0 && form.rounded(value) == 0)
    return fail(alarm(AlarmId::word_below_format, {}, letter, value, form.increment()));
  return word(form, value);
}

Status BlockMaker::word(const Words& form, double value) {
  const std::size_t size = words_.size();
  if (size != 0) words_ += ' ';
  if (form.append(words_, value)) return {};
  words_.resize(size);
  return fail(alarm(AlarmId::word_has_no_room, {}, form.letter(), value));
}

Status BlockMaker::seconds_word(char letter, double seconds) {
  constexpr double in_ms = 1000;
  if (letter != 'P' || def_.behaviour.dwell_unit == DwellUnit::seconds) return word(letter, seconds);
  text(fmt::format("P{:.0f}", in_ms * seconds));
  return {};
}

Status BlockMaker::dwell_word(const CodeRow& row, double seconds) {
  for (const char letter : {'P', 'E', 'X', 'F'})
    if ((row.takes >> (letter - 'A') & 1U) != 0) return seconds_word(letter, seconds);
  return fail(alarm(AlarmId::function_has_no_code, {}, traits_of(row.function).name));
}

bool BlockMaker::is_full_of_codes(char letter) const {
  const std::uint32_t most = def_.grammar.word(letter).at_most;
  std::uint32_t count = 0;
  for (std::size_t at = 0; at < words_.size();) {
    if (words_[at] != 'G' && words_[at] != 'M') return false;
    if (words_[at] == letter) ++count;
    at = std::min(words_.find(' ', at), words_.size() - 1) + 1;
  }
  return most != 0 && count >= most;
}

Status BlockMaker::code_text(std::string_view code) {
  if (skip_ == 0 && is_full_of_codes(code.front())) {
    std::string comment = std::exchange(comment_, {});
    KADR_TRY(end());
    comment_ = std::move(comment);
  }
  text(code);
  return {};
}

void BlockMaker::text(std::string_view word) {
  if (!words_.empty()) words_ += ' ';
  words_ += word;
}

void BlockMaker::comment(std::string_view what) {
  std::string clean;
  for (const char c : what)
    if (c != '(' && c != ')' && c != '\n' && c != '\r' && def_.grammar.comment_forbidden.find(c) == std::string::npos) clean += c;
  if (clean.find_first_not_of(' ') == std::string::npos) return;
  // In a block with names, ( and ) enclose arguments, so a comment goes from ; to the end of the line (spec/sinumerik 2).
  const bool by_semicolon = def_.grammar.named_blocks || def_.grammar.klartext_blocks;
  if (!comment_.empty()) comment_ += ' ';
  else if (by_semicolon) comment_ = "; ";
  comment_ += by_semicolon ? clean : '(' + clean + ')';
}

Status BlockMaker::number(std::string& line) {
  const WordFormat& n = def_.grammar.word('N');
  if (requested_number_ == 0 && !def_.grammar.block_number_required) return {};
  if (def_.grammar.klartext_blocks) return {};  // the control numbers the blocks itself (spec/heidenhain 1.2)
  const double most = n.whole_digits == 0 ? 99'999 : std::pow(10.0, n.whole_digits) - 1;
  std::uint32_t number = section_ != 0 ? 0 : requested_number_;
  if (def_.grammar.block_number_required) number = number > last_number_ ? number : last_number_ + 1;
  if (number == 0 || !n.known) return {};
  if (section_ != 0 && number / section_blocks != section_) return fail(alarm(AlarmId::word_has_no_room, {}, 'N', double(number)));
  if (number > most) return def_.grammar.block_number_required ? fail(alarm(AlarmId::word_has_no_room, {}, 'N', double(number))) : Status();
  last_number_ = number;
  line += fmt::format("N{:0{}} ", number, n.drop_zeros && section_ == 0 ? 1 : n.whole_digits);
  return {};
}

Status BlockMaker::end() {
  if (empty()) return {};
  line_.clear();
  if (skip_ != 0) line_ = skip_ == 1 || !def_.grammar.skip_levels ? "/" : fmt::format("/{}", skip_);
  if (!words_.empty()) KADR_TRY(number(line_));
  line_ += words_;
  if (!comment_.empty()) line_ += (words_.empty() ? "" : " ") + comment_;
  line_ += '\n';
  const bool has_room = put_(line_);
  words_.clear(), comment_.clear();
  requested_number_ = 0, skip_ = 0;
  ++blocks_;
  return has_room ? Status() : fail(too_long());
}

}  // namespace kadr
