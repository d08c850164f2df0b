// The Fanuc family at power-on, when it reads a set-up, and at the end of a program (spec/nct/03, 13, 24), and how its state is saved and
// restored for alarms and snapshots. Used by control/nct/nct.

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/code_literals.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/frames/transformations.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "control/interpreter.h"

namespace kadr::fanuc {
namespace {

/// Returns the number in the name of a modal group; 0 if the group is not a numbered group of G codes.
int group_number(const GroupRow& group) {
  const bool digits = !group.name.empty() && group.name.find_first_not_of("0123456789") == std::string::npos;
  return digits ? std::stoi(group.name) : 0;
}

/// Returns the initial code of a modal group of a lathe, in tenths (spec/fanuc-t 1.2). The groups have other numbers than those of a mill.
std::int32_t initial_lathe_code(const BlockContext& m, const Settings& s, int group, std::int32_t otherwise) {
  switch (group) {
    case 1: return s.default_1[0] ? 1_g : 0_g;
    case 3: return s.default_1[7] ? 91_g : 90_g;
    case 5:
      for (const CodeRow& row : m.def.codes)
        if (s.lathe.feed_per_minute && row.function == Function::feed_per_minute) return row.tenth;
      return otherwise;
    case 6: return s.lathe.inch_at_start ? 20_g : otherwise;
    default: return otherwise;
  }
}

/// Returns the initial code of a modal group, in tenths (3.3).
std::int32_t initial_code(const BlockContext& m, const Settings& s, int group, std::int32_t otherwise) {
  if (s.lathe.is_lathe) return initial_lathe_code(m, s, group, otherwise);
  switch (group) {
    case 1: return s.default_1[0] ? 1_g : 0_g;
    case 2: return s.default_1[1] ? 18_g : s.default_1[2] ? 19_g : 17_g;
    case 3: return s.default_1[7] ? 91_g : 90_g;
    case 5: return s.default_per_rev ? 95_g : 94_g;
    case 6: return s.default_1[3] ? 20_g : 21_g;
    case 8: return s.default_1[5] ? 43_g : s.default_1[6] ? 44_g : 49_g;
    default: return otherwise;
  }
}

void reset_shifts(BlockContext& m) {
  reset_five_axis(m);
  m.modal.new_system = {};
  if (!fanuc_of(m).settings.shift_is_global) m.modal.local = {};  // spec/haas 5.3: with setting 33 on, a reset keeps the shift of G52
  m.modal.surface = PathSurface::plane;
  m.modal.smoothing = 0;
  m.modal.diameter = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (fanuc_of(m).settings.axes[a].diameter) m.modal.diameter |= 1u << a;
}

}  // namespace

/// Puts the initial code of every modal group into force. `keep`: true if a group keeps its code when its bit in CLR G Table is set.
void Fanuc::reset_codes(Interpreter& m, bool keep) {
  const Settings& s = settings;
  plane_axes = 0;
  Block* const block = m.block;
  Block none;
  m.block = &none;  // the codes are executed with an empty block, so that their functions find no words
  for (std::size_t g = 1; g < m.def.groups.size(); ++g) {
    const GroupRow& group = m.def.groups[g];
    const int number = group_number(group);
    if (keeps_group(number)) continue;
    // the groups of G64, G15 and G13.1 are always reset, even if the bits CLR request that a reset keeps their codes (6.3.3, 5.4, 4.5)
    const bool always = number == 15 || number == 17 || number == 21;
    if (group.power_on < 0 || (!always && keep && s.keeps_codes && static_cast<std::size_t>(number) < s.kept_groups.size() &&
                               s.kept_groups[static_cast<std::size_t>(number)]))
      continue;
    const std::int32_t tenth = initial_code(m, s, number, m.def.codes[static_cast<std::size_t>(group.power_on)].tenth);
    const std::int32_t index = m.def.row_of('G', tenth);
    if (index < 0) continue;
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    if (row.function == Function::mirror_off) clear_mirror(m);  // ends mirroring, even if G51 or G68 remains in force
    const std::size_t silent = m.batch->size();
    (void)handler_of(row.function)(m, {&row, nullptr, {}});
    m.batch->cut(silent);
    m.modal.rows[g] = static_cast<std::int16_t>(index);
  }
  m.block = block;
}

Fanuc::Fanuc(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons)
    : MacroB(m, setup, limits, std::move(commons)) {
  const auto group_of = [&](std::int32_t tenth) {
    const std::int32_t row = m.def.row_of('G', tenth);
    return row < 0 ? std::uint8_t{0} : m.def.codes[static_cast<std::size_t>(row)].group;
  };
  drilling_group = group_of(80_g);
  motion_group = group_of(0_g);
  slowing = static_cast<std::int16_t>(m.def.row_of('G', 62_g));
  m.tables.zeros.resize(all_systems + dynamic_systems);
  m.tables.rotations.resize(all_systems + dynamic_systems);
}

Fanuc::~Fanuc() = default;

/// Sets the reference points. A reference point that a parameter gives (9, 9.2) has priority over the point that a key of the set-up gives.
void Fanuc::take_reference_points(BlockContext& m) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    for (std::size_t point = 1; point < m.tables.reference.size(); ++point) {
      const double position = settings.axes[a].reference[point - 1];
      m.tables.reference[point][a] = position != 0 ? position : setup_reference_[point][a];
    }
}

