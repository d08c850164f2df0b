// FlatProgram: writes the actions of a run as flat blocks of the target control. Used by convert/conversion; tested by tests/convert.

#include "convert/flat/flat_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "base/tolerance.h"
#include "out/program/words.h"
#include "path/curve/machine_path.h"

namespace kadr {
namespace {

constexpr double same_value = 1e-9;
constexpr int max_turns = 1000;
constexpr int first_system = 53;  // the work system of G54 has the number 1, so code = number + 53

/// Returns the plane code 17, 18 or 19 for the plane of an arc; 0 if the arc lies in no coordinate plane.
int plane_of(const Motion& motion, const std::vector<std::string>& axes) {
  const auto is = [&](const char* a, const char* b) {
    const std::string &first = axes[motion.first], &second = axes[motion.second];
    return (first == a && second == b) || (first == b && second == a);
  };
  return is("X", "Y") ? 17 : is("X", "Z") ? 18 : is("Y", "Z") ? 19 : 0;
}

char centre_letter(const std::string& axis) { return axis == "X" ? 'I' : axis == "Y" ? 'J' : 'K'; }

}  // namespace

Status FlatProgram::no_code(const char* what) { return fail(alarm(AlarmId::function_has_no_code, {}, std::string_view(what))); }

Status FlatProgram::begin(const ToolPosition& stand, const Placement& placement) {
  placement_ = placement;
  written_origin_ = placement.origin;
  at_ = stand.machine;
  blocks_.begin();
  if (blocks_.def().grammar.percent_frames) {  // writes the number under which the control stores the program
    blocks_.text(blocks_.program_label(1));
    KADR_TRY(blocks_.end());
  }
  if (source_.turns) KADR_TRY(begin_turning());
  else blocks_.code_if_there({{Function::plane_xy, any_argument}, {Function::select_plane, 17}});
  // a lathe may have no code for absolute dimensions, because its words U and W are the increments (spec/fanuc-t 1.1)
  if (!blocks_.code_if_there({{Function::absolute, any_argument}}) && !has_turret()) return no_code("absolute");
  KADR_TRY(blocks_.end());
  blocks_.code_if_there({{Function::millimetre, any_argument}});
  if (blocks_.def().behaviour.arc_centers == ArcCenters::by_code) KADR_TRY(blocks_.code({{Function::centers_incremental, any_argument}}));
  return blocks_.end();
}

std::optional<char> FlatProgram::letter_of(std::size_t axis) const {
  if (axis >= axes_.size() || axes_[axis].size() != 1) return std::nullopt;
  const char letter = axes_[axis].front();
  if (letter < 'A' || letter > 'Z') return std::nullopt;
  const AddressRow& row = blocks_.def().address(letter);
  const bool moves = row.function == Function::axis || row.function == Function::machine_axis;
  return moves && blocks_.has_word(letter) ? std::optional(letter) : std::nullopt;
}

Axes FlatProgram::base() const {
  if (form_ == FlatForm::plain) return {};
  Axes base = placement_.length;
  if (is_between()) {
    for (std::size_t a = 0; a < max_axes; ++a) base[a] += written_origin_[a];
    return base;
  }
  if (const auto found = source_.zeros.find(system_); found != source_.zeros.end())
    for (std::size_t a = 0; a < max_axes; ++a) base[a] += found->second[a];
  return base;
}

Status FlatProgram::take(const Action& action, const OffsetsInForce& now) {
  KADR_TRY(write_held(&action));
  const bool is_act = by_kind(
      action, same<Motion, FrameChange>(false),
      // Codes that the control executes itself are omitted, because the flat program has its own calls and ends
      [](const MachineFunction& function) { return !function.by_control; },
      // T of a lathe belongs to the block of its motion, which ends with the new offset (spec/fanuc-t 4.1)
      [&](const ToolChange&) { return !has_turret(); },
      same<Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, AuxiliaryFunction, Stop, Message, SurfaceSpeed, Sync, ZoneChange, Couple,
           Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>(true));
  has_acts_ = has_acts_ || is_act;
  return by_kind(
      action, [&](const Motion& m) { return hold(m, now) ? Status() : motion(m, now); },
      [&](const FrameChange& frame) {
        placement_ = frame.placement;
        return Status();
      },
      [&](const MachineFunction& function) { return function.by_control ? Status() : machine_code(function.code); },
      [&](const Spindle& turned) { return spindle(turned); },  //
      [&](const Speed& of) { return speed(of); },
      [&](const ToolSelect& selected) { return tool(selected.tool, selected.corrector, false); },
      [&](const ToolChange& change) {
        if (change.there) return no_code("tool_word");
        return has_turret() ? turret(change.tool, now) : tool(change.tool, 0, true);
      },
      [&](const Dwell& pause) { return dwell(pause.seconds); },
      [&](const CoolantSwitch& switched) { return coolant(coolant_ = switched.what); },  //
      [&](const Stop& stop) { return this->stop(stop); },                                //
      [&](const Message& message) { return this->message(message); }, [&](const AuxiliaryFunction&) { return no_code("auxiliary_word"); },
      [&](const ZoneChange&) { return no_code("work_area_on"); },                                                        //
      [&](const Couple&) { return no_code("gear_on"); },                                                                 //
      [&](const Uncouple&) { return no_code("gear_on"); }, [&](const SurfaceSpeed& law) { return surface_limit(law); },  //
      same<Sync, CompensationBreak, CompensationCorner, CompensationCheck>(Status()));
}

Status FlatProgram::end_block() {
  KADR_TRY(write_held());
  has_acts_ = false;
  if (std::exchange(wants_direction_, false)) KADR_TRY(spindle_on());
  if (!turret_word_.empty()) blocks_.text(std::exchange(turret_word_, {}));
  return blocks_.end();
}

Status FlatProgram::finish() {
  KADR_TRY(end_block());
  KADR_TRY(blocks_.code({{Function::program_end, any_argument}, {Function::tape_end, any_argument}}));
  KADR_TRY(blocks_.end());
  blocks_.close();
  return {};
}

void FlatProgram::pass(const Action& action) {
  by_kind(
      action,
      [&](const Motion& m) {
        at_ = m.machine;
        has_probed_ = has_probed_ || m.kind == MotionKind::probe;
        system_ = m.system, side_ = m.side;
        if (m.kind != MotionKind::rapid && m.kind != MotionKind::home) unit_ = source_unit_ = m.unit;
        if (is_arc(m.kind) || m.side != 0) plane_ = plane_of(m, axes_);
        if (m.kind != MotionKind::rapid) tolerance_ = m.tolerance, corners_ = m.corner_speed;
        if (m.kind == MotionKind::feed && !m.exact) smoothing_ = m.smoothing;
      },
      [&](const FrameChange& frame) {
        placement_ = frame.placement;
        written_origin_ = placement_.origin;
      },
      [&](const Spindle& turned) {
        turns_ = turned.dir;
        if (turned.rpm > 0) rpm_ = turned.rpm;
      },
      [&](const CoolantSwitch& switched) { coolant_ = switched.what; }, [&](const Speed& of) { surface_ = of.surface, rpm_ = of.value; },
      [&](const ToolSelect& selected) { selected_ = selected.tool; },
      [&](const ToolChange& change) { selected_ = has_turret() ? change.tool : selected_; },
      ignores<Dwell, MachineFunction, AuxiliaryFunction, Stop, Message, SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, CompensationBreak,
              CompensationCorner, CompensationCheck>);
}

Status FlatProgram::open(const FlatBefore& before, const OffsetsInForce& now) {
  written_offsets_ = now;
  is_exact_ = before.exact && has_stop_modes();
  system_is_written_ = true;
  known_ = 0, code_ = Function::count, feed_ = -1;
  relative_ = before.incremental && row_that_does(blocks_.def(), {{Function::incremental, any_argument}}) != nullptr;
  corners_ = before.corners, smoothing_before_ = smoothing_;
  if (before.inch) KADR_TRY(blocks_.code({{Function::millimetre, any_argument}}));
  return blocks_.end();
}

Status FlatProgram::close(const FlatBefore& after) {
  KADR_TRY(end_block());
  if (unit_ && unit_ != source_unit_ &&
      (source_unit_ != FeedUnit::mm_per_rev || row_that_does(blocks_.def(), {{Function::feed_per_revolution, any_argument}}) != nullptr))
    KADR_TRY(feed_unit(source_unit_));
  if (modes_.speeds && !after.exact && corners_ != after.corners) KADR_TRY(corner_mode(after.corners));
  else if (has_stop_modes() && is_exact_ != after.exact) KADR_TRY(stop_mode(after.exact));
  if (modes_.smoothing && smoothing_ != smoothing_before_) KADR_TRY(smoothing_mode(smoothing_before_));
  if (after.inch) KADR_TRY(blocks_.code({{Function::inch, any_argument}}));
  return blocks_.end();
}

/// Writes the codes that must precede the motion in blocks of their own: plane and work offset.
Status FlatProgram::write_before_motion(const Motion& motion, const OffsetsInForce& now) {
  if (is_arc(motion.kind) || motion.side != 0) {
    const int plane = plane_of(motion, axes_);
    if (plane == 0) return no_code("select_plane");
    if (plane != plane_) {
      constexpr Function by[] = {Function::plane_xy, Function::plane_zx, Function::plane_yz};
      KADR_TRY(blocks_.code({{by[plane - 17], any_argument}, {Function::select_plane, plane}}));
      plane_ = plane;
      KADR_TRY(blocks_.end());
    }
  }
  KADR_TRY(length_by_word(now));
  if (is_between() && system_is_written_) system_ = motion.system;
  if (form_ == FlatForm::plain || motion.system == system_ || !source_.has_systems) return {};
  known_ = 0;  // work offsets that are equal in this set-up may differ on the machine, so the next motion writes all axes again
  const int system = motion.system;
  // without a work offset in force, each motion is written in machine coordinates, and no code is needed here
  if (system == 0 && has_no_zeroless_system()) return {};
  if (std::size_t(system) < source_.systems.size() && !source_.systems[std::size_t(system)].empty())
    blocks_.text(source_.systems[std::size_t(system)]);
  else if (!blocks_.code_if_there({{Function::work_system, system},
                                   {Function::work_zero, system},
                                   {Function::fixture, system},
                                   {Function::table_system, system}}))
    return no_code(("G" + std::to_string(first_system + system)).c_str());
  system_ = motion.system;
  written_origin_ = placement_.origin;
  return blocks_.end();
}

/// Writes the codes that belong to the block of the motion: tool length and cutter compensation.
Status FlatProgram::write_with_motion(const Motion& motion, const OffsetsInForce& now) {
  if (is_by_codes() && motion.side != side_) {
    if (motion.side == 0)
      KADR_TRY(blocks_.code(
          {{Function::radius_comp_off, any_argument}, {Function::radius_side, 0}, {Function::compensation_off, any_argument}}));
    else if (motion.side > 0)
      KADR_TRY(blocks_.code({{Function::radius_comp_left, any_argument}, {Function::radius_side, 1}, {Function::tool_side, 41}}));
    else KADR_TRY(blocks_.code({{Function::radius_comp_right, any_argument}, {Function::radius_side, 2}, {Function::tool_side, 42}}));
    if (has_turret()) KADR_TRY(motion.side == 0 ? Status() : side_of_turret(now));
    else if (motion.side != 0 && now.radius_number != 0) KADR_TRY(blocks_.word('D', now.radius_number));
    side_ = motion.side;
  }
  if (has_turret()) return turret_offset(now);
  const OffsetsInForce& last = written_offsets_;
  const bool same = now.length_sign == last.length_sign && (now.length_sign == 0 || now.length_number == last.length_number);
  if (form_ == FlatForm::plain || same || is_length_by_word() || blocks_.def().grammar.named_blocks) return {};  // spec/sinumerik 13
  if (now.length_sign == 0)
    KADR_TRY(blocks_.code({{Function::length_off, any_argument},
                           {Function::length_comp, 0},
                           {Function::tool_length_off, any_argument},
                           {motion.side == 0 ? Function::compensation_off : Function::length_off, any_argument}}));
  else if (now.length_sign > 0 && source_.turning_length != nullptr) return turning_length(now);
  else if (now.length_sign > 0)
    KADR_TRY(blocks_.code({{Function::length_plus, any_argument}, {Function::length_comp, 1}, {Function::tool_length, 0}}));
  else KADR_TRY(blocks_.code({{Function::length_minus, any_argument}, {Function::length_comp, 2}}));
  if (now.length_sign != 0)
    KADR_TRY(
        blocks_.word(blocks_.has_word('H') && blocks_.def().address('H').function != Function::repeat_word ? 'H' : 'D', now.length_number));
  written_offsets_ = now;
  return {};
}

Status FlatProgram::motion(const Motion& motion, const OffsetsInForce& now) {
  if (has_acts_) KADR_TRY(end_block());
  if (std::exchange(has_probed_, has_probed_ || motion.kind == MotionKind::probe) && !after_probe_allowed_) return no_code("probe");
  KADR_TRY(smoothing(motion));
  KADR_TRY(write_before_motion(motion, now));
  KADR_TRY(write_with_motion(motion, now));
  const bool is_rapid = motion.kind == MotionKind::rapid || motion.kind == MotionKind::home, in_machine = is_in_machine(motion);
  if (in_machine && !is_rapid && (motion.kind != MotionKind::feed || !cuts_in_machine())) return no_code("machine_coordinates");
  switch (motion.kind) {
    case MotionKind::rapid:
    case MotionKind::home:
      if (is_by_reference(motion)) KADR_TRY(reference_motion(motion));
      else if (is_without_zero(motion)) KADR_TRY(motion_without_zero(Function::rapid, motion));
      else KADR_TRY(in_machine ? machine_motion(Function::rapid, motion) : straight(Function::rapid, motion));
      break;
    case MotionKind::feed:
      KADR_TRY(rounding(motion));
      KADR_TRY(corners(motion));
      KADR_TRY(end_of_motion(motion.exact));
      KADR_TRY(feed(motion));
      KADR_TRY(in_machine ? machine_motion(Function::linear, motion) : straight(Function::linear, motion));
      break;
    case MotionKind::arc_cw:
    case MotionKind::arc_ccw:
      KADR_TRY(rounding(motion));
      KADR_TRY(corners(motion));
      KADR_TRY(feed(motion));
      KADR_TRY(arc(motion));
      break;
    case MotionKind::probe:
      KADR_TRY(feed(motion));
      // Another code of the same modal group may have replaced the motion code, so the next motion writes its code again.
      code_ = Function::count;
      KADR_TRY(blocks_.code({{Function::probe, any_argument}, {Function::measure, any_argument}, {Function::probe_move, 2}}));
      KADR_TRY(axis_words(motion));
      break;
    case MotionKind::thread: KADR_TRY(thread(motion)); break;
    case MotionKind::spline: return no_code("spline");
  }
  at_ = motion.machine;
  // The end of this motion is not given in work coordinates, which depend on the work offset. So the work coordinates of the moved axes are
  // unknown, and the next motion writes these axes again.
  if (motion.end_reference != EndReference::by_work) known_ &= ~motion.named;
  else note_system(motion);
  ++motions_;
  return blocks_.end();
}

void FlatProgram::note_system(const Motion& motion) {
  if (!counts_from_) counts_from_ = motion.system;
  else if (*counts_from_ != motion.system) counts_from_several_ = true;
}

Status FlatProgram::motion_code(Function function) {
  if (function == code_) return {};
  code_ = function;
  return blocks_.code({{function, any_argument}});
}

/// Writes a straight motion, without the axes that are already at their target. Axes whose position is not known are always written.
Status FlatProgram::straight(Function function, const Motion& motion) {
  KADR_TRY(motion_code(function));
  return axis_words(motion);
}

Status FlatProgram::axis_words(const Motion& motion) {
  const Axes zero = base();
  bool any = false;
  for (const bool all_named : {false, true}) {
    for (std::size_t a = 0; a < axes_.size() && a < max_axes && !(all_named && any); ++a) {
      const bool is_named = (motion.named >> a & 1U) != 0, is_new = is_named && (known_ >> a & 1U) == 0;
      if (!is_new && !(all_named && is_named) && std::fabs(motion.machine[a] - at_[a]) <= same_value) continue;
      KADR_TRY(axis_word(a, word_of(a, motion.machine[a], zero[a])));
      known_ |= AxisMask{1} << a;
      any = any || !all_named;
    }
  }
  return {};
}

Status FlatProgram::arc(const Motion& motion) {
  if (motion.detail && motion.detail->surface != PathSurface::plane) return no_code("polar_surface_on");
  const std::size_t first = motion.first, second = motion.second;
  Axes middle = motion.to;
  middle[first] = motion.center.x, middle[second] = motion.center.y;
  const Axes on_machine = placement_.machine_of(middle);
  const Vec2 centre{on_machine[first], on_machine[second]};
  const Function function = motion.kind == MotionKind::arc_cw ? Function::arc_cw : Function::arc_ccw;
  const int turns = std::max(1, int(std::ceil(motion.turns - tol::whole_number))), pieces = is_written_by_lead(motion, turns) ? 1 : turns;
  const Axes from = at_;
  const Arms arms{std::hypot(from[first] - centre.x, from[second] - centre.y),
                  std::hypot(motion.machine[first] - centre.x, motion.machine[second] - centre.y)};
  if (is_spiral(arms)) return spiral(motion, centre, arms);
  if (pieces > max_turns) return no_code("arc_cw");
  const double radius = arms.begin, begin = std::atan2(from[second] - centre.y, from[first] - centre.x);
  const double sense = function == Function::arc_ccw ? 1 : -1;
  for (int i = 1; i <= pieces; ++i) {  // each revolution is a block of its own, and all revolutions have the same angle
    Axes end = motion.machine;
    if (i < pieces) {
      const double part = double(i) / pieces, angle = begin + sense * 2 * pi * motion.turns * part;
      for (std::size_t a = 0; a < max_axes; ++a) end[a] = from[a] + (motion.machine[a] - from[a]) * part;
      end[first] = centre.x + radius * std::cos(angle), end[second] = centre.y + radius * std::sin(angle);
    }
    KADR_TRY(end_of_motion(motion.exact && i == pieces));
    KADR_TRY(one_arc(function, motion, centre, end, turns / pieces));
    if (i < pieces) KADR_TRY(blocks_.end());
    at_ = end;
  }
  return {};
}

/// Returns the start of the arc as the target control computes it from the rounded words of the preceding blocks. The words for the centre
/// of the arc are relative to this position.
Axes FlatProgram::written_position(const Axes& zero) const {
  Axes place = at_;
  for (std::size_t a = 0; a < axes_.size() && a < max_axes && !relative_; ++a)
    if ((known_ >> a & 1U) != 0) place[a] = zero[a] + rounded(a, at_[a] - zero[a]);
  return place;
}

/// True if a helix of several revolutions can be one block, because the control has a word for its lead (spec/s2c42 7).
bool FlatProgram::is_written_by_lead(const Motion& motion, int turns) const {
  if (!blocks_.def().behaviour.helix_by_lead() || turns < 2) return false;
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a) {
    if (a == motion.first || a == motion.second || std::fabs(motion.machine[a] - at_[a]) <= same_value) continue;
    const double rise = rise_of(a, motion.machine), lead = Words(blocks_.def(), centre_letter(axes_[a])).rounded(rise / turns);
    return letter_of(a) && lead > 0 && std::fabs(rise / lead - turns) <= tol::whole_turns;
  }
  return false;
}

