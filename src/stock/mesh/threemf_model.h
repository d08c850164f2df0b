#pragma once
// Reads the model of a 3MF file: its objects, and how they are placed. Used by stock/mesh/threemf_read.

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
  Mesh mesh;                     // in the unit of the file
  std::vector<ModelItem> parts;  // the objects (components) that this object contains
  bool is_body = true;           // false for a support structure
};

struct Model {
  double unit = 1;  // length unit of the file, mm
  std::map<std::uint32_t, ModelObject> objects;
  std::vector<ModelItem> build;
};

/// Parses the XML text of a model.
///   max_triangles  limit for all objects together
///   returns         the model, or an error sentence with line and column
tl::expected<Model, std::string> read_model(std::string_view text, std::size_t max_triangles);

}  // namespace kadr
