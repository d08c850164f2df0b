// LatheWatch: finds what endangers a lathe, in its spindle speeds and near its chuck. It is used by session/checklist and tested by
// tests/checklist.py.

#include "session/checklist/lathe_watch.h"

#include <algorithm>
#include <cmath>

#include "action/by_kind.h"

namespace kadr {

SpindleTurning& LatheWatch::spindle(std::size_t number) {
  if (number >= spindles_.size()) spindles_.resize(number + 1);
  return spindles_[number];
}

/// The lead of a thread is the travel per revolution of the axis with the longest travel (nct 4.4), so that axis moves at lead times
/// spindle speed. Under constant surface speed the higher speed of both ends counts.
void LatheWatch::take_thread(const Step& step, const Motion& motion, Advices& to) {
  if (!motion.detail || !motion.detail->lead) return;
  std::size_t longest = 0;
  const auto travel = [&](std::size_t axis) { return std::fabs(motion.to[axis] - step.from.work[axis]); };
  for (std::size_t axis = 1; axis < step.roles.count; ++axis)
    if (travel(axis) > travel(longest)) longest = axis;
  const SpindleTurning& turning = spindle(motion.spindle);
  const double rate = *motion.detail->lead * std::max(turning.at(step.from.work), turning.at(motion.to));
  if (rapid_[longest] > 0 && rate > rapid_[longest]) to.add(AlarmId::thread_beyond_rapid, step.action.origin, 0, rate, rapid_[longest]);
}

void LatheWatch::take_motion(const Step& step, const Motion& motion, Advices& to) {
  if (motion.kind == MotionKind::thread) take_thread(step, motion, to);
  const SpindleTurning& turning = spindle(motion.spindle);
  const SurfaceSpeed& surface = turning.surface;
  const bool lathe = step.roles.xyz[1] < 0 || motion.diameters != 0;
  if (lathe && is_cut(motion) && turning.on && surface.on && !(surface.most < SurfaceSpeed::no_limit) && !unlimited_reported_) {
    unlimited_reported_ = true;
    to.add(AlarmId::surface_speed_unlimited, step.action.origin, 0, surface.metres);
  }
  if (!chuck_face_ || motion.end_reference != EndReference::by_work || motion.kind == MotionKind::home) return;
  const double z = Ends(step.roles, step.from, motion).to.z;
  if (z < *chuck_face_ - Ends::least_travel) to.add(AlarmId::beyond_chuck_face, step.action.origin, 'Z', z, *chuck_face_);
}

void LatheWatch::take(const Step& step, Advices& to) {
  by_kind(
      step.action, [&](const Motion& motion) { take_motion(step, motion, to); },
      [&](const Spindle& command) { spindle(command.number).take(command); },
      [&](const Speed& speed) { spindle(speed.number).take(speed); }, [&](const SurfaceSpeed& law) { spindle(law.number).surface = law; },
      ignores<Dwell, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Message, FrameChange, Sync,
              ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>);
}

}  // namespace kadr
