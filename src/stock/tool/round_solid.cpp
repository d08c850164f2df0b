// Computes the distance of a point from a solid of revolution. Used by stock/surface for the normals of the cut surface, and by tests.

#include "stock/tool/round_solid.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

/// Returns the distance of a point from a flat face or a cone. In the half plane of radius and height, the face is the straight line
/// through a given point with the given outward normal.
Away beyond(double radius, double height, double at_radius, double at_height, double normal_radial, double normal_axial) {
  return {(radius - at_radius) * normal_radial + (height - at_height) * normal_axial, normal_radial, normal_axial};
}

/// Returns the distance in mm of a point from the circle of radius `r` about (x, y); negative inside the circle.
Away within_circle(double radius, double height, double x, double y, double r) {
  const double dx = radius - x, dy = height - y, d = std::hypot(dx, dy);
  if (d < 1e-12) return {-r, 0, -1};
  return {d - r, dx / d, dy / d};
}

const Away& farther(const Away& a, const Away& b) { return b.distance > a.distance ? b : a; }

/// Returns the distance of a point from a rounded end: a ball, or a torus with the flat face at its end.
Away of_end(const RoundSolid& s, double radius, double height) {
  const double flat = s.form == RoundSolid::Form::ball ? 0 : s.bottom_radius;
  if (radius <= flat) return beyond(radius, height, 0, s.bottom, 0, -1);
  if (height >= s.top) return beyond(radius, height, s.top_radius, 0, 1, 0);
  return within_circle(radius, height, flat, s.top, s.top_radius - flat);
}

}  // namespace

Away away_from(const RoundSolid& s, double radius, double height) {
  const Away above = beyond(radius, height, 0, s.top, 0, 1);
  if (s.form == RoundSolid::Form::ball || s.form == RoundSolid::Form::torus) return farther(of_end(s, radius, height), above);
  const Away below = beyond(radius, height, 0, s.bottom, 0, -1);
  Away side = beyond(radius, height, s.top_radius, 0, 1, 0);
  if (s.form == RoundSolid::Form::cone) {
    const double widens = s.top_radius - s.bottom_radius, tall = s.top - s.bottom, slant = std::hypot(widens, tall);
    side = beyond(radius, height, s.bottom_radius, s.bottom, tall / slant, -widens / slant);
  }
  return farther(farther(side, below), above);
}

double ConvexBody::bottom() const {
  double least = solids.front().bottom;
  for (const RoundSolid& s : solids) least = std::min(least, s.bottom);
  return least;
}

double ConvexBody::top() const {
  double most = solids.front().top;
  for (const RoundSolid& s : solids) most = std::max(most, s.top);
  return most;
}

double ConvexBody::widest() const {
  double most = 0;
  for (const RoundSolid& s : solids) most = std::max(most, s.widest());
  return most;
}

}  // namespace kadr
