// The functions of Grbl's dialect that the interpreter calls (control/dialect.h).

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/code_literals.h"
#include "base/units.h"
#include "control/functions/arc_motion.h"
#include "control/functions/functions.h"
#include "control/grbl/grbl.h"

namespace kadr {

std::unique_ptr<Dialect> make_grbl_dialect(const Setup& setup) { return std::make_unique<grbl::Grbl>(setup); }

namespace grbl {
namespace {

struct GrblMemory : DialectState {
  explicit GrblMemory(const State& all) : state(all) {}
  State state;
};

AxisMask named_in(const BlockContext& m) {
  AxisMask named = 0;
  for (std::size_t a = 0; a < axes; ++a)
    if (m.has(m.letters.axis_letter[a])) named |= AxisMask{1} << a;
  return named;
}

}  // namespace

Grbl& grbl_of(const BlockContext& m) { return static_cast<Grbl&>(*m.dialect); }

/// Reads Grbl's settings from the set-up. A setting that the set-up does not give has the value of Grbl's generic build (spec/grbl 10).
Grbl::Grbl(const Setup& setup) {
  constexpr double usual_travel = 200;
  for (std::size_t a = 0; a < axes; ++a) state.settings.travel[a] = usual_travel;
  for (const int number : {12, 22, 20, 30, 31, 130, 131, 132}) {
    const std::string digits = std::to_string(number);
    const auto given = setup.parameters.find({std::string(4 - digits.size(), '0') + digits, "", ""});
    if (given == setup.parameters.end() || !std::holds_alternative<double>(given->second)) continue;
    (void)set(state.settings, number, std::get<double>(given->second), {});
  }
}

std::shared_ptr<const DialectState> Grbl::snapshot() const { return std::make_shared<GrblMemory>(state); }

Status Grbl::restore(BlockContext&, const DialectState& from) {
  state = before_ = static_cast<const GrblMemory&>(from).state;
  return {};
}

/// Puts the power-on codes in force one by one. One block cannot have all these codes, because G49 and G0 both use the axis words.
bool Grbl::start(Interpreter& m, const Setup&) {
  for (std::size_t g = 0; g < m.def.groups.size(); ++g)
    if (m.def.groups[g].power_on >= 0) m.modal.rows[g] = static_cast<std::int16_t>(m.def.groups[g].power_on);
  m.modal.motion = MotionMode::rapid;
  m.modal.motion_row = static_cast<std::int16_t>(m.def.row_of('G', 0));
  m.modal.work_zero = 1;
  return true;
}

void Grbl::started(Emitter&) { before_ = state; }

/// Executes a jog, `$J=`: a straight motion with the F of its line, in mm/min. A jog does not change the modes (spec/grbl 9).
Status Grbl::jog(Emitter& m) {
  std::optional<Alarm> parted;  // the warning that an arc differs from Grbl's arc; remains empty, because a jog is never an arc
  state.float32_state.follow(m, state.length);
  const auto jog = check(m, *this, true, parted);
  if (!jog) return fail(jog.error());
  const Modal before = m.modal;
  m.modal.feed_mode = FeedMode::per_minute;
  m.modal.inch = jog->inch;
  m.modal.feed = m.length_value('F');
  m.modal.feed_known = true;
  if (!jog->has_axis) {  // in a jog without axis words gcode.c moves to machine zero
    const Status moved = m.to_machine(MotionKind::feed, Axes{}, (AxisMask{1} << axes) - 1, m.modal.feed);
    m.modal = before;
    return moved;
  }
  const bool by_machine = jog->non_modal == 530;
  const Status moved = by_machine ? m.to_machine(MotionKind::feed, jog->target, named_in(m), m.modal.feed)
                                  : m.straight(MotionKind::feed, jog->target, named_in(m));
  m.modal = before;
  if (moved) state.float32_state.note(m, *jog, state.length);
  return moved;
}

Result<bool> Grbl::takes_block(Interpreter& m) {
  std::optional<Alarm> parted;
  state.float32_state.follow(m, state.length);
  const auto all = check(m, *this, false, parted);
  if (parted) m.warn(*parted);
  if (!all) return fail(all.error());
  checked = *all;
  if (m.has('T')) {  // Grbl stores the tool number in one byte (spec/grbl 1.3)
    double& tool = m.block->words[m.block->at['T' - 'A']].value;
    tool = byte_of(tool);
  }
  KADR_TRY(m.check_ranges());
  if (m.has('S')) watch_speed(m);
  return false;
}

/// Warns, once per speed, if S is outside the spindle's speed range from $31 to $30 in rev/min (spec/grbl 4.17). The value of S is not
/// changed.
void Grbl::watch_speed(Emitter& m) {
  const Settings& s = state.settings;
  const double speed = m.value('S'), turned = std::clamp(speed, std::min(s.min_spindle_speed, s.max_spindle_speed), s.max_spindle_speed);
  if (!(speed > 0) || turned == speed || speed_reported_ == speed) return;
  speed_reported_ = speed;
  m.warn(warning(AlarmId::speed_beyond_setting, m.where('S'), speed, turned));
}

void Grbl::begin_block(Emitter&) {
  before_ = state;
  feed_at_end_ = -1;
}

void Grbl::undo_block(BlockContext&) { state = before_; }

BlockChanges Grbl::changes_of(const BlockContext&, const Plan&) const { return BlockChanges::anything; }

/// Returns the row of the motion code in force; -1 after G80.
std::int16_t Grbl::motion_row(const BlockContext& m) const { return checked.moves ? m.modal.motion_row : std::int16_t{-1}; }

/// Executes M2 and M30. These codes put G1 in force, but axis words in the same block move nothing.
bool Grbl::end_program(Interpreter& m) {
  m.block_axes_taken = true;
  checked.motion = 1_g;
  feed_at_end_ = m.modal.feed;
  return false;
}

Status Grbl::after_block(Interpreter& m) {
  if (feed_at_end_ >= 0) {  // F remains in force after M2 and M30, whatever the feed mode (spec/grbl 7)
    m.modal.feed = std::exchange(feed_at_end_, -1);
    m.modal.feed_known = m.modal.feed > 0;
  }
  state.float32_state.note(m, checked, state.length);
  const bool probes = checked.motion > 38_g && checked.motion < 39_g;
  // G38.n is a modal motion code, so it stays in force (spec/grbl 3).
  if (probes) m.modal.motion_row = static_cast<std::int16_t>(m.def.row_of('G', checked.motion));
  if (m.modal.feed_mode == FeedMode::inverse_time) {  // in G93 the feed F is valid only in its own block (spec/grbl 4.2)
    m.modal.feed = 0;
    m.modal.feed_known = false;
  }
  return {};
}

bool Grbl::lines_follow(const BlockContext& m) const {
  return m.modal.feed_mode == FeedMode::per_minute && m.modal.feed_known && m.modal.feed > 0 && !state.settings.soft_limits;
}

void Grbl::note_line(BlockContext& m) { state.float32_state.note_line(m); }

/// Returns the arc rule of the control's file with one change: each arc is checked separately, as in Grbl.
ArcRule Grbl::arc_rule(const BlockContext& m) const {
  ArcRule rule = m.plain_arc_rule();
  rule.by_words = rule.radius_by_words = false;
  return rule;
}

Status Grbl::arc(Emitter& m, const kadr::Call&, Turn turn) {
  if (!checked.moves) return {};
  AxisMask named = 0;
  Axes end;
  KADR_TRY(m.target(end, named));
  if (!checked.arc) return m.straight(MotionKind::feed, end, named);
  KADR_TRY(m.within_reach(end));
  arc_motion(m, *checked.arc, turn, end, named);
  return {};
}

void Grbl::refresh_frames(Emitter& m) {
  m.frames_by_tables();
  m.frames.length[2] = state.length;
}

/// Records the answer to a probe motion. A missing contact is an alarm only for G38.2 and G38.4 (spec/grbl 4.16).
Status Grbl::accept_answer(Emitter& m, const ProbeAnswer& answer) {
  const Status noted = m.note_answer(answer);
  const bool must = m.modal.motion_row == m.def.row_of('G', 38.2_g) || m.modal.motion_row == m.def.row_of('G', 38.4_g);
  if (noted || must) return noted;
  return {};
}

/// Ignores M1 (spec/grbl 7).
Status Grbl::machine_code(Interpreter&, const kadr::Call&) { return {}; }

}  // namespace grbl
}  // namespace kadr