/// Adds to one block the words of an arc, or of a helix of several revolutions.
///   centre, to  centre and end point of the arc, machine coordinates
///   turns       number of revolutions of the helix, rounded up, since the last one may be incomplete
Status FlatProgram::one_arc(Function function, const Motion& motion, Vec2 centre, const Axes& to, int turns) {
  KADR_TRY(motion_code(function));
  const Axes zero = base();
  const std::size_t plane[] = {motion.first, motion.second};
  const Axes begins = written_position(zero);
  double lead = 0;
  char lead_letter = 'K';
  for (std::size_t a = 0; a < axes_.size() && a < max_axes; ++a) {
    const bool in_plane = a == plane[0] || a == plane[1];
    if (!in_plane && std::fabs(to[a] - at_[a]) <= same_value) continue;
    KADR_TRY(axis_word(a, word_of(a, to[a], zero[a])));
    known_ |= AxisMask{1} << a;
    if (!in_plane && blocks_.def().behaviour.helix_by_lead()) lead = rise_of(a, to) / turns, lead_letter = centre_letter(axes_[a]);
  }
  const bool absolute = blocks_.def().behaviour.arc_centers == ArcCenters::as_distance && !relative_;  // spec/s2c42 7
  const double of[] = {centre.x, centre.y};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const std::size_t axis = plane[i];
    KADR_TRY(blocks_.word(centre_letter(axes_[axis]), of[i] - (absolute ? zero[axis] : begins[axis])));
  }
  return lead != 0 ? blocks_.word(lead_letter, lead) : Status();
}

}  // namespace kadr
