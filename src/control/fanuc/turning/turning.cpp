// Turning cycles G70.7 … G79.7: first blocks of the compound cycles, selection of the function for their second blocks, simple cycles.

#include "control/fanuc/turning/turning.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/code_literals.h"
#include "base/tolerance.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/lathe/lathe_words.h"
#include "control/fanuc/turning/turning_contour.h"
#include "control/fanuc/turning/turning_plane.h"
#include "control/functions/functions.h"
#include "control/macro_b/dialect/blocks.h"

namespace kadr::fanuc {
namespace {

/// The distances in the first or second block of a compound cycle, indexed by the axis of the plane. They are always radii, whichever
/// letter names the axis.
struct Distances {
  std::array<double, 2> value{};
  std::array<const Word*, 2> word{};
};
Result<Distances> distances(const BlockContext& m) {
  Distances d;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t which = place_in_plane(m, w);
    if (which > 1) return fail(alarm(AlarmId::illegal_address, w.where, w.written));
    if (d.word[which] != nullptr) return fail(alarm(AlarmId::address_twice, w.where, w.address));
    d.word[which] = &w;
    d.value[which] = w.value * m.unit_scale();
  }
  return d;
}

Status out_of_range(const BlockContext& m, char letter) {
  return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, m.value(letter)));
}

/// Reads R of the first block of a compound cycle. A negative R raises an alarm; without R the old value remains.
Status take_r(const BlockContext& m, double& to) {
  if (!m.has('R')) return {};
  if (!(m.value('R') >= 0)) return out_of_range(m, 'R');
  to = m.length_value('R');
  return {};
}

/// Reads the first block of G71.7 (G71.7 W5 R1) or G72.7 (G72.7 V5 R1): the depth of a pass along the infeed axis (19.A 4), and the
/// retract.
Status first_of_rough(BlockContext& m, const Call& call) {
  TurningMemory& memory = fanuc_of(m).state.turning;
  const std::size_t infeed = call.row->arg == 71.7_g ? 1 : 0;
  const auto d = distances(m);
  if (!d) return fail(d.error());
  if (const Word* const other = d->word[1 - infeed]; other != nullptr)
    return fail(alarm(AlarmId::illegal_address, other->where, other->written));
  const Word* const depth = d->word[infeed];
  if (depth == nullptr && !m.has('R')) return fail(alarm(AlarmId::word_missing, call.where, letter_of(m, infeed), call.row->code));
  if (depth != nullptr) {
    if (!(depth->value > 0)) return fail(alarm(AlarmId::value_out_of_range, depth->where, depth->written, depth->value));
    memory.depth = d->value[infeed];
  }
  return take_r(m, memory.back);
}

/// Reads the first block of G73.7 (G73.7 U3 W3 R4): the offset of the first pass and the number of passes.
Status first_of_pattern(BlockContext& m) {
  constexpr double max_passes = 9999;
  TurningMemory& memory = fanuc_of(m).state.turning;
  const auto d = distances(m);
  if (!d) return fail(d.error());
  if (d->word[0] != nullptr) memory.relief.x = d->value[0];
  if (d->word[1] != nullptr) memory.relief.y = d->value[1];
  if (!m.has('R')) return {};
  const auto passes = m.whole('R', 1, max_passes);
  if (!passes) return fail(passes.error());
  memory.passes = *passes;
  return {};
}

