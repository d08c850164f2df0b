#pragma once
// The model of a 3MF file: objects, and where they are put. For stock/mesh/threemf_read.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// A place (x, y, z, 1) times this matrix of four rows is the place in what the object is part of.
using ModelTransform = std::array<double, 12>;
inline constexpr ModelTransform as_it_is{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

struct ModelItem {
  std::uint32_t object = 0;
  ModelTransform transform = as_it_is;
};

struct ModelObject {
  Mesh mesh;                     // in the file's unit
  std::vector<ModelItem> parts;  // other objects in it
  bool is_body = true;           // no support structure
};

struct Model {
  double unit = 1;  // mm
  std::map<std::uint32_t, ModelObject> objects;
  std::vector<ModelItem> build;
};

/// Its XML text.
///   most_triangles  of all objects
///   returns         an error sentence with line and column
tl::expected<Model, std::string> read_model(std::string_view text, std::size_t most_triangles);

}  // namespace kadr
