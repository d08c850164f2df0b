// Emits the motion of an arc that has been computed. Used by control/linuxcnc, control/grbl.

#include "control/functions/arc_motion.h"

#include "control/functions/cutter_compensation.h"

namespace kadr {

Motion& arc_motion(Emitter& m, const PlaneArc& arc, Turn turn, const Axes& end, AxisMask named, double turns) {
  named |= AxisMask{1} << m.modal.axes.first | AxisMask{1} << m.modal.axes.second;
  m.move_to(end, end, named);
  Motion& motion = m.add_motion(turn == Turn::cw ? MotionKind::arc_cw : MotionKind::arc_ccw, named);
  m.set_feed(motion);
  motion.center = arc.center;
  motion.turns = arc.turns + turns;
  note_arc_end(m, motion);
  return motion;
}

}  // namespace kadr
