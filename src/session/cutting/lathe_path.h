#pragma once
// LathePath: the path of a turning tool in the half plane of the part, step by step. It is used by session/cutting/turned_cutting and
// session/cutting/turning/cut_survey.
//
// The axis of the part is at X0 Y0 of the work coordinates. A tool with Y at 0 turns in X, a tool with X at 0 in Y (NCT in G19). Z of all
// work systems is related by their origins on the machine. Exception: where G50 or G52 has also shifted X, the program has stated where the
// tip is; there Z counts as it is programmed.

#include <memory>
#include <optional>
#include <vector>

#include "action/step.h"

namespace kadr {

/// The path of a motion: corners in the half plane. x is the signed radius; y is Z in the work coordinates of the motion, mm.
struct LatheMotion {
  std::vector<Vec2> corners;  // empty: the tool does not move in the half plane
  std::vector<double> parts;  // for each corner: the fraction (0 to 1) of the motion
  double origin = 0;          // machine Z of the zero of these work coordinates, mm
  bool off_plane = false;     // the motion turns the part or leaves the planes of X and Z, of Y and Z (C, polar interpolation)
};

class LathePath {
 public:
  /// `chord`: greatest deviation of a chord from an arc, mm. `apart`: rapid rates of the axes, if each axis of a rapid moves at its own
  /// rate (DogLeg); nullopt: rapids are straight lines.
  LathePath(const AxisRoles& roles, double chord, const std::optional<Axes>& apart) : roles_(roles), chord_(chord), apart_(apart) {}

  /// Processes the step. Returns the path of its motion; nullopt if the step is not a motion.
  std::optional<LatheMotion> take(const Step& step);

 private:
  double origin() const;
  Vec2 place_of(const Axes& work, int radius) const;
  std::optional<int> radius_of(const Step& step) const;
  bool turns_part(const Step& step) const;
  void add_rapid(const Step& step, int radius, LatheMotion& motion) const;

  AxisRoles roles_;
  double chord_;
  std::optional<Axes> apart_;
  Placement placement_;
  std::shared_ptr<const Axes> shifted_;
};

}  // namespace kadr
