#pragma once
// Reads the model of a 3MF file: the objects, and how they are placed. Used by stock/mesh/threemf_read.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// A matrix of four rows and three columns. The row vector (x, y, z, 1) of a point, times this matrix, is the point in the parent object.
using ModelTransform = std::array<double, 12>;
inline constexpr ModelTransform as_it_is{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

struct ModelItem {
  std::uint32_t object = 0;
  ModelTransform transform = as_it_is;
};

struct ModelObject {
  Mesh mesh;                     // mesh of the object, in the length unit of the file
  std::vector<ModelItem> parts;  // the objects (components) that this object contains
  bool is_body = true;           // false for a support structure, which is not part of the result
};

struct Model {
  double unit = 1;  // length of the file's unit in mm
  std::map<std::uint32_t, ModelObject> objects;
  std::vector<ModelItem> build;
};

/// Parses the XML text of a model.
///   max_triangles  greatest number of triangles of all objects together
///   returns         the model, or an error sentence that contains the line and column
tl::expected<Model, std::string> read_model(std::string_view text, std::size_t max_triangles);

}  // namespace kadr
