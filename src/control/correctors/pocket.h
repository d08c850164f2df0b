#pragma once
// The rectangular pocket of G87, G79 (spec/correctors 3). A round is one closed path of the tool centre around the pocket. The rounds
// follow each other from the middle outwards, and are repeated at each depth (pass).
//
//   rapid to the clearance over the face ─▶ feed down by one pass ─▶ rounds, the last along the wall ─▶ back to the middle ─▶ next pass …

#include <array>
#include <cstddef>

#include "base/result.h"
#include "base/vec.h"
#include "control/correctors/correctors.h"
#include "control/emitter.h"

namespace kadr::correctors {

/// A round of the tool centre, in mm: half its length along X, half its length along Y, and its corner radius.
struct PocketRound {
  double x = 0, y = 0, corner = 0;
};

/// A segment of a round: a line to `to`, or an arc around `center`. Coordinates in mm from the middle of the pocket.
struct PocketPiece {
  Vec2 to;
  Vec2 center;
  bool is_arc = false;
};

/// The rounds (closed paths) of one pass, from the middle outwards. They are parallel to the wall, at distances of `step` mm. The last
/// round is the wall, offset by the tool radius.
class PocketRounds {
 public:
  /// Computes the rounds of a pocket. `radius`: tool radius, mm.
  ///   alarms  pocket_tool_large; pocket_corner: the pocket's corner radius is smaller than the tool radius, or larger than half the pocket
  ///   law     no point of the pocket is further than `radius` from a round or the middle
  static Result<PocketRounds> of(const PocketCycle& pocket, double radius, Span where);

  double count() const { return count_; }
  PocketRound at(double index) const;

 private:
  PocketRound wall_;
  double step_ = 0;
  double count_ = 0;
};

/// Divides a round into lines and arcs. The round starts at its point on the +X side; `direction` is +1 for counter-clockwise, -1 for
/// clockwise. Some of the segments may have length zero.
std::array<PocketPiece, 9> pieces_of(const PocketRound& round, double direction);

/// Executes G79 one round (closed path) at a time, so that a pocket of any size needs constant memory.
class PocketRun final : public SteppedCycleValue<PocketRun> {
 public:
  /// `middle`: middle of the pocket in programmed coordinates, mm; its Z is the face of the pocket.
  PocketRun(const PocketCycle& pocket, const PocketRounds& rounds, const Axes& middle)
      : pocket_(pocket), rounds_(rounds), middle_(middle) {}

  /// Returns the number of passes, which are the depths of the pocket; no pass is deeper than K.
  static double passes(const PocketCycle& pocket);
  Result<bool> next(Emitter& m) override;

 private:
  Status approach(Emitter& m) const;
  Status move(Emitter& m, MotionKind kind, Vec2 at, double z, AxisMask named) const;
  Status round(Emitter& m, const PocketRound& round) const;
  double floor_of(double pass) const;
  double clear() const { return middle_[2] + pocket_.clearance; }

  const PocketCycle pocket_;
  const PocketRounds rounds_;
  const Axes middle_;
  bool began_ = false;
  double pass_ = 0, round_ = 0;
};

}  // namespace kadr::correctors
