#pragma once
// Generates random paths of lines, arcs and helices in the three planes, and writes them as Mach3 programs.

#include <cstdio>

#include "choices.h"
#include "control/state/control_state.h"

namespace kadr::test {

/// One motion to `to`; arcs are about `center`; both in mm.
struct Piece {
  MotionKind kind = MotionKind::rapid;
  Plane plane = Plane::xy;
  Axes to{};
  Axes center{};
  bool by_radius = false;
  bool long_arc = false;
  double radius = 0;
};
using Path = std::vector<Piece>;

inline std::size_t first_axis(Plane plane) { return axes_of(plane).first; }
inline std::size_t second_axis(Plane plane) { return axes_of(plane).second; }

/// Returns an arc or helix from `from` with a random centre and sweep. The sweep avoids half and whole circles, where R is not usable.
inline Piece random_arc(Choices& choose, const Axes& from, Plane plane) {
  Piece p;
  p.plane = plane;
  p.kind = choose.below(2) == 0 ? MotionKind::arc_ccw : MotionKind::arc_cw;
  const std::size_t a = first_axis(plane), b = second_axis(plane), n = axes_of(plane).normal;
  const double quarters = 90.0 * choose.between(1, 4);
  const double sweep = choose.below(2) == 0 ? quarters : choose.between(5, 355);
  const Vec2 arm{choose.between(-30'000, 30'000) / 1000.0, choose.between(1'000, 30'000) / 1000.0};
  const Vec2 center = Vec2{from[a], from[b]} + arm;
  const Vec2 end = sweep == 360 ? Vec2{from[a], from[b]} : center + rotated(-1.0 * arm, p.kind == MotionKind::arc_ccw ? sweep : -sweep);
  p.to = p.center = from;
  p.center[a] = center.x, p.center[b] = center.y;
  p.to[a] = end.x, p.to[b] = end.y;
  if (choose.one_in(3)) p.to[n] += choose.between(-10'000, 10'000) / 1000.0;
  p.radius = length(arm);
  p.long_arc = sweep > 180;
  p.by_radius = choose.one_in(3) && sweep < 350 && std::fabs(sweep - 180) > 1;
  return p;
}

/// `planes` is 1 for XY only, 3 for all.
inline Path random_path(Choices& choose, std::size_t planes) {
  static constexpr Plane all[] = {Plane::xy, Plane::zx, Plane::yz};
  Path path;
  Axes at{};
  for (std::size_t count = 1 + choose.below(10); count > 0; --count) {
    Piece p;
    const std::size_t kind = choose.below(4);
    if (kind >= 2) {
      p = random_arc(choose, at, all[choose.below(planes)]);
    } else {
      p.kind = kind == 0 ? MotionKind::feed : MotionKind::rapid;
      for (std::size_t a = 0; a < 3; ++a) p.to[a] = choose.between(-100'000, 100'000) / 1000.0;
    }
    path.push_back(p);
    at = p.to;
  }
  return path;
}

enum class Dimensions { absolute, incremental, mixed };

/// How a path is written as a program.
struct Writing {
  Dimensions dimensions = Dimensions::absolute;
  double unit = 1;           // mm; 25.4 for inches
  int digits = 12;           // decimals
  bool radius_words = true;  // writes R for the arcs of the path that request it
};

class Writer {
 public:
  Writer(Writing how, Choices* mix = nullptr) : how_(how), mix_(mix) {}

  std::string blocks(const Path& path) {
    std::string text;
    for (const Piece& p : path) text += block(p);
    return text;
  }

  std::string block(const Piece& p) {
    static constexpr const char* codes[] = {"G0", "G1", "G2", "G3"};
    const bool incremental = how_.dimensions == Dimensions::incremental || (how_.dimensions == Dimensions::mixed && mix_->below(2) == 1);
    std::string text = incremental ? "G91 " : "G90 ";
    text += p.plane == Plane::xy ? "G17 " : p.plane == Plane::zx ? "G18 " : "G19 ";
    text += codes[static_cast<std::size_t>(p.kind)];
    for (std::size_t a = 0; a < 3; ++a) text += word("XYZ"[a], p.to[a] - (incremental ? at_[a] : 0));
    if (p.kind == MotionKind::arc_cw || p.kind == MotionKind::arc_ccw) {
      if (p.by_radius && how_.radius_words) {
        text += word('R', p.long_arc ? -p.radius : p.radius);
      } else {
        for (const std::size_t a : {first_axis(p.plane), second_axis(p.plane)}) text += word("IJK"[a], p.center[a] - at_[a]);
      }
    }
    at_ = p.to;
    return text + "\n";
  }

 private:
  std::string word(char letter, double mm) const {
    char text[64];
    std::snprintf(text, sizeof text, " %c%.*f", letter, how_.digits, mm / how_.unit);
    return text;
  }
  Writing how_;
  Choices* mix_;
  Axes at_{};
};

inline std::string written(const Path& path, Writing how = {}, Choices* mix = nullptr) { return Writer(how, mix).blocks(path); }

}  // namespace kadr::test
