// Drilling cycles G73 … G89 (spec/nct/18): the data stored while a cycle is in force, and queries about these data for other functions.
// Used by the rest of control; tested by tests/control/fanuc/drilling_test.cpp.

#include "control/fanuc/drilling/drilling.h"

#include <cmath>
#include <utility>

#include "base/code_literals.h"
#include "base/tolerance.h"
#include "config/control/drill_steps.h"
#include "control/fanuc/drilling/drilling_axis.h"
#include "control/fanuc/drilling/drilling_run.h"
#include "control/fanuc/drilling/pattern.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/frames/transformations.h"
#include "control/fanuc/geometry/automatic_geometry.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/lathe/lathe_words.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::fanuc {
namespace {

constexpr double max_pecks = 1e6;
constexpr double max_holes = 99'999'999;

/// Returns the index in ControlDef::codes of the cycle in force, or -1 if no cycle is in force.
std::int16_t cycle_row(const BlockContext& m) {
  const std::int16_t row = m.modal.rows[fanuc_of(m).drilling_group];
  return row >= 0 && m.def.codes[static_cast<std::size_t>(row)].function == Function::drilling ? row : std::int16_t{-1};
}

/// Returns true if the block has a code of group 1, which determines the block's motion. A cycle in the same block is then not executed
/// (18.0, INFERRED).
bool moves_by_code(const BlockContext& m) {
  return m.has_code({Function::rapid, Function::linear, Function::arc_cw, Function::arc_ccw, Function::thread, Function::turning_simple});
}

/// Executes one block with a drilling cycle: stores its words, computes the levels, executes operation 1 and starts the other operations.
class Drilling {
 public:
  Drilling(Emitter& m, const Call& call)
      : m_(m), call_(call), code_(call.row->arg != 0 ? call.row->arg : call.row->tenth), memory_(fanuc_of(m).state.drilling) {
    const bool rigid = fanuc_of(m).state.rigid_tap || fanuc_of(m).settings.taps_rigid;
    if (rigid && (code_ == 84_g || code_ == 74_g)) code_ = code_ == 84_g ? 84.2_g : 84.3_g;
    if (code_ == only_back) code_ = 87_g;
  }

  Status run() {
    KADR_TRY(possible());
    const auto bottom = bottom_word(m_, *call_.row);
    if (!bottom) return fail(bottom.error());
    const int axis = drilling_axis(m_, *call_.row, *bottom);
    if (axis < 0) return fail(alarm(AlarmId::plane_illegal, call_.where));
    const AxisMask drills = AxisMask{1} << axis;
    if (m_.transform.moved_with(drills) != drills) return fail(alarm(AlarmId::plane_wrong, call_.where, code_text()));
    KADR_TRY(begin(static_cast<std::size_t>(axis), *bottom));
    // a block with R but without axis words also drills (spec/fanuc 10.1)
    const bool by_level = m_.def.behaviour.shifts_by_q();
    if (!m_.has_axis_words() && !(by_level && m_.has('R'))) return {};  // 18.2: a block without axis words does not execute the cycle
    KADR_TRY(resume_from(*bottom));
    double passes = 1;
    const char repeats = m_.def.behaviour.repeats_by_k && m_.has('K') ? 'K' : 'L';
    if (m_.has(repeats)) {
      // The reader has scaled K like a length without a decimal point. K is a number of holes here, so the scaling is undone.
      passes = m_.value(repeats) * std::pow(10.0, m_.word(repeats)->counted);
      if (passes != std::floor(passes)) return fail(alarm(AlarmId::word_not_integer, m_.where(repeats), repeats, passes));
      if (!(passes >= 0 && passes <= max_holes)) return fail(alarm(AlarmId::value_out_of_range, m_.where(repeats), repeats, passes));
    }
    if (passes == 0 || m_.has_code({Function::hole_pattern})) return {};
    if (is_lathe()) suspend_side(m_);
    KADR_TRY(over_hole(m_, memory_.axis));
    return start({}, static_cast<std::uint32_t>(passes));
  }

  /// Executes the cycle in force at each of the points (spec/haas 8.5). `points`: programmed coordinates of the plane, mm.
  Status at_points(std::vector<Vec2> points) {
    const auto count = static_cast<std::uint32_t>(points.size());
    return start(std::move(points), count);
  }

