// System variables of the NCT control by number (spec/nct/23 23.1.5–23.1.22) and PRM (24.2). For the rest of control.

#include "control/nct/variables/system_variables.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/interpreter.h"
#include "control/nct/five_axis/five_axis.h"
#include "control/nct/nct.h"
#include "control/nct/variables/clock.h"
#include "control/nct/variables/further_variables.h"
#include "control/nct/variables/machine_bits.h"
#include "control/nct/variables/modal_values.h"
#include "control/nct/words/coordinates.h"
#include "kinematics/part_space.h"
#include "lang/expression/element_symbols.h"

namespace kadr::nct {
namespace {

/// A number found in the control's table.
struct Found {
  const VariableRow* row = nullptr;
  std::uint32_t index = 0;   // from the row's first index on
  std::uint32_t family = 1;  // p of #_WZPp[n]
};

std::optional<Found> find(const ControlDef& def, std::uint32_t number) {
  for (const VariableRow& row : def.variables)
    for (const VariableRange& range : row.ranges) {
      if (number < range.from) continue;
      const std::uint32_t beyond = number - range.from;
      const std::uint32_t nth = range.stride == 0 ? 0 : beyond / range.stride;
      const std::uint32_t within = beyond - nth * range.stride;
      if (nth < range.repeat && within < range.count) return Found{&row, within + row.first_index, nth + 1};
    }
  return std::nullopt;
}

/// Index in the channel of the axis with that control-wide number; -1: another channel's, or none.
int axis_of(const Interpreter& m, std::uint32_t number) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (m.def.axis_numbers[a] == number) return static_cast<int>(a);
  return -1;
}

/// A length in the program's unit; a diameter as one.
double shown(const Interpreter& m, int axis, double mm) {
  if ((m.def.rotary >> axis & 1u) != 0) return mm;
  const double v = (m.modal.diameter >> axis & 1u) != 0 ? 2 * mm : mm;
  return m.modal.inch ? v / mm_per_inch : v;
}
double kept(const Interpreter& m, int axis, double value) {
  if ((m.def.rotary >> axis & 1u) != 0) return value;
  const double mm = m.modal.inch ? value * mm_per_inch : value;
  return (m.modal.diameter >> axis & 1u) != 0 ? mm / 2 : mm;
}

Vec3 main_axes_of(const PartSpace& space, const Axes& axes) {
  const auto& main = space.data().main;
  const auto of = [&](std::size_t i) { return main[i] < 0 ? 0.0 : axes[static_cast<std::size_t>(main[i])]; };
  return {of(0), of(1), of(2)};
}

/// Component of a vector of X, Y, Z on an axis; nothing: it is none of them.
std::optional<double> component(const PartSpace& space, std::size_t axis, Vec3 v) {
  const double values[] = {v.x, v.y, v.z};
  for (std::size_t i = 0; i < 3; ++i)
    if (space.data().main[i] == static_cast<std::int8_t>(axis)) return values[i];
  return std::nullopt;
}

/// A position of the tool as it is told (25.19): in the work system, or in the programming frame; with the length, or without.
double told(const Interpreter& m, std::size_t axis, const Axes& work, const Axes& length, bool in_frame) {
  const bool with_length = !nct_of(m).settings.without_length;
  const PartSpace* const space = space_of(m);
  if (space == nullptr || space->is_plain()) return work[axis] + (with_length ? length[axis] : 0);
  Vec3 at = space->in_system(main_axes_of(*space, work));
  if (with_length) at = at + main_axes_of(*space, length);
  if (in_frame && space->has_frame()) at = space->in_frame(at);
  return component(*space, axis, at).value_or(work[axis]);
}

/// Positions and lengths by axis; another channel's axis reads 0.
double axis_value(const Interpreter& m, VariableKind kind, int axis) {
  if (axis < 0) return 0;
  const auto a = static_cast<std::size_t>(axis);
  const Nct& nct = nct_of(m);
  const double length = length_in_force(m)[a];
  const bool in_frame = nct.settings.in_frame;
  switch (kind) {
    case VariableKind::end_position: return shown(m, axis, before_transform(m)[a]);
    case VariableKind::machine_position: return shown(m, axis, m.position.machine[a]);
    case VariableKind::work_position: return shown(m, axis, told(m, a, m.position.work, length_in_force(m), in_frame));
    case VariableKind::probe_position: return shown(m, axis, told(m, a, nct.probe_position, nct.probe_length, in_frame));
    case VariableKind::length_in_force: return shown(m, axis, length);
    default: return 0;  // lag, distance to go, handwheel shift: the virtual machine has none
  }
}

/// The field of the offset table, or nullptr.
double* offset_field(Interpreter& m, VariableKind kind, std::uint32_t number) {
  if (number >= m.tables.offsets.size()) return nullptr;
  ToolOffset& o = m.tables.offsets[number];
  switch (kind) {
    case VariableKind::offset_length: return &o.length;
    case VariableKind::offset_length_wear: return &o.length_wear;
    case VariableKind::offset_radius: return &o.radius;
    case VariableKind::offset_radius_wear: return &o.radius_wear;
    case VariableKind::offset_corner: return &o.corner;
    case VariableKind::offset_corner_wear: return &o.corner_wear;
    case VariableKind::offset_tip: return &o.tip_position;
    case VariableKind::offset_x: return &o.length_x;
    case VariableKind::offset_y: return &o.length_y;
    case VariableKind::offset_x_wear: return &o.length_x_wear;
    case VariableKind::offset_y_wear: return &o.length_y_wear;
    default: return nullptr;
  }
}

/// What one unit of a register's variable is: mm, of a diameter (spec/haas 2.4) half of it.
double register_unit(const Interpreter& m, VariableKind kind) {
  if (kind == VariableKind::offset_tip) return 1;
  const bool radius = kind == VariableKind::offset_radius || kind == VariableKind::offset_radius_wear;
  return (m.modal.inch ? mm_per_inch : 1) * (radius && nct_of(m).settings.offsets_are_diameters ? 0.5 : 1);
}

/// Work offsets and basic rotations: which system a row means.
std::size_t system_of(const Found& f) {
  const bool extended = f.row->kind == VariableKind::zero_extended || f.row->kind == VariableKind::rotation_extended;
  if (f.row->kind == VariableKind::zero_dynamic) return all_systems - 1 + f.family;
  return extended ? basic_systems + f.family : static_cast<std::size_t>(f.row->arg);
}

double* rotation_field(Interpreter& m, const Found& f) {
  Vec3& angles = m.tables.rotations[system_of(f)];
  return f.index == 1 ? &angles.x : f.index == 2 ? &angles.y : &angles.z;
}

bool is_zero(VariableKind kind) {
  return kind == VariableKind::zero || kind == VariableKind::zero_common || kind == VariableKind::zero_extended ||
         kind == VariableKind::zero_dynamic || kind == VariableKind::zero_local;
}

/// #5501 … (25.4): the dynamic offset in force as the table stands, of the rotary axes as it is in the table.
double dynamic_value(const Interpreter& m, int axis) {
  const PartSpace* const space = space_of(m);
  if (axis < 0 || space == nullptr || m.modal.work_zero < all_systems) return 0;
  const auto a = static_cast<std::size_t>(axis);
  return component(*space, a, space->zero_now(m.position.machine)).value_or(m.tables.zeros[m.modal.work_zero][a]);
}

/// #151001 … the other way round than #5061; #151101 … of the machine (25.19).
double probe_of_five_axes(const Interpreter& m, bool of_machine, int axis) {
  if (axis < 0) return 0;
  const auto a = static_cast<std::size_t>(axis);
  const Nct& nct = nct_of(m);
  if (!of_machine) return told(m, a, nct.probe_position, nct.probe_length, !nct.settings.in_frame);
  return nct.probe_machine[a] - (nct.settings.without_length ? nct.probe_length[a] : 0);
}
bool is_rotation(VariableKind kind) { return kind == VariableKind::rotation || kind == VariableKind::rotation_extended; }

double* zero_field(Interpreter& m, const Found& f, int axis) {
  if (f.row->kind == VariableKind::zero_local) return m.modal.local.data() + axis;
  return (f.row->kind == VariableKind::zero_common ? m.tables.common : m.tables.zeros[system_of(f)]).data() + axis;
}

double read_plain(const Interpreter& m, const Found& f) {
  const Nct& n = nct_of(m);
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
    case VariableKind::spindle_speed: return n.spindle_rpm(m);
    case VariableKind::date: return date_number(n.clock);
    case VariableKind::time: return time_number(n.clock, n.now_ms);
    case VariableKind::parts_done: return n.state.parts_done;
    case VariableKind::parts_required: return n.parts_required;
    case VariableKind::single_block_lock: return row.bit < 0 ? n.control_1 : n.control_1 >> row.bit & 1u;
    case VariableKind::override_lock: return row.bit < 0 ? n.control_2 : n.control_2 >> row.bit & 1u;
    case VariableKind::mirror_state: return mirror_bits(m);
    case VariableKind::search_state: return search_bits(n, row.bit);
    case VariableKind::main_program: return number_of_file(m.flow.main_file());
    case VariableKind::modal_group: return modal_group(m, row.arg, f.index);
    case VariableKind::modal_word: return modal_word(m, row.arg);
    case VariableKind::tool_magazine: return n.tool_magazine;
    case VariableKind::zero_dynamic_number: return m.modal.work_zero < all_systems ? 0 : m.modal.work_zero - double(all_systems - 1);
    default: return 0;
  }
}

