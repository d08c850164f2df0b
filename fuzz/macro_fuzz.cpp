// Fuzz target for the macro language of nct: reads lines as words and statements, compiles them to instructions, and evaluates these. No
// control runs.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/control/control_file.h"
#include "config/machine/machine_axes.h"
#include "control/macro_b/output/print.h"
#include "lang/block/lexer.h"
#include "lang/expression/expression.h"
#include "require.h"

namespace {

using kadr::AlarmId;
using kadr::Block;
using kadr::Expression;
using kadr::no_alarm;
using kadr::Op;
using kadr::fuzz::require;

constexpr std::size_t max_lines = 200;

const kadr::Grammar& grammar() {
  static const kadr::ControlDef def = [] {
    kadr::ControlDef d = std::move(*kadr::load_control("nct"));
    kadr::Setup setup;
    setup.axes = {"X", "Y", "Z", "A", "C", "XDE"};
    setup.spindles[2].name = "S2";
    require(kadr::fit_to_machine(d, setup).empty(), "the axes have good names");
    return d;
  }();
  return def.grammar;
}

/// Values of the variables #n: every third number is vacant, the others have a value that depends on n; higher numbers are system
/// variables.
struct Variables {
  static double value(double n) { return std::fmod(n, 3) == 0 ? kadr::vacant : (n - 50) / 8; }
  bool known(double number, double& to) const {
    if (!(number >= 0 && number < 1000)) return false;
    to = value(std::floor(number));
    return true;
  }
  kadr::Result<double> variable(double number, kadr::Span where) const {
    if (!(number >= 0 && number < 200'000)) return kadr::fail(kadr::alarm(AlarmId::variable_unknown, where, number));
    return value(std::floor(number));
  }
  kadr::Result<double> parameter(int, kadr::Span where) const { return kadr::fail(kadr::alarm(AlarmId::variable_not_set, where)); }
  kadr::Result<double> element(double symbol, double index, kadr::Span where) const {
    require(symbol >= 0 && symbol < double(grammar().symbols.size()), "the symbol is in the table");
    if (!(index >= 0 && index < 100)) return kadr::fail(kadr::alarm(AlarmId::value_out_of_range, where, index));
    return grammar().symbols[static_cast<std::size_t>(symbol)].number + index;
  }
  kadr::Result<double> control_value(double number, double bit, double, kadr::Span where) const {
    if (kadr::is_vacant(number)) return kadr::fail(kadr::alarm(AlarmId::value_out_of_range, where, 0.0));
    return kadr::is_vacant(bit) ? number : 1.0;
  }
};

/// Returns the number of values that an instruction pops from the stack; each instruction pushes one.
std::size_t taken(Op op) {
  switch (op) {
    case Op::number:
    case Op::parameter:
    case Op::variable_at: return 0;
    case Op::control_value: return 3;
    default: return kadr::takes_two(op) ? 2 : 1;
  }
}

void check_stack(const Block& block, Expression e) {
  require(e.begin <= e.end && e.end <= block.code.size(), "the expression lies in the block");
  std::size_t depth = 0;
  for (std::size_t i = e.begin; i < e.end; ++i) {
    const std::size_t takes = taken(block.code[i].op);
    require(depth >= takes, "the operands are there");
    depth = depth - takes + 1;
    require(depth <= 2 * kadr::limits::expression_depth, "the stack holds all operands");
  }
  require(depth == 1, "an expression has one value");
}

bool inside(kadr::Span span, std::string_view text) { return span.begin <= span.end && span.end <= text.size(); }

/// Returns the value of the expression, or the number of its alarm. Checks that the same text gives the same result again.
std::pair<double, AlarmId> check_value(const Block& block, Expression e) {
  if (!e) return {0, no_alarm};
  check_stack(block, e);
  const auto value = kadr::evaluate(block, e, Variables());
  if (!value) {
    require(inside(value.error().where, block.text), "the alarm lies in the text");
    return {0, value.error().id};
  }
  require(kadr::is_vacant(*value) || std::isfinite(*value), "a value is a number, or vacant");
  return {*value, no_alarm};
}

/// The contents of a line, as far as they can be compared.
struct Read {
  std::optional<AlarmId> alarm;
  std::vector<std::pair<double, AlarmId>> values;
  std::vector<std::pair<char, double>> words;
  kadr::StatementKind kind = kadr::StatementKind::none;
  std::size_t instructions = 0;
};

bool same(double a, double b) { return a == b || (a != a && b != b); }
bool same(const Read& a, const Read& b) {
  if (a.alarm != b.alarm) return false;
  if (a.alarm) return true;
  const auto pairs = [](const auto& x, const auto& y) { return same(x.first, y.first) && x.second == y.second; };
  const auto words = [](const auto& x, const auto& y) { return x.first == y.first && same(x.second, y.second); };
  return a.kind == b.kind && a.instructions == b.instructions &&
         std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(), pairs) &&
         std::equal(a.words.begin(), a.words.end(), b.words.begin(), b.words.end(), words);
}

void check_print(const Block& block) {
  using namespace kadr::macro_b;
  const kadr::Statement& s = block.statement;
  if (s.kind != kadr::StatementKind::print_binary && s.kind != kadr::StatementKind::print_decimal) return;
  const PrintKind kind = s.kind == kadr::StatementKind::print_binary ? PrintKind::binary : PrintKind::decimal;
  const std::string_view text = block.text_of(s.text);
  std::vector<std::optional<double>> values;
  Block scratch;
  const auto pieces = parse_print(text, kind, [&](std::string_view rest) -> kadr::Result<std::size_t> {
    kadr::Cursor cursor{rest, 0};
    scratch.clear();
    const auto reference = kadr::compile_macro_value(cursor, grammar(), scratch, kadr::MacroValue::operand);
    if (!reference) return kadr::fail(reference.error());
    require(cursor.at > 0 && cursor.at <= rest.size(), "a reference is read");
    const auto value = kadr::evaluate(scratch, *reference, Variables());
    if (!value) return kadr::fail(value.error());
    values.push_back(kadr::is_vacant(*value) ? std::nullopt : std::optional(*value));
    return cursor.at;
  });
  if (!pieces) return;
  if (kind == PrintKind::binary) (void)binary(pieces->pieces, values);
  else require(decimal(pieces->pieces, values, PrintFill::spaces).ends_with("\r\n"), "a print ends its line");
}

Read read_line(const std::string& line) {
  Block block;
  const auto lexed = kadr::lex_block(line, 0, kadr::fuzz::is_utf8(line), grammar(), block);
  Read read;
  read.instructions = block.code.size();
  require(block.code.size() <= kadr::limits::expression_steps + kadr::limits::block_words, "not too many instructions");
  if (!lexed) {
    require(inside(lexed.error().where, line), "the alarm lies in the text");
    read.alarm = lexed.error().id;
    return read;
  }
  if (lexed->needs_utf8 || lexed->open_comment) return read;
  const kadr::Statement& s = block.statement;
  read.kind = s.kind;
  require(inside(s.where, line) && inside(s.text, line) && inside(block.file_name, line), "the statement lies in the text");
  require(s.condition_count <= kadr::limits::conditions && s.loop <= 3, "conditions and loops are counted");
  require(s.kind == kadr::StatementKind::none || block.word_count == 0, "a statement stands alone");
  for (std::size_t i = 0; i < s.condition_count; ++i) read.values.push_back(check_value(block, s.conditions[i]));
  if (s.target) require(s.kind == kadr::StatementKind::assign || s.kind == kadr::StatementKind::message, "only an assignment has a target");
  for (const Expression e : {s.target, s.value, s.program}) read.values.push_back(check_value(block, e));
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const kadr::Word& w = block.words[i];
    require(inside(w.where, line) && w.where.begin < w.where.end, "the word lies in the text");
    read.words.emplace_back(w.address, w.expression ? 0 : w.value);
    if (w.expression) read.values.push_back(check_value(block, w.expression));
    if (w.expression && w.address == kadr::indirect_axis) read.values.push_back(check_value(block, w.axis));
  }
  check_print(block);
  return read;
}

std::string in_case(std::string text, bool upper) {
  for (char& c : text) {
    if (upper && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (!upper && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  for (std::size_t i = 0; i < max_lines && !rest.empty(); ++i) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string line(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.size() > kadr::limits::line_bytes) continue;
    const Read read = read_line(line);
    require(same(read, read_line(line)), "the same text is the same block");
    // Capital and small letters are equivalent, except in file names and comments, on which no value depends.
    require(same(read_line(in_case(line, true)), read_line(in_case(line, false))), "small letters mean the same");
  }
  return 0;
}
