#pragma once
// Random tools and moves for the tests of the cut, and the distance of a point from the volume swept by a tool.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "stock/stock.h"

namespace kadr {

/// Random numbers that are the same with every library; the distributions of <random> are not.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}
  double between(double a, double b) { return a + (b - a) * double(engine_() >> 11) * 0x1p-53; }
  int below(int n) { return int(engine_() % std::uint64_t(n)); }

 private:
  std::mt19937_64 engine_;
};

/// Returns a number that can be set in the environment, or `otherwise`.
inline std::uint64_t asked(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// Returns the seed that dev/properties passes to RapidCheck.
inline std::uint64_t seed_of_properties() {
  const char* text = std::getenv("RC_PARAMS");
  const char* seed = text == nullptr ? nullptr : std::strstr(text, "seed=");
  return seed == nullptr ? 1 : std::strtoull(seed + 5, nullptr, 10);
}

enum class SomeTool { flat, ball, short_ball, bull, drill, taper, chamfer, form, tslot };
inline constexpr int some_tools = 9;
inline const char* name_of(SomeTool t) {
  constexpr const char* names[] = {"flat", "ball", "ball of short flutes", "bull", "drill", "taper", "chamfer", "form", "T-slot"};
  return names[int(t)];
}

inline ToolShape some_tool(Chance& chance, SomeTool which) {
  ToolGeometry g;
  g.diameter = chance.between(0.6, 12);
  const double radius = g.diameter / 2;
  g.flutes = chance.between(2, 12);
  g.angle = chance.between(40, 140);
  switch (which) {
    case SomeTool::flat: break;
    case SomeTool::ball: g.kind = ToolKind::ball, g.flutes = std::max(g.flutes, radius * chance.between(2.01, 3)); break;
    case SomeTool::short_ball: g.kind = ToolKind::ball, g.flutes = radius * chance.between(1, 2); break;
    case SomeTool::bull:
      g.kind = ToolKind::bull, g.corner = chance.between(0.05, 0.95) * radius, g.flutes = std::max(g.flutes, g.corner * 1.5);
      break;
    case SomeTool::drill: g.kind = ToolKind::drill; break;
    case SomeTool::taper: g.kind = ToolKind::taper, g.angle = chance.between(0.5, 40); break;
    case SomeTool::chamfer: g.kind = ToolKind::chamfer, g.tip = chance.between(0.05, 0.9) * g.diameter; break;
    case SomeTool::form: {
      g.kind = ToolKind::form;
      double height = 0;
      for (int i = chance.below(4) + 2; i > 0; --i) {
        const bool straight = !g.profile.empty() && chance.below(4) == 0;
        g.profile.push_back({straight ? g.profile.back().diameter : chance.between(0, 12), height});
        if (chance.below(5) != 0) height += chance.between(0.05, 4);
      }
      g.flutes = height;
      break;
    }
    case SomeTool::tslot:
      g.kind = ToolKind::tslot, g.flutes = chance.between(0.5, 3), g.length = g.flutes + chance.between(1, 9);
      g.shank = {{g.diameter * chance.between(0.2, 0.8), g.flutes}, {g.diameter * chance.between(0.2, 0.9), g.length}};
      break;
  }
  return shape_of(g);
}

/// Returns a move of any length and direction: along an axis, or so nearly along
/// it that few digits of single precision remain; some moves begin far outside.
inline Sweep some_move(Chance& chance) {
  const Vec3 through{chance.between(-4, 12), chance.between(-4, 12), chance.between(-8, 8)};
  const double far = chance.below(8) == 0 ? 4 : 1.3, length_ = std::pow(10, chance.between(-3, far));
  Vec3 travel{chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1)};
  travel = (length_ / length(travel)) * travel;
  switch (chance.below(11)) {
    case 1: travel.z = 0; break;
    case 2: travel.x = travel.y = 0; break;
    case 3: travel.y = travel.z = 0; break;
    case 4: travel.x = travel.z = 0; break;
    case 5: travel.z *= 1e-4; break;
    case 6: travel.x *= 1e-5, travel.y *= 1e-5; break;
    case 7: travel.y *= 1e-5, travel.z *= 1e-5; break;
    case 8: travel.x *= 1e-5, travel.z *= 1e-5; break;
    case 9: travel.x *= 0.05, travel.y *= 0.05; break;
    default: break;
  }
  const double part = far > 2 ? chance.between(0, 1) : 0;
  const Vec3 from = through - part * travel;
  return {from, from + travel, 0, false};
}

/// Returns the distance of a point from the volume swept by the tool; negative
/// inside. Each solid is convex, so its distance has one minimum along the path.
inline double from_swept(const ToolShape& tool, const Sweep& sweep, Vec3 at) {
  constexpr double golden = 0.6180339887498949;
  const Vec3 travel = sweep.to - sweep.from;
  double best = std::numeric_limits<double>::infinity();
  for (const ConvexBody& body : tool.bodies)
    for (const RoundSolid& solid : body.solids) {
      const auto away = [&](double s) {
        const Vec3 from_tip = at - (sweep.from + s * travel);
        return away_from(solid, std::hypot(from_tip.x, from_tip.y), from_tip.z).distance;
      };
      double low = 0, high = 1, a = 1 - golden, b = golden, at_a = away(a), at_b = away(b);
      best = std::min({best, away(0), away(1)});
      for (int i = 0; i < 50; ++i) {
        const bool left = at_a < at_b;
        (left ? high : low) = left ? b : a;
        (left ? b : a) = left ? a : b;
        (left ? at_b : at_a) = left ? at_a : at_b;
        const double next = left ? high - golden * (high - low) : low + golden * (high - low);
        (left ? a : b) = next;
        (left ? at_a : at_b) = away(next);
      }
      best = std::min({best, at_a, at_b});
    }
  return best;
}

}  // namespace kadr