 private:
  Status start(std::vector<Vec2> points, std::uint32_t passes) {
    DrillingRun::Job job;
    job.passes = passes;
    job.points = std::move(points);
    KADR_TRY(levels(job));
    KADR_TRY(data(job));
    KADR_TRY(m_.feed_known(call_.where));
    KADR_TRY(within_reach(job));
    macro_b_of(m_).moved = true;
    m_.start_cycle<DrillingRun>(std::move(job));
    return {};
  }

  bool is_lathe() const { return m_.def.behaviour.lathe != Lathe::none; }
  bool is_tap() const { return code_ == 84.2_g || code_ == 84.3_g; }
  bool shifts() const { return code_ == 76_g || (code_ == 87_g && (spindle().orients || by_q())); }
  bool by_q() const { return m_.def.behaviour.shifts_by_q(); }
  bool has_percent() const { return code_ == 85_g || code_ == 89_g || is_tap(); }
  const SpindleSettings& spindle() const {
    return fanuc_of(m_).settings.spindles[static_cast<std::size_t>(fanuc_of(m_).state.current_spindle)];
  }
  std::string_view code_text() const { return call_.row->code; }

  Status possible() const {
    if (m_.modal.surface != PathSurface::plane) return fail(alarm(AlarmId::surface_state, call_.where, code_text()));
    if (code_ == 76_g && !spindle().orients && !by_q()) return fail(alarm(AlarmId::spindle_not_orientable, call_.where, code_text()));
    if (is_tap() && !spindle().indexes && !m_.def.behaviour.shifts_by_q())
      return fail(alarm(AlarmId::spindle_not_indexable, call_.where, double(fanuc_of(m_).state.current_spindle)));
    if (m_.has(comma_angle) && m_.has_axis_words()) KADR_TRY(one_coordinate(m_));
    for (const char letter : {'I', 'J', 'K'})
      if (m_.has(letter) && !belongs(letter)) return fail(alarm(AlarmId::illegal_address, m_.where(letter), letter));
    return {};
  }

  /// Returns true if the cycle reads the letter I, J or K: I and J in G17, K and I in G18, J and K in G19. A cycle with a percentage reads
  /// I in every plane.
  bool belongs(char letter) const {
    if (letter == 'I' && has_percent()) return true;
    if (m_.def.behaviour.shifts_by_q()) return true;
    switch (m_.modal.plane) {
      case Plane::zx: return letter != 'J';
      case Plane::yz: return letter != 'I';
      default: return letter != 'K';
    }
  }

  /// Switches the cycle mode on, or changes the drilling axis, and then stores the initial level. The block must give R and the bottom of
  /// the hole (18.0).
  Status begin(std::size_t axis, const Word* bottom) {
    const bool fresh = !drilling_on(m_);
    if (!fresh && axis == memory_.axis) return {};
    if (bottom == nullptr || !m_.has('R')) return fail(alarm(AlarmId::cycle_data_missing, call_.where));
    if (fresh) memory_ = {};
    memory_.axis = axis;
    memory_.initial = before_new_length()[axis];
    return {};
  }

  /// Returns the tool's position computed without the new tool length of this block, which takes effect with operation 3. The offset of a
  /// lathe's T takes effect before the block.
  Axes before_new_length() const {
    if (is_lathe()) return m_.position.programmed;
    Placement frames = m_.frames;
    frames.length = m_.state_before().modal.lengths;
    return m_.transform.to_programmed(frames.work_of(m_.position.machine));
  }