void Fanuc::read_parameters(BlockContext& m) {
  MacroB::read_parameters(m);
  settings = fanuc::read_settings(source_of(parameters), m.axis_names, m.def.axis_numbers, m.def.behaviour.lathe);
  if (const ParameterId most = parameters.named("1400"); most != ParameterId::none)
    settings.offset_numbers = static_cast<int>(parameters.value(most));
  if (m.def.behaviour.tool_along_third) settings.length_axes = settings.length_of_block ? 0 : std::max(settings.length_axes, 1);
  take_reference_points(m);
}

bool Fanuc::start(Interpreter& m, const Setup& setup) {
  setup_reference_ = m.tables.reference;
  MacroB::start(m, setup);
  without_point = 0;
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (const WordFormat& format = m.def.grammar.word(letter); format.known && format.whole_digits == 0 && !format.point)
      without_point |= letter_bit(letter);
  singular = setup.kinematics.singular;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    axis_limits[a] = {-unlimited, unlimited};
    if (const auto found = setup.axis_limits.find(m.axis_names[a]); found != setup.axis_limits.end()) axis_limits[a] = found->second;
    for (const std::string& name : {std::string("*"), m.axis_names[a]})
      if (const auto found = setup.machine.find(name); found != setup.machine.end() && found->second.limits)
        axis_limits[a] = *found->second.limits;
    for (const std::string& name : {std::string("*"), m.axis_names[a]})
      if (const auto found = setup.machine.find(name); found != setup.machine.end()) servo_lag[a] = found->second.position_error;
  }
  for (const auto& [number, spindle_setup] : setup.spindles) {
    if (number < 1 || number > static_cast<int>(max_spindles)) continue;
    SpindleState& s = spindle(number);
    s.known = true;
    s.channel = spindle_setup.channel;
    s.rpm = spindle_setup.rpm;
    s.dir = spindle_setup.dir == "cw" ? SpindleDir::cw : spindle_setup.dir == "ccw" ? SpindleDir::ccw : SpindleDir::stop;
    s.angle = spindle_setup.angle.value_or(0);
    ranges[number] = spindle_setup.ranges;
    spindle_names[number] = spindle_setup.name;
  }
  if (settings.default_spindle > 0) state.current_spindle = state.main_spindle = settings.default_spindle;
  // 11.4; INFERRED: at power-on the main spindle is the spindle that parameter N0604 names
  m.modal.main_spindle = static_cast<std::uint8_t>(state.main_spindle);
  spindle_part = setup.spindle_override / 100;
  if (settings.lathe.is_lathe) start_turning_memory(*this);
  state.surface_speed = settings.surface_speed;
  state.css_axis = settings.css_axis;
  if (const int x = main_axis(m, 1); settings.lathe.is_lathe && state.css_axis == 0 && x >= 0)
    state.css_axis = m.def.axis_numbers[static_cast<std::size_t>(x)];
  m.transform = Transform();
  reset_shifts(m);
  reset_codes(m, false);
  // Feeds at power-on in G94 and in G95 (6.2).
  const double feeds[] = {parameters.value(parameters.named("0300")), parameters.value(parameters.named("0301"))};
  const bool per_minute = m.modal.feed_mode == FeedMode::per_minute;
  m.modal.feed = feeds[per_minute ? 0 : 1];
  m.modal.other_feed = feeds[per_minute ? 1 : 0];
  m.modal.feed_known = m.modal.feed > 0;
  m.modal.other_feed_known = m.modal.other_feed > 0;
  return true;
}

namespace {

/// Puts the tool length into force if the set-up starts with G43 and H but does not state the lengths of the axes. INFERRED: the length
/// acts along the axis to which the tool is parallel (25.1), usually Z.
void take_length_in_force(BlockContext& m) {
  const std::uint32_t number = m.modal.length_number;
  if (m.modal.length_sign == 0 || number == 0 || m.modal.turning_lengths || any_nonzero(m.modal.lengths)) return;
  if (fanuc_of(m).state.five_axis.tip_control != TipControl::none || number >= m.tables.offsets.size()) return;
  const Vec3 tool = fanuc_of(m).settings.five_axis.tool;
  const int axis = main_axis(m, tool.x != 0 ? 1 : tool.y != 0 ? 2 : 3);
  if (axis >= 0) m.modal.lengths[static_cast<std::size_t>(axis)] = m.modal.length_sign * m.tables.offsets[number].whole_length();
}

}  // namespace

