// Work offsets and their rotation, G92 and G52, tool lengths, reference positions, G10 (spec/linuxcnc 7.4, 7.8).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/code_literals.h"
#include "base/units.h"
#include "base/vec.h"
#include "control/emitter.h"
#include "control/functions/functions.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

constexpr std::array<std::string_view, 9> systems = {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
constexpr std::uint32_t first_system = 5221, numbers_of_system = 20, place_of_rotation = 9;
constexpr std::uint32_t first_home = 5161, first_second_home = 5181;

std::uint32_t system_at(std::uint32_t number) { return first_system + (number - 1) * numbers_of_system; }

/// Calls `use` for each axis word, with the axis and the word's value in mm or degrees. The value of a diameter X is halved.
template <class Use>
void each_word(const BlockContext& m, Use use) {
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const char letter = m.letters.axis_letter[a];
    if (letter == 0 || !m.has(letter)) continue;
    const bool is_length = m.def.address(letter).unit == WordUnit::length;
    const double half = (m.modal.diameter >> a & 1U) != 0 ? 0.5 : 1;
    use(a, m.value(letter) * (is_length ? m.unit_scale() : 1) * half);
  }
}

void set(BlockContext& m, std::uint32_t number, double value) { m.variables.set_raw(number, value); }

/// Returns the position `at`, rotated by `degrees` about Z.
Axes turned_by(const Axes& at, double degrees) {
  if (degrees == 0) return at;
  const SinCos by = sincos_deg(degrees);
  Axes to = at;
  to[0] = at[0] * by.cos - at[1] * by.sin;
  to[1] = at[0] * by.sin + at[1] * by.cos;
  return to;
}

Axes sum(const Axes& a, const Axes& b, double sign = 1) {
  Axes c{};
  for (std::size_t i = 0; i < max_axes; ++i) c[i] = a[i] + sign * b[i];
  return c;
}

/// Refuses a code that is not allowed under cutter compensation (spec/linuxcnc 7.5). `text`: text of the alarm.
Status not_compensating(const BlockContext& m, Span where, const char* text) {
  if (m.modal.radius_side == 0) return {};
  return linuxcnc_of(m).fault(AlarmId::rs274_compensation, where, text);
}

/// G10 L2, L20: writes the offset of a work system. `by_position` is true for L20: the present position gets the coordinates of the words.
Status write_system(Emitter& m, const kadr::Call& call, bool by_position) {
  LinuxCnc& control = linuxcnc_of(m);
  const double p = m.has('P') ? std::round(m.value('P')) : 0;
  const std::uint32_t number = p == 0 ? control.state.system_number : static_cast<std::uint32_t>(p);
  const bool in_force = number == control.state.system_number;
  if (in_force) KADR_TRY(not_compensating(m, call.where, "Cannot change the active coordinate system with cutter radius compensation on"));
  const std::uint32_t first = system_at(number);
  if (m.has('R')) set(m, first + place_of_rotation, m.value('R'));
  const double rotation = m.variables.raw(first + place_of_rotation);
  if (by_position) {  // by this equation: machine position = R·(value + shift) + offset + length
    Axes reads = turned_by(sum(m.position.machine, sum(control.system_offset(m, number), control.state.length), -1), -rotation);
    reads = sum(reads, control.state.shift, -1);
    each_word(m, [&](std::size_t a, double v) { reads[a] = v; });
    const Axes offset = sum(sum(m.position.machine, control.state.length, -1), turned_by(sum(reads, control.state.shift), rotation), -1);
    const bool turns = rotation != 0 && (m.has('X') || m.has('Y'));
    each_word(m, [&](std::size_t a, double) { control.store_axis(m, first, a, offset[a]); });
    if (turns)
      for (const std::size_t a : {0U, 1U}) control.store_axis(m, first, a, offset[a]);
  } else {
    each_word(m, [&](std::size_t a, double v) { control.store_axis(m, first, a, v); });
  }
  (void)m.variables.consume_frames_changed();
  if (in_force) control.take_system(m, number);
  return {};
}