  Status resume_from(const Word* bottom) {
    if (bottom != nullptr) {
      memory_.bottom = coordinate(m_, *bottom, memory_.axis);
      memory_.bottom_added = is_increment(m_, *bottom);
    }
    if (const Word* const r = m_.word('R'); r != nullptr) {  // R is always a radius, even in diameter programming (5.3)
      memory_.level = m_.length_value('R');
      // R of drilling along X is a coordinate of X, and so a diameter (spec/haas-st 7.3)
      if (drills_on_side(*call_.row) && is_diameter(m_, memory_.axis)) memory_.level /= 2;
      memory_.level_added = !m_.modal.absolute || r->incremental;
    }
    const bool percent = has_percent() && !m_.def.behaviour.shifts_by_q();
    if (m_.has('I') && percent) KADR_TRY(positive('I', m_.value('I'), memory_.percent));
    if (m_.has('I') && !percent) memory_.shift.x = m_.length_value('I');
    if (m_.has('J')) memory_.shift.y = m_.length_value('J');
    if (m_.has('K') && !m_.def.behaviour.repeats_by_k) memory_.shift.z = m_.length_value('K');
    if (m_.has('Q') && by_q())
      memory_.peck = std::fabs(is_lathe() ? step_of(m_, 'Q') : m_.length_value('Q'));  // spec/fanuc 10.5: the sign of Q has no effect
    else if (m_.has('Q')) KADR_TRY(not_negative('Q', m_.length_value('Q'), memory_.peck));
    if (m_.has('E')) KADR_TRY(not_negative('E', m_.length_value('E'), memory_.clearance));
    if (m_.has('P') && m_.def.behaviour.dwell_unit != DwellUnit::seconds) {
      const auto seconds = dwell_by_digits(m_);
      if (!seconds) return fail(seconds.error());
      KADR_TRY(not_negative('P', *seconds, memory_.dwell));
    } else if (m_.has('P') && !m_.has_code({Function::dwell_or_turns}))
      KADR_TRY(not_negative('P', m_.value('P'), memory_.dwell));  // 18.2: P is the dwell at the bottom of the hole, with the unit of G4
    return {};
  }

  Status positive(char letter, double value, double& to) const {
    if (!(value > 0)) return fail(alarm(AlarmId::value_out_of_range, m_.where(letter), letter, value));
    to = value;
    return {};
  }

  Status not_negative(char letter, double value, double& to) const {
    if (!(value >= 0)) return fail(alarm(AlarmId::value_out_of_range, m_.where(letter), letter, value));
    to = value;
    return {};
  }

  Status levels(DrillingRun::Job& job) const {
    job.axis = memory_.axis;
    job.initial = memory_.initial;
    job.level = memory_.level_added ? memory_.initial + memory_.level : memory_.level;
    job.bottom = memory_.bottom_added ? job.level + memory_.bottom : memory_.bottom;
    job.to_initial = is_lathe() || m_.modal.retract_initial;  // spec/haas-st 7.1: the initial level always
    for (const double level : {job.level, job.bottom, job.initial})
      if (!(std::fabs(level) <= farthest))
        return fail(alarm(AlarmId::position_out_of_range, call_.where, std::string_view(m_.axis_names[memory_.axis]), level));
    return {};
  }

