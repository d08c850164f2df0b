#pragma once
// Random paths of tilted tools that graze a lattice line: at some moment, while the tool turns, the line touches the tool's side, a
// cone, a rounded edge or a face, and nearly lies in it.

#include <vector>

#include "stock/some_tilted.h"

namespace kadr {

inline double dot_of(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross_of(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Vec3 unit_of(Vec3 v) { return (1 / length(v)) * v; }

/// A point of a tool's surface, in the half plane of radius and height.
struct SurfacePlace {
  Vec2 at, normal;
};

inline SurfacePlace some_surface_place(const ToolShape& tool, Chance& chance) {
  std::vector<RoundSolid> all;
  for (const ConvexBody& body : tool.bodies) all.insert(all.end(), body.solids.begin(), body.solids.end());
  const RoundSolid& s = all[std::size_t(chance.below(int(all.size())))];
  const double part = chance.between(0, 1), tall = s.top - s.bottom;
  const auto edge = [&](double middle, double corner) {
    const double small = chance.below(2) == 0 ? std::pow(10, chance.between(-4, 0)) : 1;
    const double angle = (chance.below(2) == 0 ? small : 1 - 0.99 * small) * chance.between(0.5, 1) * pi / 2;
    const Vec2 normal{std::sin(angle), -std::cos(angle)};
    return SurfacePlace{{middle + corner * normal.x, s.top + corner * normal.y}, normal};
  };
  if (chance.below(8) == 0) return {{part * s.bottom_radius, s.bottom}, {0, -1}};
  if (chance.below(16) == 0) return {{part * s.top_radius, s.top}, {0, 1}};
  switch (s.form) {
    case RoundSolid::Form::cylinder: return {{s.top_radius, s.bottom + part * tall}, {1, 0}};
    case RoundSolid::Form::cone: {
      const double widens = s.top_radius - s.bottom_radius, size = std::hypot(tall, widens);
      return {{s.bottom_radius + part * widens, s.bottom + part * tall}, {tall / size, -widens / size}};
    }
    case RoundSolid::Form::ball: return edge(0, tall);
    default: return edge(s.bottom_radius, tall);
  }
}

/// A sweep, and the position of the line along the axis `family` that it grazes.
struct Grazing {
  Sweep sweep;
  int family;
  Vec3 at;
};

/// Returns zero or a size from 10^`least` to 10^`greatest` with a random sign; mostly small.
inline double some_size(Chance& chance, double least, double greatest) {
  const double size = chance.below(6) == 0 ? 0 : std::pow(10, chance.between(least, greatest));
  return chance.below(2) == 0 ? size : -size;
}

inline Grazing some_grazing(const ToolShape& tool, Vec3 at, int family, Chance& chance) {
  const SurfacePlace s = some_surface_place(tool, chance);
  // In the tool's own axes: the line, nearly along the outline; the normal of the surface; and the direction normal to both.
  const double off = some_size(chance, -4, 0), aside = std::sin(off), forth = std::cos(off);
  const Vec3 e{-forth * s.normal.y, aside, forth * s.normal.x}, n{s.normal.x, 0, s.normal.y}, c = cross_of(e, n);
  // The same three directions in the axes of the material.
  Vec3 line;
  along(line, family) = 1;
  Vec3 any{chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1)};
  any = any - dot_of(any, line) * line;
  const Vec3 upright = unit_of(any), sideways = cross_of(line, upright);
  const auto seen = [&](Vec3 v) { return dot_of(v, e) * line + dot_of(v, n) * upright + dot_of(v, c) * sideways; };
  const Vec3 axis = seen({0, 0, 1}), touched = seen({s.at.x, 0, s.at.y});
  const Vec3 tip = at - some_size(chance, -5, -1.5) * upright - touched;
  // The tool turns about an axis at right angles to its own, mostly so that the surface turns across the line.
  Vec3 about = sideways + (chance.below(2) == 0 ? 1.0 : 0.01) * Vec3{chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1)};
  about = about - dot_of(about, axis) * axis;
  const double turn = std::pow(10, chance.between(-3.5, -0.3));
  about = length(about) < 1e-3 ? Vec3{} : turn * unit_of(about);
  // The touched point of the tool moves along the surface.
  const Vec3 travel = some_size(chance, -4, 0.7) * line + some_size(chance, -4, 0.7) * sideways + some_size(chance, -5, -1) * upright -
                      cross_of(about, touched);
  const double moment = chance.below(4) == 0 ? chance.between(0, 1) : 0.5 + some_size(chance, -4, -0.4);
  const auto turned = [&](double by) {
    const Vec3 aside_of = cross_of(about, axis);
    return length(about) == 0 ? axis : unit_of(std::cos(by * turn) * axis + (std::sin(by * turn) / turn) * aside_of);
  };
  return {{tip - moment * travel, tip + (1 - moment) * travel, 0, false, turned(-moment), turned(1 - moment)}, family, at};
}

}  // namespace kadr