/// G10 L1, L10, L11 (`kind`): writes a row of the tool table.
Status write_tool(BlockContext& m, int kind) {
  LinuxCnc& control = linuxcnc_of(m);
  const int number = static_cast<int>(std::round(m.value('P')));
  if (control.tool(number) == nullptr)
    return control.fault(AlarmId::rs274_tool, m.where('P'), fmt::format("Requested tool {} not found in the tool table", number));
  Tool& tool = control.tool_to_write(m, number);
  if (m.has('R')) tool.diameter = 2 * m.length_value('R');
  if (m.has('I')) tool.front = m.value('I');
  if (m.has('J')) tool.back = m.value('J');
  if (m.has('Q')) tool.orientation = std::round(m.value('Q'));
  if (kind == 1) {
    each_word(m, [&](std::size_t a, double v) { tool.offset[a] = v; });
    return {};
  }
  constexpr std::uint32_t fixture = 9;  // L11: the present position is taken in the work system G59.3
  const Axes origin = kind == 10 ? control.state.system : control.system_offset(m, fixture);
  const double rotation = kind == 10 ? control.state.rotation : m.variables.raw(system_at(fixture) + place_of_rotation);
  const Axes shift = kind == 10 ? control.state.shift : Axes{};
  Axes reads = sum(turned_by(sum(m.position.machine, origin, -1), -rotation), shift, -1);
  each_word(m, [&](std::size_t a, double v) { reads[a] = v; });
  const Axes offset = sum(sum(m.position.machine, origin, -1), turned_by(sum(reads, shift), rotation), -1);
  each_word(m, [&](std::size_t a, double) { tool.offset[a] = offset[a]; });
  return {};
}

void take_length(Emitter& m, const Axes& length) {
  linuxcnc_of(m).state.length = length;
  m.change_frames();
}

/// Returns the tool lengths for G43 or G43.2. They are the lengths of tool H; without H, those of the tool in the spindle.
Result<Axes> length_of_tool(BlockContext& m, Span where) {
  LinuxCnc& control = linuxcnc_of(m);
  const double number = m.has('H') && std::round(m.value('H')) != 0 ? std::round(m.value('H')) : m.modal.tool;
  if (number == 0) return Axes{};
  const Tool* const tool = control.tool(number);
  if (tool == nullptr)
    return control.fault(AlarmId::rs274_tool, where, fmt::format("Requested tool {:.0f} not found in the tool table", number));
  m.modal.length_number = static_cast<std::uint32_t>(std::max(number, 0.0));
  return tool->offset;
}

constexpr const char* no_length_change = "Cannot change tool offset with cutter radius compensation on";

}  // namespace

/// Applies the new tool's length after a tool change while G43 is in force (RETAIN_G43). If the spindle is empty, the length is 0.
void LinuxCnc::retain_length(Emitter& m) {
  const bool by_table = std::any_of(m.modal.rows.begin(), m.modal.rows.end(), [&](std::int16_t row) {
    return row >= 0 && m.def.codes[static_cast<std::size_t>(row)].letter == 'G' && m.def.codes[static_cast<std::size_t>(row)].tenth == 43_g;
  });
  if (!machine.keeps_length || !by_table) return;
  const Tool* const loaded = m.modal.tool == 0 ? nullptr : tool(m.modal.tool);
  m.modal.length_number = loaded == nullptr ? 0 : m.modal.tool;
  take_length(m, loaded == nullptr ? Axes{} : loaded->offset);
}

const Tool* LinuxCnc::tool(double number) const {
  static const Tool unknown;
  const auto found = tools.find(static_cast<int>(number));
  return found != tools.end() ? &found->second : table_is_known || number < 0 ? nullptr : &unknown;
}

Tool& LinuxCnc::tool_to_write(BlockContext& m, int number) {
  Tool& tool = tools[number];
  m.journal.on_undo([this, &tool, before = tool, changed = tools_changed] {
    tool = before;
    tools_changed = changed;
  });
  tools_changed = true;
  return tool;
}

Axes LinuxCnc::stored_axes(const BlockContext& m, std::uint32_t first) const {
  Axes values{};
  for (std::uint32_t a = 0; a < axes_of_tables && a < m.axis_count; ++a) values[a] = m.variables.raw(first + a) * table_unit(a);
  return values;
}

void LinuxCnc::store_axis(BlockContext& m, std::uint32_t first, std::size_t axis, double value) const {
  m.variables.set_raw(first + static_cast<std::uint32_t>(axis), value / table_unit(axis));
}

/// Copies work offsets with their rotations, and reference points, from the set-up (in mm and degrees) to parameters (in the machine's
/// unit).
void LinuxCnc::take_tables(BlockContext& m, const Setup& setup) {
  const auto store = [&](std::uint32_t first, const AxisValues& values) {
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if (const auto at = values.find(m.axis_names[a]); at != values.end()) store_axis(m, first, a, at->second);
  };
  for (const auto& [name, offset] : setup.work_offsets) {
    const auto found = std::find(systems.begin(), systems.end(), name);
    if (found == systems.end()) continue;
    const std::uint32_t first = system_at(1 + static_cast<std::uint32_t>(found - systems.begin()));
    store(first, offset);
    if (const auto angle = offset.find("G17"); angle != offset.end()) m.variables.set_raw(first + place_of_rotation, angle->second);
  }
  for (const auto& [number, point] : setup.reference_points)
    if (number == 1 || number == 2) store(number == 1 ? first_home : first_second_home, point);
}

