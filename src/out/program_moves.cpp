// A program read back: its motions in work coordinates. Tables, zeros and correctors are empty, as the program was written for.

#include <cmath>

#include "base/tolerance.h"
#include "config/setup.h"
#include "control/control.h"
#include "out/part_program.h"

namespace kadr {
namespace {

using area::Move;
using area::MoveKind;

constexpr double bulge_off = 0.1;  // rounded ends and centres turn an arc by that much at most: it is at least ten increments long

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
      if (const auto* const motion = std::get_if<Motion>(&action.what))
        moves.push_back({motion->kind == MotionKind::rapid ? MoveKind::rapid : MoveKind::feed,
                         {motion->to[0], motion->to[1], motion->to[2]},
                         bulge_of(*motion)});
    if (state == Control::State::stopped) return fail(control.report().alarm);
    if (state != Control::State::running) break;
  }
  if (!moves.empty()) moves.erase(moves.begin());  // straight up, wherever the tool stood
  return moves;
}

Status same_moves(const std::vector<Move>& written, const std::vector<Move>& read) {
  const auto differs = [](const Move& a, const Move& b) {
    return (a.kind == MoveKind::rapid) != (b.kind == MoveKind::rapid) || length(a.to - b.to) > tol::same_point * 10 ||
           std::abs(a.bulge - b.bulge) > bulge_off;
  };
  const std::size_t count = std::min(written.size(), read.size());
  for (std::size_t i = 0; i < count; ++i)
    if (differs(written[i], read[i])) return fail(alarm(AlarmId::mill_read_back, {}, written[i].to.x, written[i].to.y));
  if (written.size() == read.size()) return {};
  const Vec3 at = written.empty() ? Vec3{} : written[std::min(count, written.size() - 1)].to;
  return fail(alarm(AlarmId::mill_read_back, {}, at.x, at.y));
}

}  // namespace kadr
