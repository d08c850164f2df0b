#pragma once
// EllipseRun: executes an arc under unequal scale factors, which is part of an ellipse (Mach3 10.7.15). The arc becomes short straight
// motions. They are emitted one at a time, so that an arc of any length needs constant memory. After the first motion no motion fails.

#include <cstdint>

#include "base/result.h"
#include "base/vec.h"

namespace kadr {

class Emitter;

class EllipseRun {
 public:
  /// The programmed arc, before scaling. `first`, `second`: indices of the two axes of the plane.
  struct Job {
    std::size_t first = 0, second = 1;
    Vec2 center;                // centre of the arc, programmed coordinates
    Axes from{}, to{};          // start and end, programmed coordinates; axes outside the plane move linearly while the arc is executed
    double sweep_deg = 0;       // swept angle, degrees; positive counter-clockwise
    double greatest_scale = 1;  // the larger of the scale factors of the two axes
    std::uint32_t named = 0;
  };

  bool active() const { return pieces_ != 0; }
  void stop() { pieces_ = 0; }

  /// Divides the arc into chords that deviate from the ellipse by at most tol::ellipse_chord.
  void start(const Job& job);

  /// Emits the next straight motion.
  Status next(Emitter& m);

 private:
  Job job_;
  std::uint32_t pieces_ = 0;
  std::uint32_t done_ = 0;
};

}  // namespace kadr
