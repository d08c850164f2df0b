// Canned cycles G73, G74, G81 to G89: reads and checks their words (spec/linuxcnc 7.6; convert_cycle, convert_cycle_xy, CYCLE_MACRO of
// LinuxCNC's source).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "base/units.h"
#include "base/vec.h"
#include "control/emitter.h"
#include "control/functions/functions.h"
#include "control/linuxcnc/hole.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/spindles.h"

namespace kadr::linuxcnc {
namespace {

constexpr double same_level = 1e-9;
constexpr double max_pecks = 1e6;
constexpr double max_repeats = 1e8;

/// Computes the levels of a canned cycle from its words. The checks are in the order of LinuxCNC's source.
class Reader {
 public:
  Reader(Emitter& m, const kadr::Call& call) : m_(m), call_(call), control_(linuxcnc_of(m)) {}

  Status run() {
    hole_.code = call_.row->tenth;
    hole_.plane = m_.modal.plane;
    hole_.first = m_.modal.axes.first;
    hole_.second = m_.modal.axes.second;
    hole_.drill = m_.modal.axes.normal;
    of_uvw_ = is_plane_of_uvw(m_);
    if (of_uvw_ && hole_.drill < axis_u) hole_.first += axis_u, hole_.second += axis_u, hole_.drill += axis_u;
    const bool same = control_.codes.g1() < 0 || control_.state.motion == hole_.code;
    const bool follows = control_.state.cycle_began;
    KADR_TRY(allowed(same));
    resume_from();
    levels(follows);
    const double least = std::min(hole_.bottom, hole_.level);
    if (!(std::fabs(least) <= farthest && std::fabs(hole_.level) <= farthest))
      return fail(alarm(AlarmId::position_out_of_range, call_.where, m_.letters.axis_letter[hole_.drill], least));
    if (hole_.level < hole_.bottom) return wrong(fmt::format("R less than {} in cycle in {} plane", drill_letter(), plane_name()));
    KADR_TRY(of_code(same));
    choose_spindle();
    spindle_turns();
    KADR_TRY(holes());
    warn_turned();
    control_.state.cycle_began = true;
    m_.modal.motion = MotionMode::cycle;
    m_.modal.motion_row = static_cast<std::int16_t>(call_.row - m_.def.codes.data());
    m_.cycle_memory.row = m_.modal.motion_row;
    begin_drilling(m_, hole_);
    return {};
  }

 private:
  tl::unexpected<Alarm> wrong(std::string text) const { return control_.fault(AlarmId::rs274_cycle, call_.where, std::move(text)); }

  /// Returns the letter of the drilling axis in the letter case of LinuxCNC's alarm texts: `z` in plane `xy`, but `W` in plane `UV`.
  char drill_letter() const {
    const char letter = m_.letters.axis_letter[hole_.drill];
    return of_uvw_ ? letter : static_cast<char>(letter | 0x20);
  }
  const char* plane_name() const {
    switch (hole_.plane) {
      case Plane::xy: return of_uvw_ ? "UV" : "xy";
      case Plane::yz: return of_uvw_ ? "VW" : "yz";
      default: return of_uvw_ ? "UW" : "xz";
    }
  }

  /// Refuses words of U, V, W in a plane of X, Y, Z and words of X, Y, Z in a plane of U, V, W, and drilling along an axis that the machine
  /// lacks.
  Status axes_of_plane(bool same) const {
    constexpr std::string_view xyz = "XYZ", uvw = "UVW", planes_of_xyz[] = {"XY", "XZ", "YZ"};
    for (const char letter : of_uvw_ ? xyz : uvw)
      if (m_.has(letter))
        return wrong(fmt::format("Cannot put a{} {} in a canned cycle in the {} plane", letter == 'X' ? "n" : "", letter,
                                 of_uvw_ ? plane_name()
                                         : planes_of_xyz[hole_.plane == Plane::xy   ? 0
                                                         : hole_.plane == Plane::zx ? 1
                                                                                    : 2]));
    const char drill = m_.letters.axis_letter[hole_.drill];
    if (same || m_.has(drill)) return {};
    if (hole_.drill >= m_.axis_count || (control_.axes >> hole_.drill & 1U) == 0)
      return wrong(fmt::format("G{}{} canned cycle is not possible on a machine without {} axis",
                               hole_.plane == Plane::xy   ? 17
                               : hole_.plane == Plane::zx ? 18
                                                          : 19,
                               of_uvw_ ? ".1" : "", drill));
    return wrong(fmt::format("{} value unspecified in {} plane canned cycle", drill, plane_name()));
  }

