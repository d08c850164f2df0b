// System variables for positions, offsets, work systems and the spindle (spec/nct/23 23.1.5, 23.1.15 to 23.1.22; 25.4, 25.19). Used by
// control/macro_b/variables/system_variables.

#include "control/fanuc/tables/table_variables.h"

#include <cmath>
#include <utility>

#include "base/units.h"
#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/words/coordinates.h"
#include "kinematics/five_axis_transform.h"

namespace kadr::fanuc {
namespace {

/// Returns the index in the channel of the axis with this number; the numbers count the axes of all channels. Returns -1 if the axis
/// belongs to another channel or does not exist.
int axis_of(const BlockContext& m, std::uint32_t number) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (m.def.axis_numbers[a] == number) return static_cast<int>(a);
  return -1;
}

/// Converts a position from mm to the value that the program reads, which has the unit in force and is a diameter in diameter programming.
/// stored_value() does the inverse.
double shown(const BlockContext& m, int axis, double mm) {
  if ((m.def.rotary >> axis & 1u) != 0) return mm;
  const double v = (m.modal.diameter >> axis & 1u) != 0 ? 2 * mm : mm;
  return m.modal.inch ? v / mm_per_inch : v;
}

double stored_value(const BlockContext& m, int axis, double value) {
  if ((m.def.rotary >> axis & 1u) != 0) return value;
  const double mm = m.modal.inch ? value * mm_per_inch : value;
  return (m.modal.diameter >> axis & 1u) != 0 ? mm / 2 : mm;
}

Vec3 main_axes_of(const FiveAxisTransform& space, const Axes& axes) {
  const auto& main = space.data().main;
  const auto of = [&](std::size_t i) { return main[i] < 0 ? 0.0 : axes[static_cast<std::size_t>(main[i])]; };
  return {of(0), of(1), of(2)};
}

/// Returns the component of a vector along an axis; nullopt if the axis is not one of the main axes X, Y, Z.
std::optional<double> component(const FiveAxisTransform& space, std::size_t axis, Vec3 v) {
  const double values[] = {v.x, v.y, v.z};
  for (std::size_t i = 0; i < 3; ++i)
    if (space.data().main[i] == static_cast<std::int8_t>(axis)) return values[i];
  return std::nullopt;
}

/// Returns a tool position as system variables report it (25.19): in the work system or in the programming frame, with or without the
/// tool length.
double position_of_variable(const BlockContext& m, std::size_t axis, const Axes& work, const Axes& length, bool in_frame) {
  const bool with_length = !fanuc_of(m).settings.without_length;
  const FiveAxisTransform* const space = space_of(m);
  if (space == nullptr || space->is_plain()) return work[axis] + (with_length ? length[axis] : 0);
  Vec3 at = space->in_system(main_axes_of(*space, work));
  if (with_length) at = at + main_axes_of(*space, length);
  if (in_frame && space->has_frame()) at = space->in_frame(at);
  return component(*space, axis, at).value_or(work[axis]);
}

/// Returns the position or tool length of an axis, as a system variable reports it; 0 for an axis of another channel.
double axis_value(const BlockContext& m, VariableKind kind, int axis) {
  if (axis < 0) return 0;
  const auto a = static_cast<std::size_t>(axis);
  const Fanuc& fanuc = fanuc_of(m);
  const double length = length_in_force(m)[a];
  const bool in_frame = fanuc.settings.in_frame;
  switch (kind) {
    case VariableKind::end_position: return shown(m, axis, before_transform(m)[a]);
    case VariableKind::machine_position: return shown(m, axis, m.position.machine[a]);
    case VariableKind::work_position: return shown(m, axis, position_of_variable(m, a, m.position.work, length_in_force(m), in_frame));
    case VariableKind::probe_position:
      return shown(m, axis, position_of_variable(m, a, fanuc.probe_position, fanuc.probe_length, in_frame));
    case VariableKind::length_in_force: return shown(m, axis, length);
    default: return 0;  // servo lag, distance to go and handwheel shift are always 0 on the virtual machine
  }
}

/// Returns the value in the offset table that a system variable reads and writes; nullptr if the table has no row with this number.
double* offset_field(BlockContext& m, VariableKind kind, std::uint32_t number) {
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

/// Returns the factor that converts the value of an offset variable to the value in the offset table: the number of mm per unit, halved for
/// a diameter (spec/haas 2.4).
double register_unit(const BlockContext& m, VariableKind kind) {
  if (kind == VariableKind::offset_tip) return 1;
  const bool radius = kind == VariableKind::offset_radius || kind == VariableKind::offset_radius_wear;
  const LatheSettings& lathe = fanuc_of(m).settings.lathe;
  // On a lathe the table holds radii, and the program reads and writes offsets of X as diameters (spec/fanuc-t 3.1, 4.4)
  const bool along_x = kind == VariableKind::offset_x || kind == VariableKind::offset_x_wear;
  const int x = main_axis(m, 1);
  if (lathe.is_lathe && along_x && !lathe.offsets_are_radii && x >= 0 && is_diameter(m, static_cast<std::size_t>(x)))
    return (m.modal.inch ? mm_per_inch : 1) * 0.5;
  return (m.modal.inch ? mm_per_inch : 1) * (radius && fanuc_of(m).settings.offsets_are_diameters ? 0.5 : 1);
}

/// Returns the index of the work system that a variable belongs to (work offsets and basic rotations).
std::size_t system_of(const FoundVariable& f) {
  const bool extended = f.row->kind == VariableKind::zero_extended || f.row->kind == VariableKind::rotation_extended;
  if (f.row->kind == VariableKind::zero_dynamic) return all_systems - 1 + f.family;
  return extended ? basic_systems + f.family : static_cast<std::size_t>(f.row->arg);
}

double* rotation_field(BlockContext& m, const FoundVariable& f) {
  Vec3& angles = m.tables.rotations[system_of(f)];
  return f.index == 1 ? &angles.x : f.index == 2 ? &angles.y : &angles.z;
}

bool is_zero(VariableKind kind) {
  return kind == VariableKind::zero || kind == VariableKind::zero_common || kind == VariableKind::zero_extended ||
         kind == VariableKind::zero_dynamic || kind == VariableKind::zero_local;
}

bool is_rotation(VariableKind kind) { return kind == VariableKind::rotation || kind == VariableKind::rotation_extended; }

/// Returns #5501 … (25.4): the dynamic offset at the present position of the rotary table. For a rotary axis, returns the offset in the
/// table of dynamic offsets.
double dynamic_value(const BlockContext& m, int axis) {
  const FiveAxisTransform* const space = space_of(m);
  if (axis < 0 || space == nullptr || m.modal.work_zero < all_systems) return 0;
  const auto a = static_cast<std::size_t>(axis);
  return component(*space, a, space->origin_now(m.position.machine)).value_or(m.tables.zeros[m.modal.work_zero][a]);
}

/// Returns the probe position. #151001 … report it in the frame that #5061 … do not use: the work system or the programming frame. #151101
/// … report machine positions (25.19).
double probe_of_five_axes(const BlockContext& m, bool of_machine, int axis) {
  if (axis < 0) return 0;
  const auto a = static_cast<std::size_t>(axis);
  const Fanuc& fanuc = fanuc_of(m);
  if (!of_machine) return position_of_variable(m, a, fanuc.probe_position, fanuc.probe_length, !fanuc.settings.in_frame);
  return fanuc.probe_machine[a] - (fanuc.settings.without_length ? fanuc.probe_length[a] : 0);
}

double* zero_field(BlockContext& m, const FoundVariable& f, int axis) {
  if (f.row->kind == VariableKind::zero_local) return m.modal.local.data() + axis;
  return (f.row->kind == VariableKind::zero_common ? m.tables.common : m.tables.zeros[system_of(f)]).data() + axis;
}

}  // namespace

Axes length_in_force(const BlockContext& m) {
  const FiveAxisTransform* const space = space_of(m);
  if (space == nullptr || space->is_plain()) return m.frames.length;
  Axes length = m.frames.length;
  const Vec3 vector = space->length_now(m.position.machine);
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (const auto value = component(*space, a, vector); value) length[a] = *value;
  return length;
}

std::optional<double> Fanuc::table_value(Emitter& m, const FoundVariable& f) const {
  const VariableKind kind = f.row->kind;
  if (double* const field = offset_field(m, kind, f.index); field != nullptr) return *field / register_unit(m, kind);
  if (is_rotation(kind)) return *rotation_field(m, f);
  const int axis = axis_of(m, f.index);
  if (is_zero(kind)) return axis < 0 ? 0.0 : shown(m, axis, *zero_field(m, f, axis));
  if (kind >= VariableKind::end_position && kind <= VariableKind::distance_to_go) return axis_value(m, kind, axis);
  if (kind == VariableKind::zero_dynamic_value) return axis < 0 ? 0.0 : shown(m, axis, dynamic_value(m, axis));
  if (kind == VariableKind::probe_position_5d) return axis < 0 ? 0.0 : shown(m, axis, probe_of_five_axes(m, f.row->arg == 1, axis));
  if (!f.row->works) return std::nullopt;
  if (kind == VariableKind::spindle_speed) return spindle_rpm(m);
  if (kind == VariableKind::zero_dynamic_number) return m.modal.work_zero < all_systems ? 0 : m.modal.work_zero - double(all_systems - 1);
  return std::nullopt;
}

Result<bool> Fanuc::write_table(Emitter& m, const FoundVariable& f, double value, Span where) {
  const VariableKind kind = f.row->kind;
  if (double* const field = offset_field(m, kind, f.index); field != nullptr) {
    *field = value * register_unit(m, kind);
    changed_offsets.push_back(f.index);
    return true;
  }
  if (!is_rotation(kind) && !is_zero(kind)) return false;
  const int axis = axis_of(m, f.index);
  if (is_zero(kind) && axis < 0) return true;  // a value that is written to the work offset of an axis of another channel is ignored
  if (!(std::fabs(value) <= farthest)) return fail(alarm(AlarmId::value_limit, where, value));
  (is_rotation(kind) ? *rotation_field(m, f) : *zero_field(m, f, axis)) = is_rotation(kind) ? value : stored_value(m, axis, value);
  tables_changed = true;
  m.change_frames();
  return true;
}

bool Fanuc::consume_touched_tables() {
  const bool touched = std::exchange(tables_changed, false);
  return !std::exchange(changed_offsets, {}).empty() || touched;
}

}  // namespace kadr::fanuc