/// Mirrors the axes of settings 45 to 48 (spec/haas 6.1) about the work origin, from the start of the program.
void Fanuc::mirror_by_settings(BlockContext& m) const {
  if (settings.mirrored == 0) return;
  const Axes at = m.transform.to_work(m.position.programmed);
  for (std::size_t a = 0; a < m.axis_count && a < 4; ++a)
    if ((settings.mirrored >> a & 1U) != 0) m.transform.mirror[a] = -1;
  m.transform.refresh();
  m.position.programmed = m.transform.to_programmed(at);
}

void Fanuc::take_setup(Emitter& m, const Setup& setup) {
  MacroB::take_setup(m, setup);
  for (const auto& [name, on] : setup.diameter)
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if (m.axis_names[a] == name) m.modal.diameter = on ? m.modal.diameter | 1u << a : m.modal.diameter & ~(1u << a);
  for (std::size_t first = 0; first < m.axis_count; ++first)
    for (std::size_t second = 0; second < m.axis_count; ++second)
      if (!setup.plane.empty() && m.axis_names[first] + m.axis_names[second] == setup.plane)
        m.modal.axes.first = first, m.modal.axes.second = second;
  m.transform.refresh();
  take_length_in_force(m);
  find_spindle_axes(m, setup);
  mirror_by_settings(m);
}

/// Stops the machine at the end of the program as M5 and M9 do (13.1, "usually"): executes the codes of the key `end` in the control's
/// file, and then stops all spindles of the channel.
void Fanuc::stop_machine(Interpreter& m) {
  const std::size_t silent = m.batch->size();
  const double parts = MacroB::state.parts_done;
  for (const std::int32_t index : m.def.end_codes) {
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    if (row.letter != 'M') continue;
    (void)handler_of(row.function)(m, {&row, nullptr, {}});
    if (row.group != 0 && row.modal) m.modal.rows[row.group] = static_cast<std::int16_t>(index);
  }
  for (SpindleState& s : state.spindles) {
    if (s.known && s.channel != m.def.channel) continue;
    s.dir = SpindleDir::stop;
    s.loop_closed = s.referenced = false;
    s.master = 0;
  }
  MacroB::state.parts_done = parts;
  m.batch->cut(silent);
}

void Fanuc::reset_program(Interpreter& m) {
  reset_macros();
  finishing.clear();
  state.turning.code = 0;
  end_gear(m);
  stop_machine(m);
  reset_shifts(m);
  reset_codes(m, true);
  if (settings.lathe.offset_ends) end_turret_offset(m);
  state.side_step = SideStep::none;
  state.compensates = false;
  m.change_frames();
}

bool Fanuc::end_program(Interpreter& m) {
  // 13.1: the end of the program counts a part, unless N2305 gives an M code that counts parts (note_code())
  if (settings.part_code == 0) MacroB::state.parts_done += 1;
  reset_program(m);
  return true;
}

/// Simulates that the power goes off and on: resets the codes of all groups, even of those whose codes parameter bit CLR keeps at a reset
/// (23.5).
bool Fanuc::lose_power(Interpreter& m) {
  ActionBatch unseen;
  ActionBatch* const batch_before = std::exchange(m.batch, &unseen);
  const bool keeps_codes = std::exchange(settings.keeps_codes, false);
  reset_program(m);
  settings.keeps_codes = keeps_codes;
  m.batch = batch_before;
  return MacroB::lose_power(m);
}

// ---- undoing a faulty block

void Fanuc::begin_block(Emitter& m) {
  MacroB::begin_block(m);
  m.journal.keep<MotionMemory>(state);
  m.fault_place.reset();
}

void Fanuc::keep_all() {
  if (keeps_nothing()) before_ = state;
  MacroB::keep_all();
}

void Fanuc::undo_block(BlockContext& m) {
  if (!keeps_nothing()) state = before_;
  MacroB::undo_block(m);
}

// ---- snapshot

FanucState::FanucState(const Fanuc& of) : MacroState(of), cutting(of) {}

std::shared_ptr<const DialectState> Fanuc::snapshot() const { return std::make_shared<FanucState>(*this); }

Status Fanuc::restore(BlockContext& m, const DialectState& from) {
  KADR_TRY(MacroB::restore(m, from));
  static_cast<fanuc::Memory&>(*this) = static_cast<const FanucState&>(from).cutting;
  return {};
}

void Fanuc::bring_cycles_back() {
  state.drilling = interrupted_cycles.drilling;
  state.turning = interrupted_cycles.turning;
}

}  // namespace kadr::fanuc

namespace kadr {

fanuc::Fanuc& fanuc_of(const BlockContext& m) { return static_cast<fanuc::Fanuc&>(*m.dialect); }

}  // namespace kadr