/// Adds the tools and the work offsets to a set-up, in the form that take_tables() reads. The tool lengths added here include wear.
bool LinuxCnc::add_tables(const BlockContext& m, Setup& tables) const {
  for (const auto& [number, tool] : tools) {
    ToolOffset& offset = tables.offsets[number];
    offset.length_x = tool.offset[0], offset.length_y = tool.offset[1], offset.length = tool.offset[2];
    offset.radius = tool.diameter / 2, offset.tip_position = tool.orientation;
  }
  for (std::uint32_t i = 0; i < systems.size(); ++i) {
    const Axes zero = system_offset(m, i + 1);
    const double angle = m.variables.raw(system_at(i + 1) + place_of_rotation);
    if (zero == Axes{} && angle == 0) continue;
    AxisValues& values = tables.work_offsets[std::string(systems[i])];
    for (std::size_t a = 0; a < m.axis_count; ++a) values[m.axis_names[a]] = zero[a];
    if (angle != 0) values["G17"] = angle;
  }
  return true;
}

Axes LinuxCnc::system_offset(const BlockContext& m, std::uint32_t number) const { return stored_axes(m, system_at(number)); }

void LinuxCnc::take_system(Emitter& m, std::uint32_t number) {
  state.system_number = number;
  state.system = system_offset(m, number);
  state.rotation = m.variables.raw(system_at(number) + place_of_rotation);
  m.change_frames();
}

void LinuxCnc::store_shift(BlockContext& m) {
  set(m, shift_on_number, state.shift_on ? 1 : 0);
  for (std::size_t a = 0; a < axes_of_tables && a < m.axis_count; ++a) store_axis(m, first_shift, a, state.shift[a]);
  (void)m.variables.consume_frames_changed();
}

/// Computes the frames: machine position = R·(work position + shift of G92) + work offset + tool length. R is the rotation of the work
/// system about Z (spec/linuxcnc 7.8).
void LinuxCnc::refresh_frames(Emitter& m) {
  m.frames.length = state.length;
  if (state.rotation == 0) {
    m.frames.origin = sum(state.system, state.shift);
    m.frames.shift = {};
    m.frames.turn = nullptr;
    return;
  }
  m.frames.origin = state.system;
  m.frames.shift = state.shift;
  const SinCos by = sincos_deg(state.rotation);
  FrameTurn turn;
  turn.rows = {Vec3{by.cos, -by.sin, 0}, Vec3{by.sin, by.cos, 0}, Vec3{0, 0, 1}};
  if (!m.frames.turn || !(*m.frames.turn == turn)) m.frames.turn = std::make_shared<const FrameTurn>(turn);
}

}  // namespace kadr::linuxcnc