  /// Sets the data of the cycle; values of missing words come from the parameters. INFERRED: a percentage of 0 in a parameter means "not
  /// set"; 100 is then used.
  Status data(DrillingRun::Job& job) const {
    const Settings& s = fanuc_of(m_).settings;
    const auto percent = [](double value) { return value > 0 ? value : 100; };
    job.code = code_;
    job.peck = memory_.peck;
    job.dwell = memory_.dwell;
    const double clearance = code_ == 73_g ? s.return_g73 : code_ == 83_g ? s.clearance_g83 : s.tap_normal ? s.tap_clearance : s.tap_back;
    job.clearance = memory_.clearance >= 0 ? memory_.clearance : clearance;
    const double given = memory_.percent > 0 ? memory_.percent : percent(is_tap() ? s.tap_extraction : s.extraction);
    job.out_percent = is_tap() && !s.tap_override ? 100 : given;
    job.between_percent = s.tap_return_override ? percent(s.tap_return) : 100;
    job.pecks_to_level = s.tap_normal;
    job.orients_tap = s.tap_orients;
    job.back_boring = code_ == 87_g && shifts();
    if (shifts()) {
      const double values[] = {memory_.shift.x, memory_.shift.y, memory_.shift.z};
      const std::size_t first = m_.modal.plane == Plane::zx ? 2 : m_.modal.plane == Plane::yz ? 1 : 0;
      job.shift = {values[first], values[(first + 1) % 3]};
      if (by_q() && job.shift == Vec2{}) {  // spec/fanuc 10.5: two bits give the direction of the shift: 00 +X, 01 -X, 10 +Y, 11 -Y
        const double signed_shift = s.shift_negative ? -job.peck : job.peck;
        job.shift = s.shift_second ? Vec2{0, signed_shift} : Vec2{signed_shift, 0};
      }
    }
    if (m_.def.behaviour.cycle_words == CycleWords::pecks_by_ijk && memory_.shift.x > 0 &&
        (code_ == 73_g || code_ == 83_g)) {  // spec/haas 8.3: with word I in G73 or G83, each peck is shorter than the previous one
      job.peck = memory_.shift.x;
      job.less = std::max(memory_.shift.y, 0.0);
      job.least = std::max(memory_.shift.z, job.less > 0 ? tol::level : 0.0);
      if (job.least > 0 && std::fabs(job.level - job.bottom) / job.least > max_pecks)
        return fail(alarm(AlarmId::value_out_of_range, call_.where, 'K', memory_.shift.z));
    }
    if (m_.def.behaviour.cycle_words == CycleWords::pecks_by_ijk && code_ == 73_g && !(memory_.shift.x > 0))
      job.clear_after = std::max(memory_.shift.z, 0.0);
    job.rise = code_ == 83_g ? s.return_rise : 0;
    if ((code_ == 73_g || code_ == 83_g) && !(job.peck > 0))
      return fail(alarm(AlarmId::cycle_peck, m_.has('Q') ? m_.where('Q') : call_.where, job.peck));
    const double depth = std::fabs(job.level - job.bottom) * std::fabs(m_.transform.scale[job.axis]);
    if (job.peck > 0 && depth / job.peck > max_pecks)
      return fail(alarm(AlarmId::value_out_of_range, m_.has('Q') ? m_.where('Q') : call_.where, 'Q', job.peck));
    return {};
  }

  /// Checks that all levels of the first hole are within range, and also the position of the last hole, which L increments reach. After the
  /// start of the cycle no motion may raise an alarm.
  Status within_reach(const DrillingRun::Job& job) const {
    const Axes& first = m_.position.programmed;
    for (const double level : {job.initial, job.level, job.bottom}) {
      Axes hole = first;
      hole[memory_.axis] = level;
      const Axes work = m_.transform.to_work(hole);
      for (std::size_t a = 0; a < m_.axis_count; ++a)
        if (!(std::fabs(work[a]) <= farthest))
          return fail(alarm(AlarmId::position_out_of_range, call_.where, std::string_view(m_.axis_names[a]), work[a]));
    }
    Axes second;
    AxisMask named = 0;
    if (job.passes == 1 || m_.modal.polar_data) return {};
    KADR_TRY(hole_position(m_, memory_.axis, second, named));
    fanuc_of(m_).rolled = 0;
    for (std::size_t a = 0; a < m_.axis_count; ++a) {
      const double last = first[a] + (second[a] - first[a]) * (job.passes - 1);
      if ((named >> a & 1u) != 0 && !(std::fabs(last) <= farthest))
        return fail(alarm(AlarmId::position_out_of_range, call_.where, std::string_view(m_.axis_names[a]), last));
    }
    return {};
  }

  Emitter& m_;
  const Call& call_;
  std::int32_t code_;
  DrillingMemory& memory_;
};

/// Checks that the control has the cycle. With the codes of lathes (parameter bit N1503 CSM), the drilling cycles are G83.1, G84.1, G86.1
/// in place of G73, G74, G76.
Status known(const BlockContext& m, const Call& call) {
  const bool alias = call.row->arg == 73_g || call.row->arg == 74_g || call.row->arg == 76_g;
  const bool replaced = call.row->tenth == 73_g || call.row->tenth == 74_g || call.row->tenth == 76_g;
  const bool lathe = fanuc_of(m).settings.lathe_codes;
  if (alias ? lathe : !(replaced && lathe)) return {};
  return fail(
      alarm(AlarmId::code_unknown, call.where, call.word != nullptr ? m.block->text_of(call.where) : std::string_view(call.row->code)));
}

}  // namespace

bool drilling_on(const BlockContext& m) { return cycle_row(m) >= 0; }

