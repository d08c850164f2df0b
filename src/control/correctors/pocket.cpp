// The rectangular pocket of G87, G79 (spec/correctors 3). The tool centre moves along closed paths, called rounds, from the middle
// outwards, at each depth. Used by control/correctors/correctors; tested by tests/control/correctors/pocket_test.cpp.

#include "control/correctors/pocket.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"

namespace kadr::correctors {
namespace {

constexpr AxisMask in_plane = 3u, along_tool = 4u;

/// Returns how many steps of size `size` are needed to cover the length `whole`. A remainder below the numerical tolerance needs no further
/// step.
double steps(double whole, double size) { return std::ceil(whole / size - tol::whole_number); }

}  // namespace

Result<PocketRounds> PocketRounds::of(const PocketCycle& pocket, double radius, Span where) {
  constexpr double percent = 100;
  const double shorter = std::min(pocket.x, pocket.y) / 2;
  if (radius > shorter + tol::same_point) return fail(alarm(AlarmId::pocket_tool_large, where, 2 * radius, pocket.x, pocket.y));
  if (pocket.corner < radius - tol::same_point || pocket.corner > shorter + tol::same_point)
    return fail(alarm(AlarmId::pocket_corner, where, pocket.corner, radius, shorter));
  PocketRounds rounds;
  rounds.wall_ = {std::max(pocket.x / 2 - radius, 0.0), std::max(pocket.y / 2 - radius, 0.0), std::max(pocket.corner - radius, 0.0)};
  rounds.step_ = pocket.stepover / percent * 2 * radius;
  rounds.count_ = std::max(steps(std::min(rounds.wall_.x, rounds.wall_.y), rounds.step_), 1.0);
  return rounds;
}

PocketRound PocketRounds::at(double index) const {
  if (index + 1 >= count_) return wall_;
  // distance in mm between this round and the last round, which runs along the wall
  const double inside = std::min(wall_.x, wall_.y) - (index + 1) * step_;
  return {wall_.x - inside, wall_.y - inside, std::max(wall_.corner - inside, 0.0)};
}

std::array<PocketPiece, 9> pieces_of(const PocketRound& round, double direction) {
  const double x = round.x, y = direction * round.y, r = round.corner, s = direction * r;
  return {{{{x, y - s}, {}, false},
           {{x - r, y}, {x - r, y - s}, true},
           {{-x + r, y}, {}, false},
           {{-x, y - s}, {-x + r, y - s}, true},
           {{-x, -y + s}, {}, false},
           {{-x + r, -y}, {-x + r, -y + s}, true},
           {{x - r, -y}, {}, false},
           {{x, -y + s}, {x - r, -y + s}, true},
           {{x, 0}, {}, false}}};
}

double PocketRun::passes(const PocketCycle& pocket) { return steps(-pocket.z, pocket.pass); }

double PocketRun::floor_of(double pass) const { return middle_[2] - std::min((pass + 1) * pocket_.pass, -pocket_.z); }

Status PocketRun::move(Emitter& m, MotionKind kind, Vec2 at, double z, AxisMask named) const {
  Axes to = m.position.programmed;
  to[0] = middle_[0] + at.x;
  to[1] = middle_[1] + at.y;
  to[2] = z;
  return m.straight(kind, to, named);
}

/// Moves to a point above the middle of the pocket, at the tool's present height, or at the clearance level if the tool is lower
/// (INFERRED).
Status PocketRun::approach(Emitter& m) const {
  const double z = std::max(m.position.programmed[2], clear());
  if (z > m.position.programmed[2]) {
    Axes up = m.position.programmed;
    up[2] = z;
    KADR_TRY(m.straight(MotionKind::rapid, up, along_tool));
  }
  KADR_TRY(move(m, MotionKind::rapid, {}, z, in_plane));
  return move(m, MotionKind::rapid, {}, clear(), along_tool);
}

Status PocketRun::round(Emitter& m, const PocketRound& round) const {
  const double z = m.position.programmed[2];
  KADR_TRY(move(m, MotionKind::feed, {round.x, 0}, z, in_plane));
  for (const PocketPiece& piece : pieces_of(round, pocket_.direction)) {
    const Vec2 here = {m.position.programmed[0] - middle_[0], m.position.programmed[1] - middle_[1]};
    if (length(piece.to - here) <= tol::same_point) continue;
    KADR_TRY(move(m, MotionKind::feed, piece.to, z, in_plane));
    if (!piece.is_arc) continue;
    Axes center = m.position.programmed;
    center[0] = middle_[0] + piece.center.x;
    center[1] = middle_[1] + piece.center.y;
    center = m.transform.to_work(center);
    auto& motion = std::get<Motion>(m.batch->back().what);
    motion.kind = (pocket_.direction < 0) != m.transform.reverses(m.modal.axes) ? MotionKind::arc_cw : MotionKind::arc_ccw;
    motion.center = {center[0], center[1]};
    motion.turns = 0.25;  // each corner is a quarter of a revolution
  }
  return {};
}

Result<bool> PocketRun::next(Emitter& m) {
  const auto done = [](const Status& status, bool more) -> Result<bool> {
    if (!status) return fail(status.error());
    return more;
  };
  if (!began_) {
    began_ = true;
    return done(approach(m), true);
  }
  if (pass_ >= passes(pocket_)) return done(move(m, MotionKind::rapid, {}, clear(), along_tool), false);
  if (round_ == 0) KADR_TRY(move(m, MotionKind::feed, {}, floor_of(pass_), along_tool));
  KADR_TRY(round(m, rounds_.at(round_)));
  if (++round_ < rounds_.count()) return true;
  round_ = 0;
  ++pass_;
  return done(move(m, MotionKind::feed, {}, m.position.programmed[2], in_plane), true);
}

}  // namespace kadr::correctors
