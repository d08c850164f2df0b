// Expressions of custom macros: text → instructions (spec/nct/23, grammar at its end).

#include <algorithm>

#include "base/ascii.h"
#include "lang/expression/expression.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

struct Name {
  std::string_view text;
  Op op;
  int binding = 0;
};
constexpr Name functions[] = {
    // longer names first: ASIN before no other, SQRT before SIN
    {"SQRT", Op::square_root}, {"ASIN", Op::arc_sine},      {"ACOS", Op::arc_cosine}, {"ATAN", Op::arc_tangent}, {"SIN", Op::sine},
    {"COS", Op::cosine},       {"TAN", Op::tangent},        {"EXP", Op::exp},         {"LN", Op::logarithm},     {"ABS", Op::abs},
    {"FIX", Op::truncate},     {"FUP", Op::away_from_zero}, {"NOT", Op::bit_not},
};
/// 23.2.6; INFERRED: AND binds like *, OR and XOR like + (Fanuc).
constexpr Name operators[] = {
    {"*", Op::multiply, 2}, {"/", Op::divide, 2},   {"MOD", Op::remainder, 2}, {"AND", Op::bit_and, 2},
    {"+", Op::add, 1},      {"-", Op::subtract, 1}, {"OR", Op::bit_or, 1},     {"XOR", Op::bit_xor, 1},
};
constexpr Name relations[] = {
    {"EQ", Op::equal}, {"NE", Op::not_equal}, {"GT", Op::greater}, {"LT", Op::less}, {"GE", Op::greater_equal}, {"LE", Op::less_equal},
};

class MacroCompiler {
 public:
  MacroCompiler(Cursor& cursor, const Grammar& grammar, Block& block, bool reads_parameters = false)
      : cursor_(cursor), grammar_(grammar), block_(block), reads_parameters_(reads_parameters) {}

  Status sum(int least_binding) {
    KADR_TRY(factor());
    for (;;) {
      cursor_.skip_blanks();
      const std::size_t begin = cursor_.at;
      const Name* const found = named(operators);
      if (found == nullptr || found->binding < least_binding) return {};
      cursor_.at += found->text.size();
      KADR_TRY(enter(begin));
      KADR_TRY(sum(found->binding + 1));
      --depth_;
      KADR_TRY(step(found->op, 0, begin, -1));
    }
  }

  /// A sign, then a value.
  Status factor() {
    cursor_.skip_blanks();
    const std::size_t begin = cursor_.at;
    const char c = cursor_.peek();
    if (c != '-' && c != '+') return value();
    ++cursor_.at;
    KADR_TRY(enter(begin));
    KADR_TRY(factor());
    --depth_;
    return c == '-' ? step(Op::negate, 0, begin, 0) : Status();
  }

  /// number | #value | [expression] | function operand | AXNUM[…] | PRM[…]
  Status value() {
    cursor_.skip_blanks();
    const std::size_t begin = cursor_.at;
    const char c = cursor_.peek();
    if (is_digit(c) || c == '.') return number();
    if (c == '#') {
      ++cursor_.at;
      return variable(begin);
    }
    if (c == '[') return bracket();
    if (is_letter(c)) return word();
    return wrong(begin);
  }

