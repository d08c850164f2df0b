// Reads descriptions of solids: boxes, cylinders and mesh files. This file is used by cli/cut and view/part_run, and tested by
// tests/session/named_body_test.cpp.

#include "session/cutting/named_body.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "config/nearest.h"
#include "stock/blank/mesh_blank.h"
#include "stock/mesh/mesh_file.h"
#include "stock/turned/turned_mesh.h"
#include "texts/cutting.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;
constexpr double farthest = 1e5;         // greatest permitted coordinate of a solid, mm
constexpr double tube_deviation = 1e-3;  // greatest deviation of the mesh of a tube, mm

/// Reads numbers that are separated by commas. Returns nullopt if the text contains anything else.
std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc() || !(std::abs(value) <= farthest)) return std::nullopt;
    numbers.push_back(value);
    if (read.ptr == end) return numbers;
    if (*read.ptr != ',') return std::nullopt;
    at = read.ptr + 1;
  }
}

tl::expected<NamedBody, std::string> body_of_file(const std::string& path, double max_bytes, const FileAccess* door) {
  MeshRules rules;
  rules.memory = std::size_t(max_bytes);
  auto solid = read_mesh_file(path, rules, door);
  if (!solid) return Failed(solid.error());
  NamedBody body{nullptr, std::move(solid->notes)};
  body.body = mesh_blank(std::move(solid->mesh));
  return body;
}

}  // namespace

std::optional<BodyShape> shape_of_words(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const auto n = colon == std::string::npos ? std::nullopt : numbers_of(std::string_view(text).substr(colon + 1));
  BodyShape shape;
  if (kind == "box" && n && n->size() == 6 && (*n)[0] < (*n)[3] && (*n)[1] < (*n)[4] && (*n)[2] < (*n)[5]) {
    shape.least = {(*n)[0], (*n)[1], (*n)[2]};
    shape.most = {(*n)[3], (*n)[4], (*n)[5]};
    return shape;
  }
  if (kind != "cylinder" || !n || n->size() != 5 || !((*n)[2] < (*n)[3] && (*n)[4] > 0)) return std::nullopt;
  shape.form = BodyShape::Form::cylinder;
  shape.centre = {(*n)[0], (*n)[1]};
  shape.bottom = (*n)[2], shape.top = (*n)[3], shape.diameter = (*n)[4];
  return shape;
}

std::optional<TurnedRegion> turned_region_of(const std::string& text) {
  constexpr std::string_view kind = "cylinder:";
  const auto n = text.starts_with(kind) ? numbers_of(std::string_view(text).substr(kind.size())) : std::nullopt;
  if (!n || (n->size() != 5 && n->size() != 6) || (*n)[0] != 0 || (*n)[1] != 0) return std::nullopt;
  const double bottom = (*n)[2], top = (*n)[3], diameter = (*n)[4], bore = n->size() == 6 ? (*n)[5] : 0;
  if (!(bottom < top && diameter > bore && bore >= 0)) return std::nullopt;
  return cylinder_region(bottom, top, diameter, bore);
}

bool names_mesh_file(const std::string& text) {
  const std::string small = in_small_letters(text);
  return small.ends_with(".stl") || small.ends_with(".3mf");
}

tl::expected<NamedBody, std::string> body_of(const std::string& text, double max_bytes, const FileAccess* door) {
  if (names_mesh_file(text)) return body_of_file(text, max_bytes, door);
  if (const auto shape = shape_of_words(text)) {
    if (shape->form == BodyShape::Form::box) return NamedBody{box_blank({shape->least, shape->most}), {}};
    return NamedBody{cylinder_blank(shape->centre, shape->bottom, shape->top, shape->diameter), {}};
  }
  if (const auto tube = turned_region_of(text)) return NamedBody{mesh_blank(turned_mesh(*tube, tube_deviation)), {}};
  if (text.starts_with("box:")) return Failed(translated(texts::cutting::want_box, text));
  if (text.starts_with("cylinder:")) return Failed(translated(texts::cutting::want_cylinder, text));
  return Failed(translated(texts::cutting::want_body, text));
}

tl::expected<Box3, std::string> window_of(const std::string& text) {
  const auto n = numbers_of(text);
  if (n && n->size() == 6 && (*n)[0] < (*n)[3] && (*n)[1] < (*n)[4] && (*n)[2] < (*n)[5])
    return Box3{{(*n)[0], (*n)[1], (*n)[2]}, {(*n)[3], (*n)[4], (*n)[5]}};
  return Failed(translated(texts::cutting::want_window, text));
}

}  // namespace kadr
