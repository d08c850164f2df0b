#pragma once
// [[bodies]] of machines/*.toml: the solid bodies of a machine, each on the bed or on an axis that moves it. The types here only describe
// the bodies; stock/bodies creates the solids and reads the mesh files.

#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"

namespace kadr {

/// A solid body; lengths in mm.
struct BodyShape {
  enum class Form : std::uint8_t { box, cylinder, file };
  Form form = Form::box;
  Vec3 least, most;            // two opposite corners of the body; only for a box
  Vec2 centre;                 // centre of the base in X and Y; only for a cylinder, whose axis is parallel to Z
  double bottom = 0, top = 0;  //
  double diameter = 0;         //
  std::string file;            // path of the file with the body as a closed mesh, STL or 3MF
};

/// A solid body in machine coordinates, with all axes at 0. The origin is then the gauge point of the spindle, from which tool lengths are
/// measured.
struct MachineBody {
  std::string name;
  std::string on;  // name of the axis that carries the body; empty: the bed carries it
  BodyShape shape;
};

}  // namespace kadr
