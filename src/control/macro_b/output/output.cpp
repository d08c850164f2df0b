// Executes the output statements POPEN, FOPEN, DPRNT, BPRNT, PCLOS, FCLOS (spec/nct/23 23.2.13) by calls of the class OutputFile. Used by
// control/macro_b/statements/statements, control/macro_b/statements/messages.

#include "control/macro_b/output/output.h"

#include <cmath>
#include <filesystem>

#include "control/emitter.h"
#include "control/macro_b/macro_b.h"
#include "control/macro_b/output/print.h"
#include "control/variable_reader.h"
#include "lang/expression/expression.h"

namespace kadr::macro_b {
namespace {

namespace fs = std::filesystem;

/// Returns the running program's path relative to the program memory. INFERRED: a program outside the program memory counts as if it were
/// in the top folder of the program memory.
std::string program_path(const BlockContext& m) {
  const auto whole = [](const std::string& path) {
    std::error_code error;  // the error is ignored: if there is no working directory, the path remains relative
    return fs::absolute(path, error).lexically_normal();
  };
  const fs::path main = whole(m.program().main_file()), root = whole(macro_b_of(m).output.root() + "/").parent_path();
  const fs::path from_root = main.lexically_relative(root);
  const bool inside = !from_root.empty() && *from_root.begin() != "..";
  return whole(m.program().file()).lexically_relative(inside ? root : main.parent_path()).generic_string();
}

/// Adds the location in the program to an alarm that the output file reports.
Status placed(const Status& status, Span where) {
  if (status) return {};
  Alarm alarm = status.error();
  alarm.where = where;
  return fail(alarm);
}

Result<double> value_or_zero(Emitter& m, Expression expression) {
  if (!expression) return 0.0;
  return evaluate(*m.block, expression, VariableReader{m});
}

/// Collects the values of the variables in a text, in the order in which they occur in the text. The value of a vacant variable is nullopt.
class Values {
 public:
  explicit Values(Emitter& m) : m_(m) { scratch_.text = {}; }

  Result<std::size_t> read(std::string_view rest) {
    Cursor cursor{rest, 0};
    scratch_.clear();
    const auto reference = compile_macro_value(cursor, m_.def.grammar, scratch_, MacroValue::operand);
    if (!reference) return fail(reference.error());
    const auto value = evaluate(scratch_, *reference, VariableReader{m_});
    if (!value) return fail(value.error());
    values_.push_back(is_vacant(*value) ? std::optional<double>() : std::optional(*value));
    return cursor.at;
  }
  PrintValues values() const { return values_; }

 private:
  Emitter& m_;
  Block scratch_;
  std::vector<std::optional<double>> values_;
};

Status print(Emitter& m, const Statement& s, PrintKind kind) {
  auto values = std::make_unique<Values>(m);
  const std::string_view text = m.block->text_of(s.text);
  const auto pieces = parse_print(text, kind, [&](std::string_view rest) { return values->read(rest); });
  if (!pieces) {
    Alarm alarm = pieces.error();
    alarm.where = {alarm.where.begin + s.text.begin, alarm.where.end + s.text.begin};
    return fail(alarm);
  }
  if (kind == PrintKind::decimal) {
    const PrintFill fill = macro_b_of(m).settings.print_bare ? PrintFill::none : PrintFill::spaces;
    return placed(macro_b_of(m).output.print(decimal(pieces->pieces, values->values(), fill), kind), s.where);
  }
  const auto bytes = binary(pieces->pieces, values->values());
  if (!bytes) return placed(fail(bytes.error()), s.where);
  return placed(macro_b_of(m).output.print(*bytes, kind), s.where);
}

Status open_file_of(Emitter& m, const Statement& s, double mode) {
  OutputFile& output = macro_b_of(m).output;
  if (m.block->file_name.end != 0) {
    Span place = m.block->file_name;
    const std::string name = m.program().shown(m.block->text_of(m.block->file_name), place);
    const Status opened = output.open_named(mode, name, program_path(m));
    const bool of_name = !opened && opened.error().id != AlarmId::file_mode && opened.error().id != AlarmId::file_already_open;
    return placed(opened, of_name ? m.block->file_name : s.where);
  }
  const auto number = value_or_zero(m, s.program);
  if (!number) return fail(number.error());
  return placed(output.open_number(mode, *number, program_path(m)), s.where);
}

}  // namespace

Status output(Emitter& m, const Statement& s) {
  if (s.kind == StatementKind::print_decimal) return print(m, s, PrintKind::decimal);
  if (s.kind == StatementKind::print_binary) return print(m, s, PrintKind::binary);
  OutputFile& output = macro_b_of(m).output;
  if (s.kind == StatementKind::close_file) return placed(output.close_file(), s.where);
  const auto number = value_or_zero(m, s.value);
  if (!number) return fail(number.error());
  switch (s.kind) {
    case StatementKind::open_port:
      return placed(s.value ? output.open_device(*number, program_path(m)) : output.open_card(program_path(m)), s.where);
    case StatementKind::close_port: return placed(output.close_device(s.value ? *number : no_device), s.where);
    default: return open_file_of(m, s, *number);
  }
}

Result<std::string> embedded_values(Emitter& m, const std::string& text, Span) {
  auto values = std::make_unique<Values>(m);
  const PrintText pieces = parse_message(text, [&](std::string_view rest) { return values->read(rest); });
  const PrintFill fill = macro_b_of(m).settings.print_bare ? PrintFill::none : PrintFill::spaces;
  return joined(pieces.pieces, values->values(), fill);
}

}  // namespace kadr::macro_b
