#pragma once
// The distance of a point from the volume swept by a tilted tool, computed slowly and obviously: the distance from the tool at many
// moments, with the minimum refined between neighbouring moments.

#include <array>
#include <cstdio>

#include "stock/line_positions.h"
#include "stock/some_grazing.h"
#include "stock/some_tools.h"

namespace kadr {

inline Vec3 direction_between(Vec3 a, Vec3 b, double part) {
  const double size = std::min(length(b - a) / 2, 1.0), angle = 2 * std::asin(size);
  if (angle < 1e-9) return a;
  return (std::sin((1 - part) * angle) / std::sin(angle)) * a + (std::sin(part * angle) / std::sin(angle)) * b;
}

inline double from_tilted(const ToolShape& tool, const Sweep& sweep, Vec3 at) {
  double best = std::numeric_limits<double>::infinity();
  const double size = length(sweep.to - sweep.from) + 20 * length(sweep.to_direction - sweep.from_direction);
  const int poses = std::clamp(int(size * 8), 24, 60);
  for (const ConvexBody& body : tool.bodies)
    for (const RoundSolid& solid : body.solids) {
      const auto away = [&](double part) {
        const Vec3 q = at - (sweep.from + part * (sweep.to - sweep.from)),
                   k = direction_between(sweep.from_direction, sweep.to_direction, part);
        const double height = dot_of(q, k);
        return away_from(solid, length(q - height * k), height).distance;
      };
      std::array<double, 61> at_pose{};
      for (int i = 0; i <= poses; ++i) at_pose[std::size_t(i)] = away(double(i) / poses), best = std::min(best, at_pose[std::size_t(i)]);
      for (int i = 0; i <= poses; ++i) {
        const std::size_t p = std::size_t(i);
        if ((i > 0 && at_pose[p - 1] < at_pose[p]) || (i < poses && at_pose[p + 1] < at_pose[p])) continue;
        constexpr double golden = 0.6180339887498949;
        double low = std::max(i - 1.0, 0.0) / poses, high = std::min(i + 1.0, double(poses)) / poses;
        double a = high - golden * (high - low), b = low + golden * (high - low), at_a = away(a), at_b = away(b);
        for (int step = 0; step < 32; ++step) {
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
    }
  return best;
}

inline std::string described(const ToolShape& tool, const std::vector<Sweep>& sweeps, const LinePosition& p) {
  char text[600];
  std::snprintf(text, sizeof text, "family %d place (%.9g %.9g %.9g)%s", p.family, p.at.x, p.at.y, p.at.z, p.is_end ? ", an end" : "");
  std::string all = text;
  for (const ConvexBody& body : tool.bodies)
    for (const RoundSolid& r : body.solids) {
      std::snprintf(text, sizeof text, "\n  form %d from %.9g to %.9g radius %.9g to %.9g", int(r.form), r.bottom, r.top, r.bottom_radius,
                    r.top_radius);
      all += text;
    }
  for (const Sweep& s : sweeps) {
    std::snprintf(text, sizeof text, "\n  from (%.9g %.9g %.9g) way (%.9g %.9g %.9g) direction (%.9g %.9g %.9g) turn %.4g", s.from.x,
                  s.from.y, s.from.z, s.to.x - s.from.x, s.to.y - s.from.y, s.to.z - s.from.z, s.from_direction.x, s.from_direction.y,
                  s.from_direction.z, length(s.to_direction - s.from_direction));
    all += text;
  }
  return all;
}

}  // namespace kadr