  Status allowed(bool same) {
    if (m_.modal.feed_mode == FeedMode::inverse_time) return wrong("Cannot use inverse time feed with canned cycles");
    if (!(m_.modal.feed_known && m_.modal.feed > 0)) return wrong("Cannot feed with zero feed rate");
    if (m_.modal.radius_side != 0)
      return control_.fault(AlarmId::rs274_compensation, call_.where, "Cannot use canned cycles with cutter compensation on");
    if (!same && !m_.has('R')) return wrong("R clearance plane unspecified in cycle");
    if (m_.has('L') && std::round(m_.value('L')) == 0) return wrong("Cannot do zero repeats of cycle");
    return axes_of_plane(same);
  }

  /// Stores a fault that is reported only after the tool has moved to the drilling position, as in LinuxCNC.
  void at_hole(AlarmId id, std::string text) {
    if (hole_.fault != no_alarm) return;
    hole_.fault = id;
    hole_.fault_text = std::move(text);
    hole_.where = call_.where;
  }

  /// Reads the spindle number `$` at the same step of the cycle as LinuxCNC's source. The alarm text, with its mistakes, is LinuxCNC's.
  void choose_spindle() {
    const bool taps = hole_.code == 84_g || hole_.code == 74_g;
    const bool in_uw = of_uvw_ && hole_.plane == Plane::zx;
    const bool reads = taps || (in_uw && (hole_.code == 86_g || hole_.code == 87_g || hole_.code == 88_g));
    const char* const text =
        !of_uvw_ && hole_.plane == Plane::zx ? "Invalid E-number in G74/G84 cycle" : "Invalid spindle ($) number in G74/G84 cycle";
    if (reads && hole_.fault == no_alarm && !take_spindle(m_, text, call_.where)) {
      at_hole(AlarmId::rs274_spindle, text);
      hole_.fault_above = true;
    }
    hole_.spindle_number = control_.state.active_spindle;
    hole_.spindle = direction_of(m_, hole_.spindle_number);
    hole_.rpm = rpm_of(m_, hole_.spindle_number);
  }

  void spindle_turns() {
    const SpindleDir dir = hole_.spindle;
    const bool turns = dir == SpindleDir::cw || dir == SpindleDir::ccw;
    const auto spindle = [&](const char* text) { at_hole(AlarmId::rs274_spindle, text); };
    if (hole_.code == 84_g && !turns) spindle("Spindle not turning in G84");
    if (hole_.code == 84_g && dir == SpindleDir::ccw) spindle("Spindle turning counterclockwise in G84");
    if (hole_.code == 74_g && !turns) spindle("Spindle not turning in G74");
    if (hole_.code == 74_g && dir == SpindleDir::cw) spindle("Spindle turning clockwise in G74");
    if (of_uvw_ && (hole_.code == 84_g || hole_.code == 74_g))
      at_hole(AlarmId::rs274_cycle, fmt::format("G{} for plane {} not implemented", hole_.code / 10, plane_name()));
    if (hole_.code == 86_g && !turns) spindle("Spindle not turning in g86");
    if (hole_.code == 87_g && !turns) spindle("Spindle not turning in g87");
    if (hole_.code == 88_g && !turns) spindle("Spindle not turning in g88");
  }

  void resume_from() {
    CycleMemory& memory = m_.cycle_memory;
    if (const char drill = m_.letters.axis_letter[hole_.drill]; m_.has(drill)) {
      // The drilling axis is the diameter axis X (G7 in the plane of G19); R remains a radius (LinuxCNC 2.9, #2948).
      const bool is_diameter = (m_.modal.diameter >> hole_.drill & 1u) != 0;
      memory.bottom = m_.length_value(drill) / (is_diameter ? 2 : 1);
    }
    if (m_.has('R')) memory.level = m_.length_value('R');
    if (m_.has('P')) memory.dwell = m_.value('P');
    if (m_.has('Q')) memory.peck = m_.length_value('Q');
    if (m_.has('I')) memory.i = m_.length_value('I');
    if (m_.has('J')) memory.j = m_.length_value('J');
    if (m_.has('K')) memory.k = m_.length_value('K');
  }

