// Converts the control's parameters into the settings of axes, frames, spindles and cycles. Used by control/fanuc/fanuc.

#include "control/fanuc/state/settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace kadr::fanuc {
namespace {

using macro_b::ParameterSource;

/// Returns the role of an axis, which N0103 gives. If N0103 is 0, an axis named X, Y or Z has the role of that name (2.1: basic
/// configuration).
int role_of(const std::string& name, int parameter) {
  if (parameter != 0) return parameter;
  return name == "X" ? 1 : name == "Y" ? 2 : name == "Z" ? 3 : 0;
}

void read_axes(Settings& s, const ParameterSource& p, const std::vector<std::string>& names,
               const std::array<std::uint8_t, max_axes>& numbers) {
  for (std::size_t a = 0; a < names.size() && a < max_axes; ++a) {
    AxisSettings& axis = s.axes[a];
    const int n = numbers[a];
    axis.diameter = p.bit("0106", "0", n);
    axis.switches_by_code = p.bit("0106", "5", n);
    axis.role = role_of(names[a], macro_b::whole_parameter(p.value("0103", n)));
    axis.rolls = p.bit("0107", "0", n);
    axis.shortest = p.bit("0107", "1", n);
    axis.by_sign = p.bit("0107", "2", n);
    axis.cuts_turns = p.bit("0107", "cut", n);
    const double period = p.value("0108", n);
    axis.period = period > 0 ? period : 360;
    axis.polar_offset = p.value("0217", n);
    axis.feed_most = p.value("0305", n);
    axis.reference = {p.value("0200", n), p.value("0201", n), p.value("0202", n), p.value("0203", n)};
  }
}

void read_spindles(Settings& s, const ParameterSource& p) {
  for (int n = 1; n <= static_cast<int>(max_spindles); ++n) {
    SpindleSettings& spindle = s.spindles[static_cast<std::size_t>(n)];
    spindle.orients = p.bit("0607", "1", n);
    spindle.indexes = p.bit("0607", "2", n);
    spindle.index_negative = p.bit("0607", "7", n);
    spindle.m_low = macro_b::whole_parameter(p.value("0689", n));
    spindle.m_high = macro_b::whole_parameter(p.value("0690", n));
    spindle.index_from = macro_b::whole_parameter(p.value("0820", n));
    spindle.index_count = macro_b::whole_parameter(p.value("0821", n));
    spindle.index_angle = p.value("0822", n);
    spindle.closing_code = macro_b::whole_parameter(p.value("0823", n));
  }
}

/// Reads the settings of a lathe (spec/fanuc-t 13).
void read_lathe(Settings& s, const ParameterSource& p, const std::vector<std::string>& names) {
  LatheSettings& l = s.lathe;
  l.is_lathe = true;
  s.compensates_nose = true;
  // The row of 1006#3 has one default for all axes, 1; only X is a diameter (spec/fanuc-t 1.3)
  for (std::size_t a = 0; a < names.size() && a < max_axes; ++a) s.axes[a].diameter = s.axes[a].diameter && names[a].starts_with('X');
  const auto on = [&](const char* meaning) { return p.value(meaning, 0) != 0; };
  l.corners_without_comma = on("corners_without_comma");
  l.offset_ends = on("offset_ends");
  constexpr int most_digits = 4;
  const int digits = std::clamp(macro_b::whole_parameter(p.value("offset_digits", 0)), 0, most_digits);
  l.offset_numbers = on("offset_one_digit") ? 10 : digits == 0 ? 100 : static_cast<std::uint32_t>(std::lround(std::pow(10, digits)));
  l.geometry_by_tool = on("geometry_by_tool");
  l.wear_shifts = on("wear_shifts");
  l.geometry_moves = on("geometry_moves");
  l.wear_waits = on("wear_waits");
  l.offsets_are_radii = on("offsets_are_radii");
  l.pecks_to_level = on("pecks_to_level");
  l.level_is_diameter = on("level_is_diameter");
  l.level_is_position = on("level_is_position") && on("one_block_format");
  l.tool_changer = on("tool_changer");
  l.turret_distance = p.value("turret_distance", 0) / 2;
  l.feed_per_minute = on("feed_per_minute");
  constexpr double percent_per_unit = 10;
  if (const double back = p.value("boring_back", 0); back > 0) l.boring_back_percent = percent_per_unit * back;
  l.clamp_code = macro_b::whole_parameter(p.value("clamp_code", 0));
  l.release_dwell = p.value("release_dwell", 0) / 1000;
  l.run_out = p.value("run_out", 0) / 10;
  if (const double angle = p.value("run_out_angle", 0); angle > 0) l.run_out_angle = angle;
}

/// Sets what the control of a Haas lathe decides without parameters, and reads its settings (spec/haas-st 1, 3, 5, 7.2, 11).
void read_haas_lathe(Settings& s, const ParameterSource& p, const std::vector<std::string>& names) {
  LatheSettings& l = s.lathe;
  l.is_haas = true;
  for (std::size_t a = 0; a < names.size() && a < max_axes; ++a) s.axes[a].diameter = names[a].starts_with('X');
  s.compensates_nose = true;
  s.approach = CompensationApproach::square;  // spec/haas-st 8
  l.wear_shifts = true;  // an offset takes effect with the next motion, and causes no motion of its own (spec/haas-st 3)
  l.is_yasnac = macro_b::whole_parameter(p.value("coordinates_of", 0)) == 2;
  l.inch_at_start = p.value("inch_at_start", 0) != 0;
  l.run_out = p.value("run_out_leads", 0);
  const double times = p.value("tap_back_times", 0);
  s.tap_override = times > 0;
  s.tap_extraction = 100 * times;
}

/// Reads the settings that only Fanuc and Haas have.
void read_frames_and_cycles(Settings& s, const ParameterSource& p) {
  s.drills_across = p.value("drills_across", 0) != 0;
  s.scale_unit = !p.has("scale_in_thousandths") ? 1 : p.value("scale_in_thousandths", 0) != 0 ? 1e-3 : 1e-5;
  s.scale_each = p.value("scale_each", 0) != 0;
  s.scale_usual = p.value("scale_usual", 0);
  s.rotation_adds = p.value("rotation_adds", 0) != 0;
  s.rotation_usual = p.value("rotation_usual", 0);
  s.holes_exact = p.value("holes_exact", 0) != 0;
  s.length_of_tool = p.value("length_of_tool", 0) != 0;
  s.shift_direction = macro_b::whole_parameter(p.value("shift_direction", 0));
  if (s.shift_direction == 1 || s.shift_direction == 3) s.shift_negative = true;
  if (s.shift_direction >= 2) s.shift_second = true;
  s.shift_is_global = macro_b::whole_parameter(p.value("coordinates_of", 0)) == 1;
  constexpr const char* mirrored[] = {"mirror_first", "mirror_second", "mirror_third", "mirror_fourth"};
  for (unsigned i = 0; i < 4; ++i)
    if (p.value(mirrored[i], 0) != 0) s.mirrored |= 1U << i;
  s.feed_whole = p.value("feed_whole", 0) != 0;
  s.feed_counts_increments = p.has("feed_whole") && !s.feed_whole;
  s.feed_in_thousandths = p.value("feed_in_thousandths", 0) != 0;
}

void read_interpretation(Settings& s, const ParameterSource& p) {
  const bool free_at_zero = p.has("arc_difference");  // a Fanuc does not check the radii if parameter 3410 is 0 (spec/fanuc 3.2)
  const double difference = p.value(free_at_zero ? "arc_difference" : "1339", 0);
  s.radius_difference = s.radius_shortfall = difference > 0 ? difference : 0.01;
  if (free_at_zero && !(difference > 0)) s.radius_difference = std::numeric_limits<double>::infinity();
  s.length_of_block = p.value("length_of_block", 0) != 0;
  s.arc_without_data_straight = p.has("arc_needs_data") && p.value("arc_needs_data", 0) == 0;
  s.angles_from_minus = p.value("angles_from_minus", 0) != 0;
  s.without_length = p.bit("1755", "6", 0);
  s.in_frame = p.bit("1755", "5", 0);
  s.offsets_are_diameters = p.value("offsets_are_diameters", 0) != 0;
  s.taps_rigid = p.value("taps_rigid", 0) != 0;
  s.shift_negative = p.value("shift_negative", 0) != 0;
  s.shift_second = p.value("shift_second", 0) != 0;
  s.return_rise = p.value("return_rise", 0);
  read_frames_and_cycles(s, p);
  s.dwell_seconds = p.bit("1337", "1", 0);
  s.centers_absolute = p.bit("1337", "2", 0);
  s.feed_along_helix = p.bit("1337", "3", 0);
  s.in_position_check = p.bit("1337", "PCH", 0);
  for (std::size_t i = 0; i < 8; ++i) s.default_1[i] = p.bit("1300", std::to_string(i).c_str(), 0);
  s.default_1[0] = s.default_1[0] || p.bit("1300", "G01", 0);
  s.default_per_rev = p.bit("1301", "0", 0);
  s.keeps_codes = p.bit("1301", "CLR", 0);
  for (std::size_t group = 1; group < s.kept_groups.size(); ++group) {
    const std::string name = std::string("C") + (group < 10 ? "0" : "") + std::to_string(group);
    s.kept_groups[group] = p.bit("CLRG", name.c_str(), 0);
  }
  const bool plane = p.bit("1416", "1", 0);
  s.length_axes = plane ? 2 : p.bit("1416", "0", 0) ? 1 : 0;
  s.turning_offsets = p.bit("1416", "2", 0);
  s.compensation_check.interference = p.bit("1403", "0", 0);
  s.compensation_check.always_alarm = p.bit("1403", "1", 0);
  s.compensation_check.further = static_cast<std::uint8_t>(std::clamp(macro_b::whole_parameter(p.value("1404", 0)), 0, 8));
  s.compensation_check.least_step = std::max(p.value("1405", 0), 0.0);
  s.skip_breaks_compensation = !p.bit("1337", "4", 0);
  if (p.has("approach_by_corner"))
    s.approach = p.value("approach_by_corner", 0) != 0 ? CompensationApproach::by_corner : CompensationApproach::square;
  s.approach_own_block = p.value("approach_own_block", 0) != 0;
}

void read_machine(Settings& s, const ParameterSource& p) {
  for (std::size_t i = 0; i < 16; ++i)
    s.m_groups[i] = {macro_b::whole_parameter(p.value(std::to_string(1341 + i).c_str(), 0)),
                     macro_b::whole_parameter(p.value(std::to_string(1357 + i).c_str(), 0))};
  s.part_code = macro_b::whole_parameter(p.value("2305", 0));
  s.change_on_m6 = p.bit("1338", "0", 0);
  s.default_spindle = macro_b::whole_parameter(p.value("0604", 0));
  s.surface_speed = p.value("0686", 0);
  s.css_axis = macro_b::whole_parameter(p.value("0687", 0));
  s.min_css_speed = p.value("0688", 0);
}

void read_repetitive(RepetitiveSettings& s, const ParameterSource& p) {
  s.depth = p.value("rough_depth", 0);
  s.back = p.value("rough_back", 0);
  s.clearance = p.value("rough_clearance", 0);
  s.relief = {p.value("pattern_relief_first", 0), p.value("pattern_relief_second", 0)};
  s.passes = p.value("pattern_passes", 0);
  s.reversal = {p.value("reversal_first", 0), p.value("reversal_second", 0)};
  s.leaves_out_first = p.value("rough_only_first", 0) != 0;
  s.leaves_out_second = p.value("rough_only_second", 0) != 0;
}

void read_cycles(Settings& s, const ParameterSource& p) {
  read_repetitive(s.repetitive, p);
  s.return_g73 = p.value("1500", 0);
  s.clearance_g83 = p.value("1501", 0);
  s.extraction = p.value("1502", 0);
  s.lathe_codes = p.bit("1503", "CSM", 0);
  s.tap_orients = p.bit("1503", "TSC", 0);
  s.tap_normal = p.bit("1503", "3", 0);
  s.tap_override = p.bit("1503", "4", 0);
  s.tap_return_override = p.bit("1503", "5", 0);
  s.tap_back = p.value("1504", 0);
  s.tap_clearance = p.value("1505", 0);
  s.tap_extraction = p.value("1506", 0);
  s.tap_return = p.value("1507", 0);
  s.measure_parameter_feed = p.bit("3001", "0", 0);
  s.length_parameter_feed = p.bit("3003", "0", 0);
  s.length_wear = p.bit("3003", "1", 0);
  s.length_adds = p.bit("3003", "2", 0);
  s.measure_feed = p.value("0311", 0);
  s.length_feed = p.value("0312", 0);
  s.length_rapid = p.value("3004", 0);
  s.length_alarm = p.value("3005", 0);
  s.accuracy = p.value("3103", 0);
}

/// Returns the unit vector of an axis of rotation from its code 1 … 6 and its inclination in degrees (25.1, spec/nct/25a 3).
Vec3 joint_direction(int code, double inclination) {
  const SinCos lean = sincos_deg(inclination);
  switch (code) {
    case 1: return {1, 0, 0};
    case 2: return {0, 1, 0};
    case 4: return {lean.cos, lean.sin, 0};
    case 5: return {0, lean.cos, lean.sin};
    case 6: return {lean.sin, 0, lean.cos};
    default: return {0, 0, 1};
  }
}

/// Reads the machine's kinematics (25.1). INFERRED: N3200 = 1 means two rotary axes in the head, N3200 = 0 a machine without five axes.
/// INFERRED: N3201 has the same codes as N3205, and N3201 = 0 means Z.
void read_five_axis(Settings& s, const ParameterSource& p, const std::array<std::uint8_t, max_axes>& numbers, std::size_t count) {
  const auto joint = [&](int number, const char* reversed) {
    RotaryJoint j;
    const int axis = macro_b::whole_parameter(p.value(std::to_string(number).c_str(), 0));
    for (std::size_t a = 0; a < count && axis > 0; ++a)
      if (numbers[a] == axis) j.axis = static_cast<int>(a);
    j.direction = joint_direction(macro_b::whole_parameter(p.value(std::to_string(number + 1).c_str(), 0)),
                                  p.value(std::to_string(number + 2).c_str(), 0));
    j.sense = p.bit("3212", reversed, 0) ? -1 : 1;
    return j;
  };
  const auto vector = [&](int number) {
    const auto at = [&](int i) { return p.value(std::to_string(number + i).c_str(), 0); };
    return Vec3{at(0), at(1), at(2)};
  };
  FiveAxis& f = s.five_axis;
  const int group = macro_b::whole_parameter(p.value("3200", 0));
  f.first = joint(3204, "RD1");
  f.second = joint(3208, "RD2");
  const bool has_axes = f.first.axis >= 0 && f.second.axis >= 0 && f.first.axis != f.second.axis;
  f.group = group >= 1 && group <= 3 && has_axes ? static_cast<MachineGroup>(group) : MachineGroup::none;
  const int tool = macro_b::whole_parameter(p.value("3201", 0));
  f.tool = joint_direction(tool == 1 || tool == 2 ? tool : 3, 0);
  f.table = vector(3213);
  if (f.group == MachineGroup::table_table) f.second_table = vector(3216);
  f.holder = vector(3219);
  if (f.group == MachineGroup::head_head) f.head = vector(3222);
  s.keeps_linear = p.bit("3212", "7", 0);
  s.tilts_tool = p.bit("3212", "4", 0);
}

}  // namespace

Settings read_settings(const ParameterSource& source, const std::vector<std::string>& axis_names,
                       const std::array<std::uint8_t, max_axes>& axis_numbers, Lathe lathe) {
  Settings s;
  read_axes(s, source, axis_names, axis_numbers);
  if (lathe != Lathe::none) read_lathe(s, source, axis_names);
  read_spindles(s, source);
  read_interpretation(s, source);
  read_machine(s, source);
  read_cycles(s, source);
  read_five_axis(s, source, axis_numbers, std::min(axis_names.size(), max_axes));
  if (lathe == Lathe::haas) read_haas_lathe(s, source, axis_names);
  return s;
}

}  // namespace kadr::fanuc
