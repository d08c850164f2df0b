// The functions of LinuxCNC's dialect that the interpreter calls (control/dialect.h).

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/code_literals.h"
#include "base/units.h"
#include "base/vec.h"
#include "control/functions/cutter_compensation.h"
#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/o_line_flow.h"
#include "control/linuxcnc/rotary.h"
#include "control/linuxcnc/spindles.h"

namespace kadr {

std::unique_ptr<Dialect> make_linuxcnc_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits) {
  return std::make_unique<linuxcnc::LinuxCnc>(m, setup, limits);
}

namespace linuxcnc {
namespace {

constexpr std::uint32_t debug_on = 5599;

}  // namespace

bool is_plane_of_uvw(const BlockContext& m) {
  return std::any_of(m.modal.rows.begin(), m.modal.rows.end(), [&](std::int16_t row) {
    if (row < 0) return false;
    const CodeRow& code = m.def.codes[static_cast<std::size_t>(row)];
    return code.letter == 'G' && (code.tenth == 17.1_g || code.tenth == 18.1_g || code.tenth == 19.1_g);
  });
}

LinuxCnc& linuxcnc_of(const BlockContext& m) { return static_cast<LinuxCnc&>(*m.dialect); }

struct LinuxCnc::Remembered : DialectState {
  /// Calls by `O… call` have parameters of their own, and calls by M98 those of the caller (spec/linuxcnc 6.2, 6.5).
  std::vector<LocalVariables> local_variables(const std::vector<CallFrame>& calls, const ControlDef& def) const override {
    std::vector<std::size_t> depths = {0};
    std::size_t number = 0;
    for (std::size_t i = 0; i < calls.size() && number < flow.by_m98.size(); ++i)
      if (calls[i].kind == CallFrame::Kind::subprogram && !flow.by_m98[number++]) depths.push_back(i + 1);
    std::vector<LocalVariables> all;
    for (std::size_t level = 0; level < std::min(depths.size(), levels.size()); ++level) {
      auto& values = all.emplace_back(LocalVariables{depths[level], {}}).values;
      for (std::size_t n = 1; n <= max_arguments; ++n)
        if (const double value = levels[level].arguments[n]; value != 0) values.emplace_back("#" + std::to_string(n), value);
      for (const auto& [name, value] : levels[level].named)
        values.emplace_back("#<" + def.grammar.named_variables->name_of(name) + ">", value);
    }
    return all;
  }

