#pragma once
// [[bodies]] of machines/*.toml: the solid bodies that a machine consists of and its axes carry. This is only the description;
// stock/bodies creates the solids and reads the mesh files.

#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"

namespace kadr {

/// A solid body, mm.
struct BodyShape {
  enum class Form : std::uint8_t { box, cylinder, file };
  Form form = Form::box;
  Vec3 least, most;            // opposite corners of a box, only for a box
  Vec2 centre;                 // centre of a cylinder, only for a cylinder, whose axis is parallel to Z
  double bottom = 0, top = 0;  //
  double diameter = 0;         //
  std::string file;            // path of a file with a closed mesh, STL or 3MF
};

/// A body in machine coordinates, with all axes at 0. The gauge point of the spindle, from which tool lengths count, is then the origin.
struct MachineBody {
  std::string name;
  std::string on;  // name of the axis that carries the body; empty: the bed
  BodyShape shape;
};

}  // namespace kadr
