// G76: a thread that is cut in several passes (spec/linuxcnc 7.2; convert_threading_cycle of LinuxCNC's source).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/vec.h"
#include "control/emitter.h"
#include "control/functions/functions.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/motions.h"
#include "control/linuxcnc/spindles.h"

namespace kadr::linuxcnc {
namespace {

constexpr std::size_t thread_axis = 2;  // Z
constexpr double max_thread_passes = 100'000;

/// The data of a thread, in mm. Depths are measured from the drive line. It is the line along Z at the X of the cycle's start.
struct Thread {
  double x = 0, z = 0;                       // coordinates of the start point of the cycle
  double side = -1;                          // direction of the infeed along X: -1 for an outside thread, +1 for an inside thread
  double crest = 0;                          // absolute value of word I: distance of the thread crest from the drive line, mm
  double first = 0;                          // absolute value of word J: depth of the first pass below the crest, mm
  double height = 0;                         // absolute value of word K: full depth of the thread below the crest, mm
  double degression = 1;                     // word R: the depth of pass n grows with n^(1/R)
  double slope = 0;                          // word Q: tangent of the compound angle
  double pitch = 0;                          // P: pitch
  double taper = 0;                          // word E: length of the taper along Z, with the sign of the travel along Z
  double taper_pitch = 0;                    //
  bool taper_in = false, taper_out = false;  // taper_in: the thread has a taper at its start; taper_out: at its end (word L)
  int spring = 0;                            // word H: number of spring passes
  double target = 0;                         // coordinate Z at the end of the first pass
  Axes end{};                                // end point, programmed coordinates
  Span where;
};

/// Executes the passes of the thread one by one.
class Threading final : public SteppedCycleValue<Threading> {
 public:
  explicit Threading(const Thread& thread) : t_(thread) {}

  Result<bool> next(Emitter& m) override {
    const double full = t_.crest + t_.height;
    double depth = t_.crest + t_.first * (pass_ == 1 ? 1 : std::pow(pass_, 1 / t_.degression));
    if (pass_ > max_thread_passes) return fail(alarm(AlarmId::cycle_repeats, t_.where, max_thread_passes));
    if (depth < full) ++pass_;
    else if (++finished_ > t_.spring + 1) {
      KADR_TRY(m.straight(MotionKind::rapid, t_.end, 7));
      return false;
    } else {
      depth = full;
    }
    KADR_TRY(cut(m, depth, full));
    return true;
  }

 private:
  Status cut(Emitter& m, double depth, double full) const {
    const double offset = (depth - t_.crest) * t_.slope;
    const double x = t_.x + t_.side * depth, out = t_.x + t_.side * (depth - full), above = t_.x + t_.side * (depth - t_.height);
    const double begin = t_.z - offset, end = t_.target - offset;
    KADR_TRY(rapid(m, out, begin));
    if (t_.taper != 0 && t_.taper_in) {
      KADR_TRY(thread(m, above, begin, t_.taper_pitch));
      KADR_TRY(thread(m, x, begin - t_.taper, t_.taper_pitch));
    } else {
      KADR_TRY(rapid(m, x, begin));
    }
    if (t_.taper != 0 && t_.taper_out) {
      KADR_TRY(thread(m, x, end + t_.taper, t_.pitch));
      KADR_TRY(thread(m, above, end, t_.taper_pitch));
    } else {
      KADR_TRY(thread(m, x, end, t_.pitch));
    }
    return rapid(m, out, end);
  }

  static Axes point(const BlockContext& m, double x, double z) {
    Axes to = m.position.programmed;
    to[0] = x;
    to[thread_axis] = z;
    return to;
  }
  Status rapid(Emitter& m, double x, double z) const { return m.straight(MotionKind::rapid, point(m, x, z), 7); }
  Status thread(Emitter& m, double x, double z, double pitch) const { return thread_to(m, point(m, x, z), 7, pitch); }

  Thread t_;
  double pass_ = 1;
  int finished_ = 0;
};

constexpr double half_turn = 180;

Thread thread_of(const BlockContext& m, const Axes& end) {
  const double half = (m.modal.diameter & 1U) != 0 ? 0.5 : 1;
  const double i = m.length_value('I') * half, j = m.length_value('J') * half, k = m.length_value('K') * half;
  Thread t;
  t.x = m.position.programmed[0];
  t.z = m.position.programmed[thread_axis];
  t.end = end;
  t.side = i > 0 ? 1 : -1;
  t.crest = std::fabs(i);
  t.first = std::fabs(j);
  t.height = std::fabs(k);
  t.pitch = m.length_value('P');
  const double sign = end[thread_axis] > t.z ? -1 : 1;
  const double angle = m.has('Q') && m.value('Q') != -1 ? m.value('Q') : 0;  // a missing Q has the value -1, as in LinuxCNC's source
  t.slope = std::tan(sign * angle * pi / half_turn);
  t.spring = m.has('H') ? static_cast<int>(std::round(m.value('H'))) : 0;
  t.degression = m.has('R') ? std::max(1.0, m.value('R')) : 1;
  const double taper = m.has('E') ? std::max(0.0, m.length_value('E')) : 0;
  t.taper_pitch = taper > 0 ? t.pitch * std::hypot(taper, t.height) / taper : t.pitch;
  t.taper = sign * taper;
  const auto ends = m.has('L') ? static_cast<unsigned>(std::round(m.value('L'))) : 0U;
  t.taper_in = (ends & 1U) != 0;
  t.taper_out = (ends & 2U) != 0;
  t.target = end[thread_axis] + t.height * t.slope;
  return t;
}

}  // namespace
}  // namespace kadr::linuxcnc

namespace kadr::functions {

/// G76: cuts a thread. Words: P pitch, I crest, J first depth, K height, R degression, Q compound angle, H spring passes, E and L tapers.
Status threading_cycle(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc::linuxcnc_of(m);
  const auto wrong = [&](AlarmId id, const char* text) { return control.fault(id, call.where, text); };
  AxisMask named = 0;
  Axes end;
  KADR_TRY(m.target(end, named));
  KADR_TRY(linuxcnc::take_spindle(m, "Invalid D-number in G76 cycle", call.where));
  if (!linuxcnc::active_spindle_turns(m))
    return control.fault(AlarmId::rs274_spindle, call.where,
                         fmt::format("Chosen spindle ({}) not turning in G76", control.state.active_spindle));
  for (std::size_t a = 3; a < m.axis_count; ++a)
    if (end[a] != m.position.programmed[a]) return wrong(AlarmId::rs274_motion, "Cannot move rotary axes with G76");
  if (m.modal.radius_side != 0)
    return wrong(AlarmId::rs274_compensation, "Cannot use G76 threading cycle with cutter radius compensation on");
  if (m.value('I') == 0) return wrong(AlarmId::rs274_cycle, "In G76, I must not be 0");
  if (!(m.value('J') > 0)) return wrong(AlarmId::rs274_cycle, "In G76, J must be greater than 0");
  if (!(m.value('K') > m.value('J'))) return wrong(AlarmId::rs274_cycle, "In G76, K must be greater than J");
  m.modal.motion = MotionMode::none;
  m.modal.motion_row = static_cast<std::int16_t>(call.row - m.def.codes.data());
  m.running = std::make_unique<linuxcnc::Threading>(linuxcnc::thread_of(m, end));
  return {};
}

}  // namespace kadr::functions
