#pragma once
// [[bodies]] of machines/*.toml: what a machine is made of, as solid bodies that its axes carry. Only said here: stock/bodies makes solids
// of it, and reads the files.

#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"

namespace kadr {

/// A solid body, mm.
struct BodyShape {
  enum class Form : std::uint8_t { box, cylinder, file };
  Form form = Form::box;
  Vec3 least, most;            // of a box
  Vec2 centre;                 // of a cylinder, its axis along Z
  double bottom = 0, top = 0;  //
  double diameter = 0;         //
  std::string file;            // a closed mesh, STL or 3MF
};

/// In machine coordinates as all axes stand at 0, where the gauge point of the spindle is {}.
struct MachineBody {
  std::string name;
  std::string on;  // axis that carries it; empty: it stands on the bed
  BodyShape shape;
};

}  // namespace kadr
