#pragma once
// The steps of a cycle, and their execution (spec/heidenhain 12). Only src/control/heidenhain includes this file.

#include <utility>
#include <vector>

#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {

struct CycleStep {
  enum class Kind : std::uint8_t { rapid, feed, arc, dwell, spindle, coolant };
  Kind kind = Kind::rapid;
  Axes to{};
  AxisMask named = 0;
  double value = 0;  // feed in mm/min, 0: the feed in force; seconds; rev/min, 0: the speed in force; number of an M function
  Vec2 centre;       // arc: counter-clockwise unless `clockwise`
  double turns = 0;
  bool clockwise = false;
  bool taps = false;
  SpindleDir dir = SpindleDir::stop;
  double angle = 0;
};

/// A cycle as its steps.
class CycleSteps final : public SteppedCycleValue<CycleSteps> {
 public:
  explicit CycleSteps(std::vector<CycleStep> steps) : steps_(std::move(steps)) {}

  Result<bool> next(Emitter& m) override {
    for (std::size_t i = 0; i < at_a_time && at_ < steps_.size(); ++i) KADR_TRY(execute(m, steps_[at_++]));
    return at_ < steps_.size();
  }

 private:
  static constexpr std::size_t at_a_time = 8;

  static Status execute(Emitter& m, const CycleStep& step);

  std::vector<CycleStep> steps_;
  std::size_t at_ = 0;
};

/// Works out the steps of one call of the cycle in force.
class CycleMaker {
 public:
  CycleMaker(BlockContext& m, const Heidenhain& own, Span where);

  /// Adds the steps of the cycle at a point of the plane.
  Status at_point();
  /// Moves to a point of the plane, and adds the steps of the cycle there.
  Status at_point(Vec2 point, bool straight_at_clearance);
  Status polar_pattern();
  Status cartesian_pattern();
  Status points(const std::vector<Axes>& all);
  /// Sets the shift of the surface: Z of CYCL CALL POS or of a point of a pattern (spec/heidenhain 12.1).
  void raise_surface(double by) { raised_ = by; }

  std::vector<CycleStep> steps;

 private:
  double q(std::size_t index) const { return own_.memory.q[index]; }
  double length(std::size_t index) const { return q(index) * unit_; }
  /// Returns a feed in mm/min; rapid is below 0 (MAX).
  double feed_of(std::size_t index) const { return q(index) * unit_; }
  double old(std::size_t index) const { return own_.memory.old[index]; }

  void rapid(double to);
  void feed(double to, double value);
  void out(double to, double value, double fallback);
  void in_plane(Vec2 to);
  void dwell(double seconds);
  void spindle(SpindleDir dir, double angle = 0);
  void tap(double to, double pitch);
  void single_lip();
  Status depth_allowed() const;
  void levels(double surface, double clearance, double depth);
  void leave();
  void drop_last_retract();

  void drill();
  void universal();
  void peck();
  void bore();
  void mill_bore();
  void old_peck();

  BlockContext& m_;
  const Heidenhain& own_;
  Span where_;
  double unit_, raised_ = 0;
  PlaneAxes plane_;
  Vec2 at_;
  double surface_ = 0, clearance_ = 0, second_ = 0, bottom_ = 0;  // Q203, Z1, Z2, the depth
};

}  // namespace kadr::heidenhain
