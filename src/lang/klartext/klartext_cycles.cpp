// Reads definitions of cycles, GLOBAL DEF and TCH PROBE. Used by lang/klartext; tested by tests/lang/klartext_test.cpp.

#include "lang/klartext/klartext_cycles.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kadr {

/// CYCL DEF 7.1 X+60, CYCL DEF 200 NAME ~ Q200=2 … (spec/heidenhain 12.1).
Status KlartextCycles::cycle() {
  block_.kind = KlartextKind::cycle_definition;
  skip();
  std::uint32_t number = 0;
  const std::size_t begin = at_;
  for (; is_digit(peek()) && number < 10'000; ++at_) number = number * 10 + static_cast<std::uint32_t>(peek() - '0');
  if (at_ == begin) return syntax();
  block_.number = static_cast<std::uint16_t>(number);
  skip();
  if (peek() == '.' && is_digit(peek(1))) {
    ++at_;
    block_.part = 0;
    for (; is_digit(peek()) && block_.part < 100; ++at_) block_.part = static_cast<std::int16_t>(block_.part * 10 + (peek() - '0'));
    std::string_view rest = text_.substr(at_);
    block_.text = std::string(rest.substr(0, rest.find(';')));
    return block_.part == 0 ? Status() : cycle_line();
  }
  while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '~' && text_[at_] != ';') {
    if (at_parameter() && is_assignment()) break;
    ++at_;
  }
  return cycle_parameters();
}

bool KlartextCycles::is_assignment() const {
  std::size_t look = 1;
  while (is_digit(peek(look)) || peek(look) == ' ') ++look;
  return peek(look) == '=';
}

/// The numbers of a line of an old cycle: axes where it has them, else the last number of the line (spec/heidenhain 12.1).
Status KlartextCycles::cycle_line() {
  constexpr std::uint16_t by_axes[] = {7, 8, 10, 11, 19, 26, 32, 247};
  if (std::find(std::begin(by_axes), std::end(by_axes), block_.number) != std::end(by_axes)) return axis_words();
  return {};
}

Status KlartextCycles::axis_words() {
  constexpr std::string_view names[] = {"IX",  "IY",   "IZ",  "IA",  "IB",   "IC",   "IU",        "IV", "IW", "CCX",   "CCY",
                                        "CCZ", "IROT", "ROT", "SCL", "ABST", "DIST", "HSC-MODE:", "TA", "X",  "Y",     "Z",
                                        "A",   "B",    "C",   "U",   "V",    "W",    "T",         "F",  "#",  "ANGLE:"};
  while (!at_end()) {
    std::string_view best;
    for (const std::string_view each : names)
      if (each.size() > best.size() && looks_like(each)) best = each;
    if (best.empty()) return {};  // a text in the language of the control
    const std::size_t begin = at_;
    at_ += best.size();
    KlartextWord word;
    word.incremental = best.size() > 1 && best[0] == 'I';
    word.name = word_name(word.incremental ? best.substr(1) : best);
    const auto read = value(word.number, word.value);
    if (!read) return fail(read.error());
    word.bare = !*read;
    word.where = span(begin, at_);
    block_.words.push_back(std::move(word));
  }
  return {};
}

Status KlartextCycles::cycle_parameters() {
  while (!at_end()) {
    const std::size_t begin = at_;
    auto step = parameter();
    if (!step) return fail(step.error());
    if (!take("=")) return syntax();
    KlartextWord word;
    word.name = step->index;
    skip();
    if (take_prefix("FU")) word.text = "FU";
    if (take_prefix("FZ")) word.text = "FZ";
    if (take("MAX")) word.text = "MAX";
    else if (take("AUTO")) word.text = "AUTO";
    else if (take("PREDEF")) word.text = "PREDEF";
    else if (peek() == '"') {
      auto text = quoted();
      if (!text) return fail(text.error());
      word.text = "\"";
    } else {
      const auto read = value(word.number, word.value);
      if (!read) return fail(read.error());
      if (!*read) return syntax();
    }
    word.where = span(begin, at_);
    block_.words.push_back(std::move(word));
    if (block_.words.size() > 200) return fail(alarm(AlarmId::too_many_words, word.where, 200.0));
  }
  return {};
}

/// GLOBAL DEF 100 GENERAL ~ Q200=2 …: values that the word PREDEF of a definition takes (spec/heidenhain 12.1).
Status KlartextCycles::global_definition() {
  KADR_TRY(cycle());
  if (block_.part >= 0) return syntax();
  block_.part = KlartextBlock::global_definition;
  return {};
}

/// TCH PROBE 0.0 REF. PLANE Q5 X-, TCH PROBE 0.1 X+5 Y+0 Z-5, TCH PROBE 417 … ~ Q263=… (spec/heidenhain 12.14).
Status KlartextCycles::probe() {
  KADR_TRY(cycle());
  block_.kind = KlartextKind::probe;
  if (block_.part < 0) return {};
  block_.words.clear();
  if (block_.part > 0) return axis_words();
  if (block_.number != 0) return {};
  // The title is of any language; behind it are the parameter of the result, the axis and the direction.
  while (at_ < text_.size() && !(at_parameter() && static_cast<unsigned char>(text_[at_ - 1]) <= ' ')) ++at_;
  if (at_ >= text_.size()) return syntax();
  const auto step = parameter();
  if (!step) return fail(step.error());
  block_.target = *step;
  skip();
  const char axis = peek();
  ++at_;
  skip();
  const char sign = peek();
  if (std::string_view("XYZ").find(axis) == std::string_view::npos || (sign != '+' && sign != '-')) return syntax();
  ++at_;
  block_.name = {axis, sign};
  return {};
}

}  // namespace kadr
