#pragma once
// NamedExpressions: compiles the expressions of a block with names to steps (spec/sinumerik 7). Base of the reader of such blocks. The
// expression compiler of lang/expression has one type of value, brackets in place of parentheses and no names, so it does not serve here.

#include <string>
#include <string_view>
#include <vector>

#include "base/ascii.h"
#include "base/result.h"
#include "lang/named/named_block.h"
#include "lang/named/named_parser.h"

namespace kadr {

/// Non-printing signs and & separate words as a blank does (spec/sinumerik 2).
inline bool is_blank_sign(char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f' || c == '&'; }

class NamedExpressions {
 public:
  NamedExpressions(std::string_view text, std::size_t at, NamedBlock& block) : text_(text), at_(at), block_(block) {}

 protected:
  /// Compiles an expression at the place of reading.
  Status expression(NamedExpression& to);
  /// Reads [a, b].
  Status indices(std::vector<NamedExpression>& to) { return list(to, '[', ']'); }
  /// Reads (a, , b); an argument that is left out is an expression with the step `omitted`.
  Status arguments(std::vector<NamedExpression>& to) { return list(to, '(', ')'); }
  Status number_here(double& value, bool& whole);
  Status push(NamedStep step);

  void skip() {
    while (at_ < text_.size() && is_blank_sign(text_[at_])) ++at_;
  }
  bool at_end() const { return at_ >= text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  bool at(std::string_view what) const { return text_.substr(at_, what.size()) == what; }
  /// Returns the name at the place of reading in upper case, without moving; empty if there is none.
  std::string name_here() const;
  std::string take_name() {
    const std::string name = name_here();
    at_ += name.size();
    return name;
  }
  tl::unexpected<Alarm> syntax() const;
  tl::unexpected<Alarm> unexpected() const;
  tl::unexpected<Alarm> not_closed(std::size_t open) const { return fail(alarm(AlarmId::bracket_not_closed, span(open, open + 1))); }
  Span span(std::size_t begin, std::size_t end) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end < text_.size() ? end : text_.size())};
  }

  std::string_view text_;
  std::size_t at_;
  NamedBlock& block_;

 private:
  struct Operator {
    std::string_view text;
    NamedOp op;
    int binding;
  };
  static const Operator* operator_named(std::string_view text);
  const Operator* operator_here() const;
  Status sum(int least);
  Status operand();
  Status value();
  Status quoted_number();
  Status text_value();
  Status name_value();
  Status list(std::vector<NamedExpression>& to, char open, char close);

  int depth_ = 0;
};

}  // namespace kadr