namespace kadr::functions {

using linuxcnc::linuxcnc_of;

/// G10: writes a table (spec/linuxcnc 7.8).
Status table_data(Emitter& m, const Call& call) {
  const int kind = static_cast<int>(std::round(m.value('L')));
  if (kind == 2 || kind == 20) return linuxcnc::write_system(m, call, kind == 20);
  if (kind == 0) return {};  // G10 L0 reads the tool table file again; the table is still that of the set-up, so nothing changes
  return linuxcnc::write_tool(m, kind);
}

/// G92 (arg 0), G52 (arg 1): shift the work system.
Status coordinate_shift(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  KADR_TRY(linuxcnc::not_compensating(m, call.where, "Cannot change axis offsets with cutter radius comp"));
  const bool is_amount = call.row->arg == 1;
  linuxcnc::each_word(
      m, [&](std::size_t a, double v) { control.state.shift[a] = is_amount ? v : m.position.programmed[a] + control.state.shift[a] - v; });
  control.state.shift_on = true;
  control.store_shift(m);
  m.change_frames();
  return {};
}

/// G92.1 to G92.3: cancel the shift of G92 or restore it. arg: the digit after the point.
Status coordinate_shift_off(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  KADR_TRY(linuxcnc::not_compensating(m, call.where, "Cannot change axis offsets with cutter radius comp"));
  if (call.row->arg == 3) {
    control.state.shift = control.stored_axes(m, linuxcnc::first_shift);
    control.state.shift_on = true;
    linuxcnc::set(m, linuxcnc::shift_on_number, 1);
  } else {
    control.state.shift = {};
    control.state.shift_on = false;
    if (call.row->arg == 1) control.store_shift(m);
    else linuxcnc::set(m, linuxcnc::shift_on_number, 0);
  }
  (void)m.variables.consume_frames_changed();
  m.change_frames();
  return {};
}

/// G54 to G59.3: select a work system. arg: its number, 1 to 9.
Status table_system(Emitter& m, const Call& call) {
  KADR_TRY(linuxcnc::not_compensating(m, call.where, "Cannot change coordinate systems with cutter radius compensation on"));
  const auto number = static_cast<std::uint32_t>(call.row->arg);
  if (number == linuxcnc_of(m).state.system_number && !m.program().ended()) return {};
  m.modal.fixture = number;
  linuxcnc::set(m, linuxcnc::system_number, number);
  (void)m.variables.consume_frames_changed();
  linuxcnc_of(m).take_system(m, number);
  return {};
}

/// G28, G30 (arg 1, 2): moves first to the point of the axis words, then to the stored position.
Status reference_move(Emitter& m, const Call& call) {
  KADR_TRY(linuxcnc::not_compensating(m, call.where, "Cannot use g28 or g30 with cutter radius comp"));
  const std::uint32_t first = call.row->arg == 1 ? linuxcnc::first_home : linuxcnc::first_second_home;
  AxisMask named = 0;
  if (m.has_axis_words()) {
    Axes through;
    KADR_TRY(m.target(through, named));
    KADR_TRY(m.straight(MotionKind::rapid, through, named));
  }
  if (named == 0) {  // LinuxCNC first makes a motion of length zero
    named = (AxisMask{1} << m.axis_count) - 1;
    KADR_TRY(m.straight(MotionKind::rapid, m.position.programmed, named));
  }
  const Axes there = m.frames.work_of(linuxcnc_of(m).stored_axes(m, first));
  Axes to = m.position.programmed;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((named >> a & 1U) != 0) to[a] = there[a];
  KADR_TRY(m.straight(MotionKind::rapid, to, named));
  std::get<Motion>(m.batch->back().what).end_reference = call.row->arg == 1 ? EndReference::reference_1 : EndReference::reference_2;
  return {};
}

/// G28.1, G30.1 (arg 1, 2): store the present machine position.
Status reference_store(Emitter& m, const Call& call) {
  KADR_TRY(linuxcnc::not_compensating(m, call.where, "Cannot set reference point with cutter compensation in effect"));
  const std::uint32_t first = call.row->arg == 1 ? linuxcnc::first_home : linuxcnc::first_second_home;
  for (std::size_t a = 0; a < m.axis_count; ++a) linuxcnc_of(m).store_axis(m, first, a, m.position.machine[a]);
  (void)m.variables.consume_frames_changed();
  return {};
}

/// G43 (arg 0), G43.2 (arg 1): apply the lengths of a tool in the tool table. G43.2 adds these lengths to the lengths in force.
Status tool_length(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  KADR_TRY(linuxcnc::not_compensating(m, call.where, linuxcnc::no_length_change));
  if (call.row->arg == 1) {
    const bool words = m.has_axis_words() && control.codes.motion < 0;
    if (m.has('H') && m.has_axis_words())
      return control.fault(AlarmId::rs274_tool, call.where, "G43.2: Can not have both H and axis words");
    if (!m.has('H') && !words) return control.fault(AlarmId::rs274_tool, call.where, "G43.2: No axes specified and H word missing");
    if (words) {  // G43.2 adds the values of its axis words to the lengths in force (LinuxCNC 2.9.3)
      Axes more{};
      linuxcnc::each_word(m, [&](std::size_t a, double v) { more[a] = v; });
      linuxcnc::take_length(m, linuxcnc::sum(control.state.length, more));
      return {};
    }
  }
  const auto length = linuxcnc::length_of_tool(m, call.where);
  if (!length) return fail(length.error());
  linuxcnc::take_length(m, call.row->arg == 1 ? linuxcnc::sum(control.state.length, *length) : *length);
  return {};
}

/// G43.1: the axis words are the tool lengths.
Status tool_length_by_words(Emitter& m, const Call& call) {
  KADR_TRY(linuxcnc::not_compensating(m, call.where, linuxcnc::no_length_change));
  Axes length = linuxcnc_of(m).state.length;
  if (linuxcnc_of(m).codes.motion < 0) linuxcnc::each_word(m, [&](std::size_t a, double v) { length[a] = v; });
  linuxcnc::take_length(m, length);
  return {};
}

/// G49: the tool lengths are 0.
Status tool_length_off(Emitter& m, const Call& call) {
  KADR_TRY(linuxcnc::not_compensating(m, call.where, linuxcnc::no_length_change));
  m.modal.length_number = 0;
  linuxcnc::take_length(m, {});
  return {};
}

}  // namespace kadr::functions
