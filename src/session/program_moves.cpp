// Executes a program and returns its motions in work coordinates. This file is used by cli/mill.

#include "session/program_moves.h"

#include <cmath>

#include "action/by_kind.h"
#include "config/setup/setup.h"
#include "control/control.h"

namespace kadr {
namespace {

using area::Move;
using area::MoveKind;

double bulge_of(const Motion& motion) {
  if (motion.kind != MotionKind::arc_cw && motion.kind != MotionKind::arc_ccw) return 0;
  const double quarter = std::tan(motion.turns * 360 / 4 * rad_per_deg);
  return motion.kind == MotionKind::arc_ccw ? quarter : -quarter;
}

}  // namespace

Result<std::vector<Move>> program_moves(const ControlDef& def, const std::string& program) {
  const Setup setup;
  Control control(def, setup, {"", text_source(program), Encoding::utf8}, {});
  std::vector<Move> moves;
  ActionBatch batch;
  for (;;) {
    const Control::State state = control.run(batch);
    for (const Action& action : batch)
      if (const auto* const motion = motion_of(action))
        moves.push_back({motion->kind == MotionKind::rapid ? MoveKind::rapid : MoveKind::feed,
                         {motion->to[0], motion->to[1], motion->to[2]},
                         bulge_of(*motion)});
    if (state == Control::State::stopped) return fail(control.report().alarm);
    if (state != Control::State::running) break;
  }
  // The first motion goes straight up from an unknown position, so it is removed from the result.
  if (!moves.empty()) moves.erase(moves.begin());
  return moves;
}

}  // namespace kadr