  /// Behind '#': digits, […], _NAME[…] (23.1.1); `##n` is an error.
  Status reference(bool& constant_number, double& number) {
    cursor_.skip_blanks();
    const std::size_t begin = cursor_.at;
    const char c = cursor_.peek();
    constant_number = false;
    if (is_digit(c)) {
      Number read;
      if (!read_number(cursor_, read) || read.has_point) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), '#'));
      constant_number = true;
      number = read.value;
      return {};
    }
    if (c == '[') return bracket();
    if (c == '_') return symbol(constant_number, number);
    return wrong(begin);
  }

  Status variable(std::size_t begin) {
    bool constant_number = false;
    double number = 0;
    KADR_TRY(enter(begin));
    KADR_TRY(reference(constant_number, number));
    --depth_;
    return constant_number ? step(Op::variable_at, number, begin, 1) : step(Op::variable, 0, begin, 0);
  }

  /// `WHILE #1=5`: an assignment where a condition should stand (23.2.11).
  Status no_assignment() {
    const std::size_t begin = cursor_.at++;
    KADR_TRY(variable(begin));
    cursor_.skip_blanks();
    const std::size_t at = cursor_.at;
    if (cursor_.peek() == '=') return fail(alarm(AlarmId::terminator_wrong, span(at, at + 1), '='));
    return wrong(begin);
  }

  Status relation() {
    KADR_TRY(sum(1));
    cursor_.skip_blanks();
    const std::size_t begin = cursor_.at;
    const Name* const found = named(relations);
    if (found == nullptr) {
      if (cursor_.peek() == '=') return fail(alarm(AlarmId::terminator_wrong, span(begin, begin + 1), '='));
      return wrong(begin);
    }
    cursor_.at += found->text.size();
    KADR_TRY(sum(1));
    return step(found->op, 0, begin, -1);
  }

  Status step(Op op, double number, std::size_t begin, int pushed) {
    pushed_ += pushed;
    if (block_.code.size() >= limits::expression_steps || pushed_ > static_cast<int>(limits::expression_depth))
      return fail(alarm(AlarmId::nesting_too_deep, span(begin, begin + 1), double{limits::expression_depth}));
    block_.code.push_back({op, number, span(begin, cursor_.at)});
    return {};
  }

  /// Has the bracket at `begin` no partner in the rest of the block (23.2.6)?
  bool is_open(std::size_t begin) const {
    int depth = 0;
    for (std::size_t i = begin; i < cursor_.text.size() && cursor_.text[i] != '('; ++i) {
      depth += cursor_.text[i] == '[' ? 1 : cursor_.text[i] == ']' ? -1 : 0;
      if (depth == 0) return false;
    }
    return true;
  }

  tl::unexpected<Alarm> wrong(std::size_t at) const {
    if (at < cursor_.text.size() && (static_cast<unsigned char>(cursor_.text[at]) & 0x80) != 0) {
      const std::size_t bytes = std::max<std::size_t>(1, first_character(cursor_.text.substr(at)).size);
      return fail(alarm(AlarmId::unexpected_character, span(at, at + bytes), cursor_.text.substr(at, bytes)));
    }
    return fail(
        alarm(AlarmId::expression_syntax, span(at, at + 1), at < cursor_.text.size() ? cursor_.text.substr(at, 1) : std::string_view("…")));
  }

 private:
  Status number() {
    const std::size_t begin = cursor_.at;
    Number read;
    if (!read_number(cursor_, read)) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at)));
    return step(Op::number, read.value, begin, 1);
  }

  Status bracket() {
    const std::size_t begin = cursor_.at++;
    KADR_TRY(enter(begin));
    KADR_TRY(sum(1));
    --depth_;
    return close(begin);
  }

  Status close(std::size_t begin) {
    cursor_.skip_blanks();
    if (cursor_.peek() != ']' && is_open(begin)) return fail(alarm(AlarmId::bracket_not_closed, span(begin, begin + 1)));
    if (cursor_.peek() != ']') return wrong(cursor_.at);
    ++cursor_.at;
    return {};
  }

  Status word() {
    const std::size_t begin = cursor_.at;
    if (const Name* const found = named(functions); found != nullptr) {
      cursor_.at += found->text.size();
      cursor_.skip_blanks();
      const std::size_t operand = cursor_.at;
      KADR_TRY(enter(begin));
      KADR_TRY(factor());  // only the operand that follows (23.2.4), with its signs
      --depth_;
      if (found->op == Op::arc_tangent) warn_of_quotient(begin, operand);
      return step(found->op, 0, begin, 0);
    }
    if (starts_with("AXNUM")) return axis_number(begin);
    if (starts_with("PRM")) return control_value(begin);
    std::size_t end = begin;
    while (end < cursor_.text.size() && is_letter(cursor_.text[end])) ++end;
    const AlarmId id = end - begin > 1 ? AlarmId::function_unknown : AlarmId::expression_syntax;
    return fail(alarm(id, span(begin, end), cursor_.text.substr(begin, end - begin)));
  }

  /// ATAN[a]/[b]: with Fanuc a function of both, here a division (23.2.6).
  void warn_of_quotient(std::size_t begin, std::size_t operand) {
    if (cursor_.text[operand] != '[') return;
    Cursor ahead = cursor_;
    ahead.skip_blanks();
    if (ahead.peek() != '/') return;
    ++ahead.at;
    ahead.skip_blanks();
    if (ahead.peek() == '[') block_.warnings.push_back(warning(AlarmId::arctangent_divides, span(begin, ahead.at)));
  }

  /// AXNUM[X]: the control-wide number of an axis (23.2.12).
  Status axis_number(std::size_t begin) {
    cursor_.at += 5;
    cursor_.skip_blanks();
    if (cursor_.peek() != '[') return wrong(cursor_.at);
    const std::size_t open = cursor_.at++;
    cursor_.skip_blanks();
    std::string name;
    const std::size_t from = cursor_.at;
    while (cursor_.peek() != '\0' && cursor_.peek() != ']' && cursor_.peek() != ' ' && name.size() < 8)
      name += to_upper(cursor_.text[cursor_.at++]);
    const Span where = span(from, cursor_.at);
    KADR_TRY(close(open));
    const std::uint8_t axis = name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z'
                                  ? grammar_.axis_numbers[static_cast<std::size_t>(name[0] - 'A')]
                                  : number_of_name(name);
    if (axis == 0) return fail(alarm(AlarmId::illegal_address, where, std::string_view(name)));
    return step(Op::number, axis, begin, 1);
  }

  std::uint8_t number_of_name(const std::string& name) const {
    for (const AddressName& row : grammar_.names)
      if (row.text == name) return grammar_.axis_numbers[static_cast<std::size_t>(row.address - 'A')];
    return 0;
  }

  /// PRM[n], PRM[n,bit], …/[index] (24.2); what is left out is vacant.
  Status control_value(std::size_t begin) {
    cursor_.at += 3;
    if (!reads_parameters_) return fail(alarm(AlarmId::illegal_address, span(begin, cursor_.at), "PRM"));  // 24.2: in an assignment only
    cursor_.skip_blanks();
    if (cursor_.peek() != '[') return wrong(cursor_.at);
    const std::size_t open = cursor_.at++;
    KADR_TRY(enter(begin));
    KADR_TRY(sum(1));
    cursor_.skip_blanks();
    if (cursor_.peek() == ',') {
      ++cursor_.at;
      KADR_TRY(sum(1));
    } else {
      KADR_TRY(step(Op::number, vacant, begin, 1));
    }
    KADR_TRY(close(open));
    Cursor ahead = cursor_;
    ahead.skip_blanks();
    const bool divides = ahead.peek() == '/';
    ++ahead.at;
    ahead.skip_blanks();
    if (divides && ahead.peek() == '[') {
      cursor_.at = ahead.at;
      KADR_TRY(bracket());
    } else {
      KADR_TRY(step(Op::number, vacant, begin, 1));
    }
    --depth_;
    return step(Op::control_value, 0, begin, -2);
  }

  /// _ABSIO[3], _ALM: by name (23.1.1).
  Status symbol(bool& constant_number, double& number) {
    const std::size_t begin = cursor_.at++;
    std::string name;
    while (is_letter(cursor_.peek()) || is_digit(cursor_.peek()) || cursor_.peek() == '_') name += to_upper(cursor_.text[cursor_.at++]);
    const auto found = std::lower_bound(grammar_.symbols.begin(), grammar_.symbols.end(), name,
                                        [](const VariableName& row, const std::string& text) { return row.text < text; });
    if (found == grammar_.symbols.end() || found->text != name)
      return fail(alarm(AlarmId::illegal_address, span(begin - 1, cursor_.at), cursor_.text.substr(begin - 1, cursor_.at - begin + 1)));
    cursor_.skip_blanks();
    if (!found->indexed) {
      constant_number = true;
      number = found->number;
      return {};
    }
    if (cursor_.peek() != '[') return wrong(cursor_.at);
    KADR_TRY(bracket());
    return step(Op::element, static_cast<double>(found - grammar_.symbols.begin()), begin - 1, 0);
  }

  template <std::size_t n>
  const Name* named(const Name (&names)[n]) const {
    for (const Name& row : names)
      if (starts_with(row.text)) return &row;
    return nullptr;
  }

  bool starts_with(std::string_view word) const {
    if (cursor_.text.size() - cursor_.at < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
      if (to_upper(cursor_.text[cursor_.at + i]) != word[i]) return false;
    return true;
  }

  Status enter(std::size_t at) {
    if (++depth_ > static_cast<int>(limits::expression_depth))
      return fail(alarm(AlarmId::nesting_too_deep, span(at, at + 1), double{limits::expression_depth}));
    return {};
  }

  Span span(std::size_t begin, std::size_t end) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::min(end, cursor_.text.size()))};
  }

  Cursor& cursor_;
  const Grammar& grammar_;
  Block& block_;
  bool reads_parameters_;
  int depth_ = 0;
  int pushed_ = 0;
};