std::int16_t motion_row(const BlockContext& m) {
  const std::int16_t row = cycle_row(m);
  return row < 0 || m.has_code({Function::drilling_off}) ? m.modal.motion_row : row;
}

int drills_along(const BlockContext& m) {
  if (m.def.behaviour.lathe != Lathe::none) return -1;  // T of a lathe has put the lengths of all axes into force
  const bool coded = m.has_code({Function::drilling});
  if (!coded && (!drilling_on(m) || m.block_axes_taken || m.has_code({Function::drilling_off}))) return -1;
  if (!m.has_axis_words() || moves_by_code(m)) return -1;
  const std::int16_t row = motion_row(m);
  const CodeRow& cycle = m.def.codes[static_cast<std::size_t>(std::max<std::int16_t>(row, 0))];
  const auto bottom = bottom_word(m, cycle);
  return bottom ? drilling_axis(m, cycle, *bottom) : -1;
}

void note_code(Interpreter& m, const CodeRow& row, std::int32_t tenth) {
  if (row.letter == 'M' && fanuc_of(m).settings.part_code != 0 && tenth == 10 * fanuc_of(m).settings.part_code)
    macro_b_of(m).state.parts_done += 1;  // 13.1: this M code counts a finished part
  if (row.letter == 'M' && is_haas(m)) note_run_out(fanuc_of(m), row);
  if (row.function == Function::machine_function) fanuc_of(m).state.machine_may_turn = true;
  note_mirror_code(m, row);
  if (row.group != fanuc_of(m).motion_group) return;
  // 19.1: a code of group 1 ends the simple turning cycle
  if (row.function != Function::turning_simple) fanuc_of(m).state.turning.code = 0;
  if (drilling_on(m)) m.run_modes({Function::drilling_off});
}

Status check_drilling(const Emitter& m) {
  const auto* const run = dynamic_cast<const DrillingRun*>(m.running.get());
  return run == nullptr ? Status() : run->check(m);
}

Status check_increment_of_r(const BlockContext& m) {
  const Word* const r = m.word('R');
  if (r == nullptr || !r->incremental || drilling_on(m) ||
      m.has_code({Function::drilling, Function::set_tables, Function::plane_rotation_on}))
    return {};  // 5.1: an R word with the operator I is allowed in a drilling cycle, and in the blocks of G10 and G68, where R is no level
  return fail(alarm(AlarmId::increment_not_allowed, r->where, r->written));
}

}  // namespace kadr::fanuc

namespace kadr::functions {

/// G73 … G89 (18), in the phase `positioning` of the block: executes operation 1 (the motion over the hole). The other operations of the
/// cycle follow one by one after the block's functions.
Status drilling(Emitter& m, const Call& call) {
  KADR_TRY(fanuc::known(m, call));
  if (fanuc::moves_by_code(m)) return {};
  if (m.def.behaviour.lathe == Lathe::fanuc) return fanuc::turned_drilling(m, call);
  return fanuc::Drilling(m, call).run();
}

/// Executes G80 (18.1.4) or a code of group 1: deletes the cycle's data and puts G98 into force.
Status drilling_off(Interpreter& m, const Call&) {
  if (!fanuc::drilling_on(m)) return {};
  fanuc_of(m).state.drilling = {};
  fanuc_of(m).state.rigid_tap = false;
  if (!m.has_code({Function::retract_level})) m.run_modes({Function::retract_initial});
  return {};
}

/// Executes G70, G71, G72 while a drilling cycle is in force (spec/haas 8.5): drills holes on a circle, an arc or a line, relative to the
/// tool's position.
Status hole_pattern(Emitter& m, const Call& call) {
  const std::int16_t row = fanuc::motion_row(m);
  if (!fanuc::drilling_on(m) || row < 0) return fail(alarm(AlarmId::cycle_data_missing, call.where));
  auto points = fanuc::pattern_points(m, call);
  if (!points) return fail(points.error());
  const Call cycle{&m.def.codes[static_cast<std::size_t>(row)], nullptr, call.where};
  return fanuc::Drilling(m, cycle).at_points(std::move(*points));
}

}  // namespace kadr::functions