/// Reads the first block of G76.7 (G76.7 Pmmrraa QΔmin Rd): the number mm of finishing passes, the chamfer rr, the tool angle aa, the least
/// depth of a pass, and the finishing allowance.
Status first_of_thread(BlockContext& m) {
  constexpr double angles[] = {80, 60, 55, 30, 29, 0};
  TurningMemory& memory = fanuc_of(m).state.turning;
  if (m.has('P')) {
    const auto digits = m.whole('P', 0, 999'999);
    if (!digits) return fail(digits.error());
    const double angle = *digits % 100;
    bool known = false;
    for (const double a : angles) known = known || a == angle;
    if (!known) return out_of_range(m, 'P');
    memory.finishing = std::max(1u, *digits / 10'000);
    memory.chamfer = *digits / 100 % 100 / 10.0;
    memory.tool_angle = angle;
  }
  if (m.has('Q')) {
    if (!(m.value('Q') >= 0)) return out_of_range(m, 'Q');
    memory.least = m.length_value('Q');
  }
  return take_r(m, memory.allowance);
}

/// Returns true for the first block of a compound cycle. The second block differs: it has words for the contour, the target or the pecks.
bool is_first_line(const BlockContext& m, int code) {
  switch (code) {
    case 70.7_g: return false;
    case 71.7_g:
    case 72.7_g:
    case 73.7_g: return !m.has('P') && !m.has('Q');
    case 76.7_g: return !m.has_axis_words();
    default: return !m.has_axis_words() && !m.has('P') && !m.has('Q');
  }
}

Status first_line(BlockContext& m, const Call& call) {
  switch (call.row->arg) {
    case 71.7_g:
    case 72.7_g: return first_of_rough(m, call);
    case 73.7_g: return first_of_pattern(m);
    case 76.7_g: return first_of_thread(m);
    default:
      if (!m.has('R')) return fail(alarm(AlarmId::word_missing, call.where, 'R', call.row->code));
      return take_r(m, fanuc_of(m).state.turning.groove_back);
  }
}

Status second_line(Interpreter& m, const Call& call) {
  suspend_side(m);
  switch (call.row->arg) {
    case 74.7_g:
    case 75.7_g: return groove(m, call);
    case 76.7_g: return compound_thread(m, call);
    default: break;
  }
  const auto allowance = distances(m);
  if (!allowance) return fail(allowance.error());
  const Vec2 by{allowance->value[0], allowance->value[1]};
  return call.row->arg == 73.7_g ? pattern(m, call, by) : rough(m, call, by);
}

/// Checks that the modes in force permit a turning cycle. Only a lathe has cycles in G41 and G42 (spec/fanuc-t 7.4).
Status possible(const BlockContext& m, const Call& call) {
  if (m.modal.surface != PathSurface::plane) return fail(alarm(AlarmId::surface_state, call.where, call.row->code));
  if (m.modal.radius_side != 0 && !fanuc_of(m).settings.compensates_nose)
    return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  return {};
}

/// Returns the letter of the taper of a simple cycle: R, on a Haas I, and K in G94 (spec/haas-st 5).
char taper_letter(const BlockContext& m, const Call& call) {
  if (!is_haas(m)) return 'R';
  return call.row->arg == 79.7_g ? 'K' : 'I';
}

/// Reads the words of a simple cycle. If a word is missing, its value from an earlier block remains.
Status take_simple(BlockContext& m, const Call& call) {
  TurningMemory& memory = fanuc_of(m).state.turning;
  const auto target = plane_target(m);
  if (!target) return fail(target.error());
  for (std::size_t i = 0; i < 2; ++i) {
    if (target->given[i]) {
      memory.target[i] = i == 0 ? target->to.x : target->to.y;
      memory.known[i] = true;
    }
    if (!memory.known[i]) return fail(alarm(AlarmId::word_missing, call.where, letter_of(m, i), call.row->code));
  }
  const char taper = taper_letter(m, call);
  if (m.has(taper)) memory.taper = m.length_value(taper);
  const bool lathe = m.def.behaviour.lathe != Lathe::none;
  if (lathe) memory.start_angle = start_angle_of(m);  // Q acts in its block only (spec/fanuc-t 8.4)
  else if (m.has('Q')) memory.start_angle = m.value('Q');
  return {};
}

/// Ends a contour that is executed in G41 or G42, and returns to its start point. The last block ends square to its own end, and the tool
/// is at the programmed start point after the way back; compensation starts again with the next motion (spec/fanuc-t 9.11).
Status leave_side(Emitter& m, Vec2 start) {
  UndoableState& state = fanuc_of(m).state;
  const std::int8_t side = std::exchange(m.modal.radius_side, std::int8_t{0});
  state.side_step = state.compensates ? SideStep::ends : SideStep::none;
  const Status gone = go(m, MotionKind::rapid, start);
  if (state.side_step == SideStep::ends) end_side_block(m);  // the last block ended at the start point
  m.modal.radius_side = side;
  restart_side(m);
  return gone;
}

/// Executes one G77.7 or G79.7 cycle: infeed, cut, retract, and return to the start point. G77.7 cuts along the first axis of the plane,
/// G79.7 along the second. In G41 or G42, whichever of the two it is, the tool is inside the four motions; it is at the programmed point at
/// their start and end (spec/fanuc-t 7.4).
Status cut_once(Emitter& m, const Call& call) {
  const TurningMemory& memory = fanuc_of(m).state.turning;
  const Vec2 s = plane_point(m), t{memory.target[0], memory.target[1]};
  const bool along_first = call.row->arg == 77.7_g;
  const Vec2 a = along_first ? Vec2{s.x, t.y + memory.taper} : Vec2{t.x + memory.taper, s.y};
  KADR_TRY(m.feed_known(call.where));
  const std::int8_t side = m.modal.radius_side;
  restart_side(m);
  if (side != 0) m.modal.radius_side = cross(a - s, t - s) > 0 ? std::int8_t{-1} : std::int8_t{1};
  KADR_TRY(go(m, MotionKind::rapid, a));
  KADR_TRY(go(m, MotionKind::feed, t));
  KADR_TRY(go(m, MotionKind::feed, along_first ? Vec2{t.x, s.y} : Vec2{s.x, t.y}));
  if (side == 0) return go(m, MotionKind::rapid, s);
  KADR_TRY(leave_side(m, s));
  m.modal.radius_side = side;
  return {};
}

/// G78.7, and G92 of lathes: cuts one pass of a thread, with the run-out of a lathe (spec/fanuc-t 8.4). The NCT manual does not give its
/// length. INFERRED: there is no run-out.
Status simple_thread(Emitter& m, const Call& call) {
  const TurningMemory& memory = fanuc_of(m).state.turning;
  const auto lead = thread_lead_of(m, call);
  if (!lead) return fail(lead.error());
  KADR_TRY(check_thread_words(m, call));
  suspend_side(m);
  const Vec2 s = plane_point(m), t{memory.target[0], memory.target[1]};
  const SinCos out = sincos_deg(fanuc_of(m).settings.lathe.run_out_angle);
  return thread_pass(m, {{s.x, t.y + memory.taper}, t, s, *lead, memory.start_angle, run_out_leads(m) * *lead, out.sin / out.cos});
}

/// G70.7: executes the blocks of the contour as they are programmed (19.A 6).
class FinishingRun final : public SteppedCycleValue<FinishingRun> {
 public:
  FinishingRun(Position first, Position after, std::uint32_t name) : first_(first), after_(after), name_(name) {}

  Result<bool> next(Emitter&) override { return false; }

  Status finish(Interpreter& m) const override {
    CallFrame frame;
    frame.name = name_;
    frame.left = 1;
    frame.caller = m.origin;
    frame.modal_calls = macro_b_of(m).state.active_modal_calls;
    KADR_TRY(m.flow.call_at(m.program().reader(), first_, frame, m.block->where));
    fanuc_of(m).finishing.push_back({m.program().depth(), after_.offset, plane_point(m), m.origin, m.modal.radius_side != 0});
    return {};
  }

 private:
  Position first_, after_;
  std::uint32_t name_;
};

}  // namespace

Status finish(Interpreter& m, const Call& call) {
  const auto contour = find_contour(m, call);
  if (!contour) return fail(contour.error());
  restart_side(m);
  m.running = std::make_unique<FinishingRun>(contour->first, contour->contour_end, static_cast<std::uint32_t>(m.value('P')));
  return {};
}

Result<bool> end_contour(Interpreter& m) {
  std::vector<Finishing>& all = fanuc_of(m).finishing;
  // the program has left the contour by M99 or a restart, so the G70.7 of the contour is over
  while (!all.empty() && m.program().depth() < all.back().depth) all.pop_back();
  if (all.empty() || m.program().depth() != all.back().depth || m.program().position().offset < all.back().contour_end) return false;
  const Finishing ended = all.back();
  all.pop_back();
  const auto left = m.flow.end_subprogram(m.block->where);
  if (!left) return fail(left.error());
  m.origin = ended.origin;
  KADR_TRY(ended.in_side ? leave_side(m, ended.start) : go(m, MotionKind::rapid, ended.start));
  return true;
}

}  // namespace kadr::fanuc

