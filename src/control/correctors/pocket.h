#pragma once
// The rectangular pocket of G87, G79 (spec/correctors 3): rounds of the tool's centre from the middle outwards, pass by pass.
//
//   rapid to the clearance over the face ─▶ feed down by a pass ─▶ rounds, the last along the wall ─▶ back to the middle ─▶ the next pass …

#include <array>
#include <cstddef>

#include "base/result.h"
#include "base/vec.h"
#include "control/correctors/correctors.h"
#include "control/emitter.h"

namespace kadr::correctors {

/// A round of the tool's centre: half its lengths along X and Y, radius of its corners; mm.
struct PocketRound {
  double x = 0, y = 0, corner = 0;
};

/// A line of a round, or an arc around `center`; mm from the pocket's middle.
struct PocketPiece {
  Vec2 to;
  Vec2 center;
  bool is_arc = false;
};

/// The rounds of one pass: parallels of the wall, `step` apart from the middle on; the last one is the wall moved by the tool's radius.
class PocketRounds {
 public:
  /// radius: of the tool, mm
  ///   alarms  pocket_tool_large; pocket_corner: below the radius of the tool, or above half the pocket
  ///   law     no point of the pocket is further than `radius` from a round or the middle
  static Result<PocketRounds> of(const PocketCycle& pocket, double radius, Span where);

  double count() const { return count_; }
  PocketRound at(double index) const;

 private:
  PocketRound wall_;
  double step_ = 0;
  double count_ = 0;
};

/// A round from its point on +X, counter-clockwise for direction +1, clockwise for -1; pieces of no length among them.
std::array<PocketPiece, 9> pieces_of(const PocketRound& round, double direction);

/// The cycle, a round at a time: constant memory for any pocket.
class PocketRun final : public RunningValue<PocketRun> {
 public:
  /// middle: programmed; Z the face
  PocketRun(const PocketCycle& pocket, const PocketRounds& rounds, const Axes& middle)
      : pocket_(pocket), rounds_(rounds), middle_(middle) {}

  /// Passes of no more than K.
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
