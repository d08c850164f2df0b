#pragma once
// WordReader: reads one word with a known address and converts its digits to a value by the format of the address. Used by the lexer
// only.

#include "base/ascii.h"
#include "base/result.h"
#include "lang/block/block.h"
#include "lang/block/grammar.h"
#include "lang/expression/expression.h"

namespace kadr {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\0' || c == '\x7f'; }

class WordReader {
 public:
  WordReader(Cursor& cursor, const Grammar& grammar, Block& block) : cursor_(cursor), grammar_(grammar), block_(block) {}

  /// Checks that the block may have one more word with this address. The format of the address limits the number of words.
  ///   alarms  too_many_words, address_twice, too_many_codes
  Status room_for(char letter, const WordFormat& format, std::size_t begin);

  /// Reads the sign, digits, decimal point or expression after the address; the cursor is at the first of these characters. `begin`: start
  /// of the word, for alarms.
  Status value(Word& w, const WordFormat& format, std::size_t begin);

  /// Reads `R2+50`, which sets R2 to 50. The manual requires the sign (2С42 6.3.7). INFERRED: a number without a sign is positive.
  Status formal_parameter(std::size_t begin);
  /// Reads `#12+50.`, a formal parameter with a special sign as its letter (spec/correctors 3). An alarm reports any other text as
  /// unexpected.
  Status parameter_by_sign();

  /// Returns true for `R01+50.` or `P123=5`: after the letter at the cursor there are two or three digits, then a sign or '='
  /// (spec/correctors 3).
  bool assigns_parameter(char letter) const;
  Status long_parameter(char letter, std::size_t begin);

  /// Reads the number after N or ':'.
  Status block_number(std::size_t begin, const WordFormat& format);

  /// Reads the number after O.
  Status label(std::size_t begin, const WordFormat& format);

  /// Reads AX[n]=v, a word that gives its axis by a number (nct 23.2.12). Its address is known only when the block is executed.
  Status axis_by_number(std::size_t begin);

  /// Returns the longest name of several characters at the cursor; nullptr if no name is at the cursor. A name that ends with a digit must
  /// have '=' after it (nct 2.2).
  const AddressName* name_here() const;

  /// Returns true if the text at the cursor cannot be the start of a value.
  bool no_value_follows() const;

  /// Returns true if the text `mark` (ПС or LF) at the offset `at` ends the block.
  bool marks_end(std::string_view mark, std::size_t at) const;

 private:
  Status increment(Word& w, const WordFormat& format, std::size_t begin);
  Status number(Word& w, const WordFormat& format, char sign, std::size_t begin);
  Status digits_apart(Number& read, const Word& w, std::size_t begin);
  Status point_apart(Number& read, const Word& w, std::size_t begin);
  Status check_digits(const Word& w, const Number& read, const WordFormat& format, std::size_t begin) const;
  Status code_of(Word& w, std::size_t begin) const;
  Status second_number(Word& w);
  bool parameter_here() const;
  Result<double> parameter_index();
  Status assign_parameter(double index, double value, std::size_t begin);
  Status parameter_sum(Word& w, const WordFormat& format, double constant, char sign, std::size_t begin);
  Expression constant(double number, Span where);
  Span span(std::size_t begin, std::size_t end) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end < cursor_.text.size() ? end : cursor_.text.size())};
  }

  Cursor& cursor_;
  const Grammar& grammar_;
  Block& block_;
};

}  // namespace kadr