template <class Compile>
Result<Expression> compiled(Block& block, Compile compile) {
  Expression expression;
  expression.begin = static_cast<std::uint16_t>(block.code.size());
  KADR_TRY(compile());
  expression.end = static_cast<std::uint16_t>(block.code.size());
  return expression;
}

}  // namespace

Result<Expression> compile_macro_value(Cursor& cursor, const Grammar& grammar, Block& block, MacroValue extent) {
  MacroCompiler compiler(cursor, grammar, block, extent == MacroValue::assigned);
  return compiled(block, [&] { return extent == MacroValue::operand ? compiler.value() : compiler.sum(1); });
}

Result<Expression> compile_condition(Cursor& cursor, const Grammar& grammar, Block& block) {
  MacroCompiler compiler(cursor, grammar, block);
  return compiled(block, [&]() -> Status {
    cursor.skip_blanks();
    const std::size_t open = cursor.at;
    if (cursor.peek() == '#') KADR_TRY(compiler.no_assignment());
    if (cursor.peek() != '[') return compiler.wrong(open);
    ++cursor.at;
    KADR_TRY(compiler.relation());
    cursor.skip_blanks();
    const Span at{static_cast<std::uint32_t>(open), static_cast<std::uint32_t>(open + 1)};
    if (cursor.peek() != ']' && compiler.is_open(open)) return fail(alarm(AlarmId::bracket_not_closed, at));
    if (cursor.peek() != ']') return compiler.wrong(cursor.at);
    ++cursor.at;
    return {};
  });
}

Result<Expression> compile_macro_target(Cursor& cursor, const Grammar& grammar, Block& block) {
  MacroCompiler compiler(cursor, grammar, block);
  return compiled(block, [&]() -> Status {
    const std::size_t begin = cursor.at;
    bool constant_number = false;
    double number = 0;
    KADR_TRY(compiler.reference(constant_number, number));
    return constant_number ? compiler.step(Op::number, number, begin, 1) : Status();
  });
}

}  // namespace kadr