namespace kadr::functions {

/// Executes G70.7 … G76.7 (19.2). call.row->arg is the code in tenths, such as 707 for G70.7.
Status turning_cycle(Interpreter& m, const Call& call) {
  if (m.def.behaviour.lathe != Lathe::none) return fanuc::turned_cycle(m, call);
  KADR_TRY(fanuc::possible(m, call));
  if (fanuc::is_first_line(m, call.row->arg)) return fanuc::first_line(m, call);
  macro_b_of(m).moved = true;
  if (call.row->arg == 70.7_g) return fanuc::finish(m, call);
  return fanuc::second_line(m, call);
}

/// G77.7, G78.7, G79.7 (19.1): each block with an axis word executes the cycle again. The cycle ends at its start point.
Status turning_simple(Emitter& m, const Call& call) {
  m.modal.motion_row = static_cast<std::int16_t>(call.row - m.def.codes.data());
  m.modal.motion = MotionMode::linear;
  fanuc::TurningMemory& memory = fanuc_of(m).state.turning;
  if (memory.code != call.row->arg) {
    memory.target = {};
    memory.known = {};
    memory.taper = memory.start_angle = 0;
    memory.code = call.row->arg;
  }
  if (m.block_axes_taken || !m.has_axis_words()) return {};
  KADR_TRY(fanuc::possible(m, call));
  KADR_TRY(fanuc::take_simple(m, call));
  return call.row->arg == 78.7_g ? fanuc::simple_thread(m, call) : fanuc::cut_once(m, call);
}

}  // namespace kadr::functions