  void levels(bool follows) {
    const CycleMemory& memory = m_.cycle_memory;
    const double here = m_.position.programmed[hole_.drill];
    if (!follows) control_.state.old_z = here;
    double old_z = control_.state.old_z;
    hole_.level = m_.modal.absolute ? memory.level : old_z + memory.level;
    hole_.bottom = m_.modal.absolute ? memory.bottom : hole_.level + memory.bottom;
    hole_.up_first = old_z < hole_.level - same_level;
    if (hole_.up_first) old_z = hole_.level;
    hole_.clear = m_.modal.retract_initial ? old_z : hole_.level;
    hole_.peck = memory.peck;
    hole_.dwell = memory.dwell;
    const double of_xyz[] = {memory.i, memory.j, memory.k};  // the words I, J, K are increments along X, Y, Z, or along U, V, W
    const auto along = [&](std::size_t axis) { return of_xyz[axis % 3]; };
    hole_.i = along(hole_.first);
    hole_.j = along(hole_.second);
    hole_.back = along(hole_.drill) + (m_.modal.absolute ? 0 : hole_.bottom);
  }

  /// Checks that each word which the cycle needs is in the block or was stored by an earlier block. A fault is reported after the tool has
  /// risen to R. P and Q with the value -1 count as missing (spec/linuxcnc 2.2).
  Status of_code(bool same) {
    const auto wants = [&](char letter, const char* text) {
      const bool there = m_.has(letter) && !((letter == 'P' || letter == 'Q') && m_.value(letter) == -1);
      if (same || there || hole_.fault_above) return;
      at_hole(AlarmId::rs274_cycle, text);
      hole_.fault_above = true;
    };
    if (hole_.code == 83_g || hole_.code == 73_g) {
      wants('Q', hole_.code == 83_g ? "Q word missing with g83" : "Q word missing with g73");
      if (!(hole_.peck > 0)) at_hole(AlarmId::rs274_cycle, "Negative or zero q value used");
      else if ((hole_.level - hole_.bottom) / hole_.peck > max_pecks) return fail(alarm(AlarmId::cycle_peck, m_.where('Q'), hole_.peck));
    }
    if (hole_.code == 82_g) wants('P', "Dwell time p word missing with g82");
    if (hole_.code == 86_g) wants('P', "Dwell time p word missing with g86");
    if (hole_.code == 88_g) wants('P', "Dwell time p word missing with g88");
    if (hole_.code == 89_g) wants('P', "Dwell time p word missing with g89");
    if (hole_.code != 87_g) return {};
    wants('I', "I word missing with g87");
    wants('J', "J word missing with g87");
    wants('K', "K word missing with g87");
    return {};
  }

  Status holes() {
    AxisMask named = 0;
    Axes to;
    KADR_TRY(m_.target(to, named));
    hole_.at_first = to[hole_.first];
    hole_.at_second = to[hole_.second];
    if (!m_.modal.absolute) {  // in G91 each repetition, also the first one, advances by the axis words
      hole_.step_first = to[hole_.first] - m_.position.programmed[hole_.first];
      hole_.step_second = to[hole_.second] - m_.position.programmed[hole_.second];
      hole_.at_first = m_.position.programmed[hole_.first];
      hole_.at_second = m_.position.programmed[hole_.second];
    }
    if (control_.state.polar_step) {
      hole_.polar = true;
      hole_.polar_radius = control_.state.polar_radius;
      hole_.polar_angle = control_.state.polar_angle;
      hole_.step_first = hole_.step_second = 0;
    }
    if (!m_.has('L')) return {};
    const double repeats = std::round(m_.value('L'));
    if (repeats > max_repeats) return fail(alarm(AlarmId::cycle_repeats, m_.where('L'), repeats));
    hole_.repeats = static_cast<std::uint32_t>(repeats);
    for (const double last : {hole_.at_first + repeats * hole_.step_first, hole_.at_second + repeats * hole_.step_second})
      if (!(std::fabs(last) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, call_.where, "X", last));
    return {};
  }

  void warn_turned() const {
    if ((hole_.code == 84_g || hole_.code == 74_g) && hole_.plane != Plane::xy)
      m_.warn(warning(AlarmId::tapping_axes_turned, call_.where, call_.row->code));
  }

  Emitter& m_;
  const kadr::Call& call_;
  LinuxCnc& control_;
  Hole hole_;
  bool of_uvw_ = false;  // the plane in force is that of G17.1, G18.1 or G19.1
};

}  // namespace

Status canned_cycle(Emitter& m, const kadr::Call& call) { return Reader(m, call).run(); }

}  // namespace kadr::linuxcnc

namespace kadr::functions {

Status canned_cycle(Emitter& m, const Call& call) { return linuxcnc::canned_cycle(m, call); }

}  // namespace kadr::functions