/// 0, 1, or between: 1 (23.2.1).
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

Status write_plain(Interpreter& m, const Found& f, double value, Span where) {
  Nct& n = nct_of(m);
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
    case VariableKind::tool_magazine:
      if (!ToolManagement::check_magazine(value)) return fail(alarm(AlarmId::magazine_number, where, value));
      n.tool_magazine = value;
      return {};
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

Axes length_in_force(const Interpreter& m) {
  const PartSpace* const space = space_of(m);
  if (space == nullptr || space->is_plain()) return m.frames.length;
  Axes length = m.frames.length;
  const Vec3 vector = space->length_now(m.position.machine);
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (const auto value = component(*space, a, vector); value) length[a] = *value;
  return length;
}

Result<double> read_variable(Interpreter& m, double number, Span where) {
  const auto meant = number_meant(m, number, where);
  if (!meant) return fail(meant.error());
  const auto n = whole_number(*meant, where);
  if (!n) return fail(n.error());
  if (double value = 0; nct_of(m).variables.known(*n, value)) return value;
  nct_of(m).endless.note_reading();
  const auto f = find(m.def, *n);
  if (!f) return fail(alarm(AlarmId::variable_unknown, where, *meant));
  if (const auto further = further_variable(*f->row, *n, f->index)) return read_further(m, *further);
  if (!f->row->read) return fail(alarm(AlarmId::variable_write_only, where, number));
  const VariableKind kind = f->row->kind;
  if (double* const field = offset_field(m, kind, f->index); field != nullptr) {
    return *field / register_unit(m, kind);
  }
  if (is_rotation(kind)) return *rotation_field(m, *f);
  const int axis = axis_of(m, f->index);
  if (is_zero(kind)) return axis < 0 ? 0.0 : shown(m, axis, *zero_field(m, *f, axis));
  if (kind >= VariableKind::end_position && kind <= VariableKind::distance_to_go) return axis_value(m, kind, axis);
  if (kind == VariableKind::tool_data)
    return nct_of(m).tools.spindle_data(static_cast<int>(nct_of(m).tool_magazine), static_cast<int>(*n)).value_or(vacant);
  if (kind == VariableKind::zero_dynamic_value) {
    const int of = axis_of(m, f->index);
    return of < 0 ? 0.0 : shown(m, of, dynamic_value(m, of));
  }
  if (kind == VariableKind::probe_position_5d) {
    const int of = axis_of(m, f->index);
    return of < 0 ? 0.0 : shown(m, of, probe_of_five_axes(m, f->row->arg == 1, of));
  }
  if (!f->row->works) return fail(alarm(AlarmId::not_available, where, "#" + std::to_string(*n)));
  return read_plain(m, *f);
}

Status write_variable(Interpreter& m, double number, double value, Span where) {
  const auto meant = number_meant(m, number, where);
  if (!meant) return fail(meant.error());
  const auto n = whole_number(*meant, where);
  if (!n) return fail(n.error());
  Nct& nct = nct_of(m);
  const auto plain = static_cast<int>(*n);
  if (plain >= 1 && plain <= static_cast<int>(most_locals)) {
    nct.variables.locals()[*n] = value;
    return {};
  }
  const bool is_protected = nct.settings.protect_high != 0 && plain >= nct.settings.protect_low && plain <= nct.settings.protect_high;
  if (plain >= first_common && plain <= last_common && !is_protected) {
    nct.variables.set_common(plain, value);
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
  nct.endless.note_change();
  if (is_vacant(value)) value = 0;  // only #1 … #999 can be empty
  const VariableKind kind = f->row->kind;
  if (double* const field = offset_field(m, kind, f->index); field != nullptr) {
    *field = value * register_unit(m, kind);
    nct.changed_offsets.push_back(f->index);
    return {};
  }
  if (is_rotation(kind) || is_zero(kind)) {
    const int axis = axis_of(m, f->index);
    if (is_zero(kind) && axis < 0) return {};  // another channel's axis
    if (!(std::fabs(value) <= farthest)) return fail(alarm(AlarmId::value_limit, where, value));
    (is_rotation(kind) ? *rotation_field(m, *f) : *zero_field(m, *f, axis)) = is_rotation(kind) ? value : kept(m, axis, value);
    nct.tables_changed = true;
    m.change_frames();
    return {};
  }
  return write_plain(m, *f, value, where);
}

Status set_start_value(Interpreter& m, double number, double value) {
  Nct& nct = nct_of(m);
  const auto n = whole_number(number, {});
  if (!n) return fail(n.error());
  const auto plain = static_cast<int>(*n);
  if (plain >= first_common && plain <= last_common) {
    nct.variables.set_common(plain, value);
    return {};
  }
  const auto f = find(m.def, *n);
  if (!f || is_vacant(value)) return write_variable(m, number, value, {});
  if (f->row->kind == VariableKind::plc_in) {
    const auto on = bit_value(value, {});
    if (!on) return fail(on.error());
    nct.plc_in[f->index] = *on ? 1 : 0;
    return {};
  }
  if (f->row->kind == VariableKind::plc_in_word) {
    if (f->index == 0) return write_word(nct.plc_in, value, {});
    nct.plc_in_word[f->index] = value;
    return {};
  }
  return write_variable(m, number, value, {});
}

Result<double> number_of_element(const Interpreter& m, double symbol, double index, Span where) {
  if (symbol == symbol_own_number)
    return VariableNames::is_named(index) ? fail(alarm(AlarmId::variable_unknown, where, index)) : Result<double>(index);
  const VariableName& name = m.def.grammar.symbols[static_cast<std::size_t>(symbol)];
  const double nearest = std::round(index);
  if (!(nearest >= name.first_index && nearest < name.first_index + name.count))
    return fail(alarm(AlarmId::value_out_of_range, where, std::string_view(name.text), index));
  return name.number + nearest - name.first_index;
}

Result<double> read_parameter(Interpreter& m, double number, double bit, double index, Span where) {
  const auto given = [](double v) { return is_vacant(v) ? std::optional<double>() : std::optional(v); };
  if (is_vacant(number)) return fail(alarm(AlarmId::expression_syntax, where, "PRM"));
  nct_of(m).endless.note_reading();
  return nct_of(m).parameters.read(number, given(bit), given(index), where);
}

}  // namespace kadr::nct
