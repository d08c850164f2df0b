#pragma once
// Helpers for the tests of `lang`: the grammars of the built-in controls, one block of a text, and a block as one line of text.

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>

#include "config/control/control_file.h"
#include "lang/block/lexer.h"
#include "lang/expression/expression.h"

namespace kadr::test {

inline const Grammar& grammar_of(const std::string& control) {
  static std::map<std::string, Grammar> read;
  const auto found = read.find(control);
  return found != read.end() ? found->second : read.emplace(control, load_control(control).value().grammar).first->second;
}
/// Returns the grammar of the control without required '%' and block numbers, for the words of short samples.
inline Grammar words_of(const std::string& control) {
  Grammar grammar = grammar_of(control);
  grammar.block_number_required = false;
  return grammar;
}

inline std::string number_text(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", number);
  return text;
}

/// Returns each word and its value, such as "G1 X10 Z?"; ? is a value that is known only when the block is executed.
inline std::string shown(const Block& block) {
  std::string text;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    text += (i == 0 ? "" : " ") + std::string(1, w.address) + (w.expression ? "?" : number_text(w.value));
    if (!w.expression && w.second == w.second) text += "/" + number_text(w.second);
  }
  return text;
}

/// Returns the characters of each word, such as "G1|X 10|".
inline std::string places(const Block& block) {
  std::string text;
  for (std::uint32_t i = 0; i < block.word_count; ++i) text += std::string(block.text_of(block.words[i].where)) + "|";
  return text;
}

/// The block of one line; `alarm` is "id: characters".
struct Sample {
  std::string text;
  Block block;
  std::string alarm;
  Lexed lexed;

  Sample(std::string line, const Grammar& grammar, std::size_t from = 0) : text(std::move(line)) {
    const auto result = lex_block(text, from, true, grammar, block);
    if (result) lexed = *result;
    else
      alarm = std::string(name_of(result.error().id)) + ": " +
              text.substr(result.error().where.begin, result.error().where.end - result.error().where.begin);
  }
};

/// The variables of a test: #n is ten times n, and R0 … R9 have the given values.
struct SampleVariables {
  std::map<int, double> parameters;
  bool known(double, double&) const { return false; }
  Result<double> variable(double number, Span) const { return number * 10; }
  Result<double> element(double, double index, Span) const { return index; }
  Result<double> control_value(double number, double, double, Span) const { return number; }
  Result<double> parameter(int index, Span where) const {
    const auto found = parameters.find(index);
    if (found == parameters.end()) return fail(alarm(AlarmId::variable_not_set, where, "R" + std::to_string(index)));
    return found->second;
  }
};

}  // namespace kadr::test