  State state;
  std::map<int, Tool> tools;
  bool tools_changed = false;
  std::vector<Level> levels;
  std::map<double, double> globals;
  std::vector<std::vector<SavedModes>> saved_modes;
  FlowTable::Memory flow;
  Axes probed{};
  bool probe_tripped = false;
  int probe_kind = 2;
  std::optional<TurningCycle> turning;
  ProgramFiles::Memory outputs;
};

/// Reads the tools from tool.tbl in the program memory, or from the set-up if this file is missing (spec/linuxcnc 1.1).
LinuxCnc::LinuxCnc(BlockContext& m, const Setup& setup, const RunLimits& limits)
    : groups(m.def),
      outputs({.root = limits.files,
               .writing = limits.writes_files ? files::OutputWriting::files : files::OutputWriting::nothing,
               .untouched = limits.untouched}) {
  for (const AddressName& name : m.def.grammar.names)
    if (name.text == "$") spindle_address = name.address;
  read_machine_file(m, setup, limits);
  read_parameter_file(m, limits);
  for (const auto& [number, offset] : setup.offsets) {
    Tool tool;
    tool.pocket = number;
    tool.offset[0] = offset.length_x + offset.length_x_wear;
    tool.offset[1] = offset.length_y + offset.length_y_wear;
    tool.offset[2] = offset.whole_length();
    tool.diameter = 2 * offset.whole_radius();
    tool.orientation = offset.tip_position;
    tools.insert_or_assign(number, tool);
  }
  table_is_known = !tools.empty();
  read_tool_file(limits);
}

/// Determines which axes the machine has (spec/linuxcnc 1.1): the set-up or its ini file names them. INFERRED: if U, V or W is one of these
/// axes, the control has all nine axes, so that parameter numbers stay valid; a word of an axis that is not named is still an alarm.
bool LinuxCnc::start(Interpreter& m, const Setup& setup) {
  std::string named;
  for (const std::string& axis : setup.axes) named += axis;
  if (named.empty()) named = machine.axes;
  if (named.empty()) named = axis_letters.substr(0, usual_axes);
  for (std::size_t a = 0; a < axis_letters.size(); ++a)
    if (named.find(axis_letters[a]) != std::string::npos) axes |= AxisMask{1} << a;
  if (axes >> axis_u == 0) m.axis_names.resize(usual_axes);
  m.axis_count = m.axis_names.size();
  return false;
}

std::pair<double, double> LinuxCnc::limits_by_file(std::size_t axis) const {
  return machine.known && axis < machine.limits.size() ? machine.limits[axis] : Dialect::limits_by_file(axis);
}

/// Records in a motion to which axes the feed applies: X Y Z if one of them moves; if not, U V W; if these do not move either, A B C
/// (spec/linuxcnc 7.2).
void LinuxCnc::note_motion(Emitter& m, Motion& motion) {
  motion.along = FeedAlong::xyz;
  if (m.modal.axes.first >= axis_u) {  // in a plane of U, V, W arcs and cutter compensation are not allowed
    const PlaneAxes of_xyz = axes_of(m.modal.plane);
    motion.first = static_cast<std::uint8_t>(of_xyz.first);
    motion.second = static_cast<std::uint8_t>(of_xyz.second);
  }
  Dialect::note_motion(m, motion);
}

void LinuxCnc::take_setup(Emitter& m, const Setup& setup) {
  take_parameters(m);
  take_tables(m, setup);
  if (!machine.keeps_shift)
    for (std::uint32_t n = shift_on_number; n < first_shift + axes_of_tables; ++n) m.variables.set_raw(n, 0);
  const auto stated = static_cast<std::uint32_t>(m.variables.raw(system_number));
  const std::uint32_t number = m.modal.fixture > 1 || stated < 1 || stated > 9 ? m.modal.fixture : stated;
  m.modal.fixture = number;
  m.variables.set_raw(system_number, number);
  state.shift_on = m.variables.raw(shift_on_number) != 0;
  if (state.shift_on) state.shift = stored_axes(m, first_shift);
  state.system_number = number;
  state.system = system_offset(m, number);
  state.rotation = m.variables.raw(5230 + (number - 1) * 20);
  m.variables.set_raw(debug_on, 1);
  (void)m.variables.consume_frames_changed();
}

void LinuxCnc::started(Emitter&) {
  state.began = state.percent = false;
  before_ = state;
}

/// Cancels the shift of G92 and sets its parameters to 0 (DISABLE_G92_PERSISTENCE).
void LinuxCnc::forget_shift(Emitter& m) {
  for (std::uint32_t n = shift_on_number; n < first_shift + axes_of_tables; ++n) m.variables.set_raw(n, 0);
  (void)m.variables.consume_frames_changed();
  state.shift = {};
  state.shift_on = false;
  m.change_frames();
}

/// Ends the program at M2, M30 (spec/linuxcnc 7.9). The control's file lists the modes that M2 and M30 reset.
bool LinuxCnc::end_program(Interpreter& m) {
  m.modal.feed = 0;
  m.modal.feed_known = false;
  state.motion = 1_g;
  m.modal.override_permission = 3;
  if (!machine.keeps_shift) forget_shift(m);
  while (levels_.size() > 1) levels_.pop_back();
  flow.calls.clear();
  flow.by_m98.clear();
  turning.reset();
  save_parameters(m, true);
  save_tools(m);
  stop_other_spindles(m);
  return false;
}

/// Saves the parameter file and the tool table after an alarm, as LinuxCNC does (Interp::synch). The parameters in memory keep their
/// values.
void LinuxCnc::failed(Emitter& m) {
  save_parameters(m, false);
  save_tools(m);
}

std::shared_ptr<const DialectState> LinuxCnc::snapshot() const {
  auto all = std::make_shared<Remembered>();
  all->state = state;
  all->tools = tools;
  all->tools_changed = tools_changed;
  all->levels = levels_;
  all->globals = globals_;
  all->saved_modes = saved_modes;
  all->flow = flow.memory();
  all->probed = probed;
  all->probe_tripped = probe_tripped;
  all->probe_kind = probe_kind;
  all->turning = turning;
  all->outputs = outputs.memory();
  return all;
}

Status LinuxCnc::restore(BlockContext&, const DialectState& from) {
  const auto& all = static_cast<const Remembered&>(from);
  state = before_ = all.state;
  tools = all.tools;
  tools_changed = all.tools_changed;
  levels_ = all.levels;
  globals_ = all.globals;
  saved_modes = all.saved_modes;
  flow.resume_from(all.flow);
  probed = all.probed;
  probe_tripped = all.probe_tripped;
  probe_kind = all.probe_kind;
  turning = all.turning;
  KADR_TRY(outputs.resume_from(all.outputs));
  return {};
}

namespace {

/// Refuses a file with a byte order mark. LinuxCNC reads the mark as three characters, and reports the first one. Kadr's line reader has
/// skipped the mark, so the position of the first block shows it.
Status no_byte_order_mark(const BlockContext& m) {
  constexpr std::uint64_t size_of_mark = 3;
  if (m.block->position.line != 1 || m.block->position.offset != size_of_mark) return {};
  return linuxcnc_of(m).fault(AlarmId::rs274_form, m.block->where, "Bad character '\\357' used");
}

}  // namespace

Result<bool> LinuxCnc::statement(Interpreter& m) {
  KADR_TRY(no_byte_order_mark(m));
  state.began = true;
  KADR_TRY(run_o_line(m));
  return true;
}

/// Handles a line with only `%` (spec/linuxcnc 2.1). If this is the first line that is not blank, the program starts; the next line with
/// only `%` ends the program.
Result<bool> LinuxCnc::sign_of_file(Interpreter& m) {
  KADR_TRY(no_byte_order_mark(m));
  if (!state.began && !state.percent) {
    state.percent = state.began = true;
    return true;
  }
  if (!state.percent) return fault(AlarmId::rs274_form, m.block->where, "Bad character '%' used");
  save_parameters(m, false);
  save_tools(m);
  m.flow.end();
  return true;
}

Result<bool> LinuxCnc::end_of_file(BlockContext& m) {
  if (flow.defining != no_label || !flow.calls.empty())
    return fault(AlarmId::rs274_flow, {},
                 "EOF in file:" + m.program().file() + " seeking o-word: o<" +
                     flow.text_of(flow.calls.empty() ? flow.defining : flow.calls.back()) + "> from line: 0");
  return fault(AlarmId::rs274_program, {},
               state.percent ? "File ended with no percent sign" : "File ended with no percent sign or program end");
}

/// Ends the run after a fault at the end of the file, so that the fault is not reported a second time.
void LinuxCnc::note_fault(Interpreter& m, bool) {
  const Alarm& fault = m.report.alarm;
  const bool of_the_end = fault.id == AlarmId::rs274_flow || fault.id == AlarmId::rs274_program;
  if (of_the_end && fault.where.end == 0) m.flow.end();
}

void LinuxCnc::begin_block(Emitter&) {
  state.began = true;
  before_ = state;
}

namespace {

/// Checks that the feed is not 0. As in LinuxCNC, the check is made after the block's F and feed mode have come into force (spec/linuxcnc
/// 7.2).
Status feed_known(const BlockContext& m, const LinuxCnc& control) {
  const std::int32_t motion = control.codes.motion;
  if (motion != 1_g) return {};
  const std::int32_t kind = control.codes.g[5];
  const bool inverse = kind >= 0 ? kind == 930 : m.modal.feed_mode == FeedMode::inverse_time;
  const Span at = m.block->where;
  if (inverse) {
    if (m.has('F') && m.value('F') > 0) return {};
    return control.fault(AlarmId::rs274_motion, at, "F word missing with inverse time g1 move");
  }
  const double feed = m.has('F') ? m.value('F') : kind >= 0 || !m.modal.feed_known ? 0 : m.modal.feed;
  if (!(feed > 0)) return control.fault(AlarmId::rs274_motion, at, "Cannot do g1 with zero feed rate");
  const bool by_turn = kind >= 0 ? kind == 950 : m.modal.feed_mode == FeedMode::per_revolution;
  if (by_turn && speed_of_block(m, control.state.active_spindle) == 0)
    return control.fault(AlarmId::rs274_spindle, at, "Cannot feed with zero spindle speed in feed per rev mode");
  return {};
}

/// Refuses codes and words that are not allowed while cutter compensation is on (spec/linuxcnc 7.5).
Status compensation_allows(const BlockContext& m, const LinuxCnc& control) {
  if (m.modal.radius_side == 0) return {};
  const BlockCodes& codes = control.codes;
  const Span at = m.block->where;
  const auto no = [&](const char* text) { return control.fault(AlarmId::rs274_compensation, at, text); };
  if (codes.g[2] >= 0) return no("Cannot change planes with cutter radius compensation on");
  if (codes.g[7] > 40_g) return no("Cannot turn cutter radius comp on when on");
  if (codes.g[13] >= 0) return no("Cannot change control mode with cutter radius compensation on");
  if (codes.g[10] >= 0) return no("Cannot change retract mode with cutter radius compensation on");
  if (codes.g[0] == 53_g) return no("Cannot use g53 with cutter radius comp");
  if (codes.motion == 5_g || codes.motion == 5.1_g || codes.motion == 5.2_g)
    return no("Cannot convert spline with cutter radius compensation");
  if (codes.m[9] == 48) return no("Cannot enable overrides with cutter radius compensation on");
  if (codes.m[9] == 49) return no("Cannot disable overrides with cutter radius compensation on");
  return {};
}

}  // namespace

Result<bool> LinuxCnc::takes_block(Interpreter& m) {
  KADR_TRY(no_byte_order_mark(m));
  auto read = codes_of_block(m, *this);
  if (!read) return fail(read.error());
  codes = *read;
  if (turning && codes.m[4] < 98) {
    KADR_TRY(m.take_words());
    KADR_TRY(take_profile_block(m));
    return true;
  }
  KADR_TRY(indexers_allow(m));
  KADR_TRY(spindle_of_modes(m));
  KADR_TRY(compensation_allows(m, *this));
  KADR_TRY(feed_known(m, *this));
  KADR_TRY(m.take_words());
  state.polar_step = false;
  KADR_TRY(take_polar_words(m));
  return false;
}

std::int16_t LinuxCnc::motion_row(const BlockContext& m) const {
  if (codes.g1() >= 0 || codes.axes_for_group0) return -1;
  if (codes.motion >= 0) return static_cast<std::int16_t>(m.def.row_of('G', codes.motion));
  return codes.has_axis ? any_motion : std::int16_t{-1};
}

std::int32_t LinuxCnc::code_in_force(const BlockContext& m, std::size_t group) const {
  const std::size_t index = groups.index_of_g(group);
  return index == 0 || m.modal.rows[index] < 0 ? -1 : m.def.codes[static_cast<std::size_t>(m.modal.rows[index])].tenth;
}

BlockChanges LinuxCnc::changes_of(const BlockContext&, const Plan&) const { return BlockChanges::anything; }

void LinuxCnc::after_code(Interpreter& m, const CodeRow& row, std::int32_t) {
  if (row.letter != 'G' || row.group == 0) return;
  const auto is_of = [&](std::size_t group) { return row.group == groups.index_of_g(group); };
  if (is_of(5)) {  // G93, G94 and G95 set F to 0, even if the same code is in force already (spec/linuxcnc 7.2)
    m.modal.feed = 0;
    m.modal.feed_known = false;
    return;
  }
  if (is_of(2) && row.tenth % 10 == 1 && m.axis_count > axis_u)  // G17.1, G18.1 and G19.1 are G17, G18 and G19 with the axes U, V, W
    m.modal.axes = {m.modal.axes.first + axis_u, m.modal.axes.second + axis_u, m.modal.axes.normal + axis_u};
  if (is_of(7) && m.modal.contour == CompensationPhase::leaving) state.arc_not_allowed = true;
  if (is_of(6)) m.variables.inch = false;  // tables and parameters are in the machine's unit, also in G20 and G21 (spec/linuxcnc 1.1)
  if (!is_of(1) || !row.modal) return;
  state.motion = row.tenth;
  if (!codes.is_cycle()) state.cycle_began = false;
}

Status LinuxCnc::after_block(Interpreter& m) {
  if (codes.motion == 0_g || codes.motion == 1_g || codes.motion == 33_g || codes.motion == 33.1_g) state.arc_not_allowed = false;
  forget_polar_words(m);
  if (codes.g1() == 80_g) state.motion = m.modal.motion_row >= 0 ? state.motion : 80_g;
  return {};
}

void LinuxCnc::undo_block(BlockContext& m) {
  state = before_;
  forget_polar_words(m);
}

bool LinuxCnc::lines_follow(const BlockContext& m) const {
  return !turning && !has_rotary_rules(machine) && m.modal.feed_mode == FeedMode::per_minute;
}

bool LinuxCnc::contour_follows(const BlockContext& m) const { return continues_contour(m.modal); }

void LinuxCnc::note_line(BlockContext& m) {
  state.motion = m.def.codes[static_cast<std::size_t>(m.modal.motion_row)].tenth;
  state.cycle_began = state.arc_not_allowed = false;
}

/// Returns the arc rule of the control's file with one change: arcs with absolute centres (G90.1) are executed the general way, because
/// LinuxCNC then requires both words of the centre.
ArcRule LinuxCnc::arc_rule(const BlockContext& m) const {
  ArcRule rule = m.plain_arc_rule();
  rule.by_words = !rule.absolute;
  rule.radius_by_words = true;
  return rule;
}

}  // namespace linuxcnc
}  // namespace kadr
