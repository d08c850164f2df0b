// System variables by number (spec/nct/23 23.1.5–23.1.22) and PRM (24.2). Used by the rest of control.

#include "control/macro_b/variables/system_variables.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/emitter.h"
#include "control/macro_b/macro_b.h"
#include "control/macro_b/programs/programs.h"
#include "control/macro_b/variables/clock.h"
#include "control/macro_b/variables/further_variables.h"
#include "control/macro_b/variables/machine_bits.h"
#include "control/macro_b/variables/modal_values.h"
#include "lang/expression/element_symbols.h"

namespace kadr::macro_b {
namespace {

std::optional<FoundVariable> find(const ControlDef& def, std::uint32_t number) {
  for (const VariableRow& row : def.variables)
    for (const VariableRange& range : row.ranges) {
      if (number < range.from) continue;
      const std::uint32_t beyond = number - range.from;
      const std::uint32_t nth = range.stride == 0 ? 0 : beyond / range.stride;
      const std::uint32_t within = beyond - nth * range.stride;
      if (nth < range.repeat && within < range.count) return FoundVariable{&row, within + row.first_index, nth + 1, number};
    }
  return std::nullopt;
}

double read_plain(const BlockContext& m, const FoundVariable& f) {
  const MacroB& n = macro_b_of(m);
  const VariableRow& row = *f.row;
  switch (row.kind) {
    case VariableKind::empty: return vacant;
    case VariableKind::constant_pi: return pi;
    case VariableKind::constant_e: return std::exp(1.0);
    case VariableKind::plc_in: return n.plc_in[f.index];
    case VariableKind::plc_in_word: return f.index == 0 ? bits_to_word(n.plc_in) : n.plc_in_word[f.index];
    case VariableKind::plc_out: return n.plc_out[f.index];
    case VariableKind::plc_out_word: return f.index == 0 ? bits_to_word(n.plc_out) : n.plc_out_word[f.index];
    case VariableKind::message_box: return n.answer;
    case VariableKind::clock: return n.now_ms - n.clock_offset_ms;
    case VariableKind::cutting_clock: return n.cutting_ms / cutting_unit(row);
    case VariableKind::timer: return timer(m, row);
    case VariableKind::tool_in_spindle: return m.modal.tool;
    case VariableKind::operator_switch: return operator_switch(m, row);
    case VariableKind::date: return date_number(n.clock);
    case VariableKind::time: return time_number(n.clock, n.now_ms);
    case VariableKind::parts_done: return n.state.parts_done;
    case VariableKind::parts_required: return n.parts_required;
    case VariableKind::single_block_lock: return row.bit < 0 ? n.control_1 : n.control_1 >> row.bit & 1u;
    case VariableKind::override_lock: return row.bit < 0 ? n.control_2 : n.control_2 >> row.bit & 1u;
    case VariableKind::mirror_state: return mirror_bits(m);
    case VariableKind::search_state: return search_bits(n, row.bit);
    case VariableKind::main_program: return number_of_file(m.program().main_file());
    case VariableKind::modal_group: return modal_group(m, row.arg, f.index);
    case VariableKind::modal_word: return modal_word(m, row.arg);
    default: return 0;
  }
}

/// Converts a value to a bit: 0 remains 0, and any other value up to 1 becomes 1 (23.2.1). A greater or negative value raises an alarm.
Result<bool> bit_value(double value, Span where) {
  if (!(value >= 0 && value <= 1)) return fail(alarm(AlarmId::value_limit, where, value));
  return value > 0;
}

Status write_bit(std::uint32_t& bits, int bit, double value, Span where) {
  const auto on = bit_value(value, where);
  if (!on) return fail(on.error());
  bits = *on ? bits | 1u << bit : bits & ~(1u << bit);
  return {};
}

Status write_word(std::array<double, 32>& bits, double value, Span where) {
  constexpr double least = -2147483648.0, beyond = 4294967296.0;
  if (!(value >= least && value < beyond)) return fail(alarm(AlarmId::value_limit, where, value));
  const auto word = static_cast<std::uint32_t>(std::llround(value));
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = word >> i & 1u;
  return {};
}

Status write_control(std::uint32_t& control, const VariableRow& row, double value, std::uint32_t most, Span where) {
  if (row.bit >= 0) return write_bit(control, row.bit, value, where);
  if (!(value >= 0 && value <= most)) return fail(alarm(AlarmId::value_limit, where, value));
  control = static_cast<std::uint32_t>(std::llround(value));
  return {};
}

Status write_plain(BlockContext& m, const FoundVariable& f, double value, Span where) {
  MacroB& n = macro_b_of(m);
  switch (f.row->kind) {
    case VariableKind::plc_out: {
      const auto on = bit_value(value, where);
      if (!on) return fail(on.error());
      n.plc_out[f.index] = *on ? 1 : 0;
      return {};
    }
    case VariableKind::plc_out_word:
      if (f.index == 0) return write_word(n.plc_out, value, where);
      n.plc_out_word[f.index] = value;
      return {};
    case VariableKind::clock: n.clock_offset_ms = n.now_ms - value; return {};
    case VariableKind::cutting_clock: n.cutting_ms = value * cutting_unit(*f.row); return {};
    case VariableKind::parts_done: n.state.parts_done = value; return {};
    case VariableKind::parts_required: n.parts_required = value; return {};
    case VariableKind::single_block_lock: return write_control(n.control_1, *f.row, value, 255, where);
    case VariableKind::override_lock: return write_control(n.control_2, *f.row, value, 7, where);
    default: return fail(alarm(AlarmId::not_available, where, "#" + std::to_string(f.row->ranges.front().from)));
  }
}

[[gnu::always_inline]] inline Result<std::uint32_t> whole_number(double number, Span where) {
  const double nearest = std::round(number);
  if (!(nearest >= 0 && nearest <= 1e8) || std::fabs(number - nearest) > tol::whole_number)
    return fail(alarm(AlarmId::variable_unknown, where, number));
  return static_cast<std::uint32_t>(nearest);
}

}  // namespace

Result<double> read_variable(Emitter& m, double number, Span where) {
  const auto meant = number_meant(m, number, where);
  if (!meant) return fail(meant.error());
  const auto n = whole_number(*meant, where);
  if (!n) return fail(n.error());
  if (double value = 0; macro_b_of(m).variables.known(*n, value)) return value;
  macro_b_of(m).endless.note_reading();
  const auto f = find(m.def, *n);
  if (!f) return fail(alarm(AlarmId::variable_unknown, where, *meant));
  if (const auto further = further_variable(*f->row, *n, f->index)) return read_further(m, *further);
  if (!f->row->read) return fail(alarm(AlarmId::variable_write_only, where, number));
  if (const auto value = macro_b_of(m).table_value(m, *f); value) return *value;
  if (!f->row->works) return fail(alarm(AlarmId::not_available, where, "#" + std::to_string(*n)));
  return read_plain(m, *f);
}

Status write_variable(Emitter& m, double number, double value, Span where) {
  const auto meant = number_meant(m, number, where);
  if (!meant) return fail(meant.error());
  const auto n = whole_number(*meant, where);
  if (!n) return fail(n.error());
  MacroB& macros = macro_b_of(m);
  const auto plain = static_cast<int>(*n);
  if (plain >= 1 && plain <= static_cast<int>(max_locals)) {
    macros.variables.locals()[*n] = value;
    return {};
  }
  const bool is_protected =
      macros.settings.protect_high != 0 && plain >= macros.settings.protect_low && plain <= macros.settings.protect_high;
  if (plain >= first_common && plain <= last_common && !is_protected) {
    macros.variables.set_common(plain, value);
    return {};
  }
  if (*n == 0 || is_protected) return fail(alarm(AlarmId::variable_read_only, where, number));
  const auto f = find(m.def, *n);
  if (!f) return fail(alarm(AlarmId::variable_unknown, where, number));
  if (!f->row->write) return fail(alarm(AlarmId::variable_read_only, where, number));
  if (const auto further = further_variable(*f->row, *n, f->index)) {
    write_further(m, *further, value);
    return {};
  }
  macros.endless.note_change();
  if (is_vacant(value)) value = 0;  // vacant is written as 0, because only #1 … #999 can be vacant
  const auto written = macros.write_table(m, *f, value, where);
  if (!written) return fail(written.error());
  return *written ? Status() : write_plain(m, *f, value, where);
}

Status set_start_value(Emitter& m, double number, double value) {
  MacroB& macros = macro_b_of(m);
  const auto n = whole_number(number, {});
  if (!n) return fail(n.error());
  const auto plain = static_cast<int>(*n);
  if (plain >= first_common && plain <= last_common) {
    macros.variables.set_common(plain, value);
    return {};
  }
  const auto f = find(m.def, *n);
  if (!f || is_vacant(value)) return write_variable(m, number, value, {});
  if (f->row->kind == VariableKind::plc_in) {
    const auto on = bit_value(value, {});
    if (!on) return fail(on.error());
    macros.plc_in[f->index] = *on ? 1 : 0;
    return {};
  }
  if (f->row->kind == VariableKind::plc_in_word) {
    if (f->index == 0) return write_word(macros.plc_in, value, {});
    macros.plc_in_word[f->index] = value;
    return {};
  }
  return write_variable(m, number, value, {});
}

Result<double> number_of_element(const BlockContext& m, double symbol, double index, Span where) {
  if (symbol == symbol_own_number)
    return VariableNames::is_named(index) ? fail(alarm(AlarmId::variable_unknown, where, index)) : Result<double>(index);
  const VariableName& name = m.def.grammar.symbols[static_cast<std::size_t>(symbol)];
  const double nearest = std::round(index);
  if (!(nearest >= name.first_index && nearest < name.first_index + name.count))
    return fail(alarm(AlarmId::value_out_of_range, where, std::string_view(name.text), index));
  return name.number + nearest - name.first_index;
}

Result<double> read_parameter(BlockContext& m, double number, double bit, double index, Span where) {
  const auto given = [](double v) { return is_vacant(v) ? std::optional<double>() : std::optional(v); };
  if (is_vacant(number)) return fail(alarm(AlarmId::expression_syntax, where, "PRM"));
  macro_b_of(m).endless.note_reading();
  return macro_b_of(m).parameters.read(number, given(bit), given(index), where);
}

}  // namespace kadr::macro_b
