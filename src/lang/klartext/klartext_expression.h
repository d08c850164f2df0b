#pragma once
// KlartextText: the place of reading in a conversational block, with what all its parts need: numbers, Q parameters, formulas
// (spec/heidenhain 1.3, 10). Base of the parser.

#include <optional>
#include <string>
#include <string_view>

#include "base/ascii.h"
#include "base/result.h"
#include "lang/klartext/klartext_block.h"

namespace kadr {

class KlartextText {
 public:
  KlartextText(std::string_view text, Span statement, KlartextBlock& block)
      : text_(text.substr(0, statement.end)), at_(statement.begin), block_(block) {}

 protected:
  /// Passes blanks, ends of lines, comments and the sign `~` at the end of a line.
  void skip();
  bool at_end() {
    skip();
    return at_ >= text_.size();
  }
  char peek() const { return at_ < text_.size() ? to_upper(text_[at_]) : '\0'; }
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? to_upper(text_[at_ + ahead]) : '\0'; }
  /// Passes `what`, whatever its case. If it ends with a letter, no further letter may follow.
  bool take(std::string_view what);
  /// Passes `what` even if a letter follows.
  bool take_prefix(std::string_view what);
  bool looks_like(std::string_view what) const;
  /// Reads a number without a sign; nullopt if there is none.
  std::optional<double> unsigned_number();
  /// Returns true if a Q parameter is at the place of reading.
  bool at_parameter() const;
  /// Reads Q5, QL5, QR5 or QS5 as a step.
  Result<KlartextStep> parameter();
  /// Reads `+10`, `-Q5`, `QL3`: a number into `number`, or a parameter into `value`. Returns false if there is none.
  Result<bool> value(double& number, KlartextExpression& value);
  /// Reads one operand of FN 0 to FN 13, with its sign, as an expression.
  Status operand();
  /// Compiles a formula.
  Status formula(KlartextExpression& to);
  Result<std::string> quoted();
  void push(KlartextOp op, double number = 0);
  std::uint16_t code_end() const { return static_cast<std::uint16_t>(block_.code.size()); }
  tl::unexpected<Alarm> syntax() const;
  Span span(std::size_t begin, std::size_t end) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end < text_.size() ? end : text_.size())};
  }

  std::string_view text_;
  std::size_t at_;
  KlartextBlock& block_;

 private:
  Status sum();
  Status product();
  Status power();
  Status signed_value();
  Status primary();
  Status text_function(KlartextOp op);
  Result<std::uint16_t> text_source(std::string_view name);

  int depth_ = 0;
};

}  // namespace kadr
