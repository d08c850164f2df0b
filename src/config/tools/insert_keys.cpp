// Reads turning tools from a tools file. Used by config/tools/tool_library; tested by tests/config/tool_library_test.cpp.

#include "config/tools/insert_keys.h"

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "config/range.h"
#include "config/tools/convex_parts.h"
#include "config/tools/toml_tools.h"
#include "texts/tool_inserts.h"
#include "texts/tool_library.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;
using toml_tools::place;

constexpr NumberRange insert_size = {0, 1e4, texts::ranges::mm};
constexpr NumberRange insert_place = {-1e4, 1e4, texts::ranges::mm};
constexpr NumberRange entering_angle = {-360, 360, texts::ranges::degrees};

struct TipName {
  std::string_view name;
  int x, z;
};
constexpr TipName tip_names[] = {{"-x-z", -1, -1}, {"-x+z", -1, 1}, {"+x-z", 1, -1}, {"+x+z", 1, 1},  {"-x", -1, 0},
                                 {"+x", 1, 0},     {"-z", 0, -1},   {"+z", 0, 1},    {"centre", 0, 0}};

Done tip_of(const std::string& file, const toml::table& row, InsertGeometry& insert) {
  const auto word = row["points"].value<std::string_view>();
  if (!word && row.get("profile") != nullptr && row.get("points") == nullptr) return {};
  for (const TipName& t : tip_names)
    if (word == t.name) {
      insert.tip_x = t.x;
      insert.tip_z = t.z;
      return {};
    }
  return Failed(place(file, row, "points") + translated(texts::tool_inserts::points_form));
}

/// Reads a polygon as a list of points: [[x, z], …].
Done polygon_of(const std::string& file, const toml::table& row, std::string_view key, std::size_t fewest, InsertOutline& to) {
  const toml::node* const node = row.get(key);
  if (node == nullptr) return {};
  const toml::array* const list = node->as_array();
  bool fits = list != nullptr && list->size() >= fewest && list->size() <= limits::insert_points;
  for (std::size_t i = 0; fits && i < list->size(); ++i) {
    const toml::array* const pair = list->get(i)->as_array();
    const auto x = pair != nullptr && pair->size() == 2 ? pair->get(0)->value<double>() : std::nullopt;
    const auto z = pair != nullptr && pair->size() == 2 ? pair->get(1)->value<double>() : std::nullopt;
    fits = x && z && is_within(*x, insert_place) && is_within(*z, insert_place);
    if (fits) to.push_back({*x, *z});
  }
  if (fits) return {};
  return Failed(place(file, *node) + translated(texts::tool_inserts::polygon_form, key, range_in_words(insert_place)));
}

std::string polygon_fault_message(std::string_view key, const InsertOutline& outline) {
  if (outline.empty() || !convex_parts(outline).empty()) return {};
  return translated(texts::tool_inserts::polygon_crosses, key);
}

/// Returns a message about a wrong nose, such as cutting edges that are too short for their nose radius; empty if the nose is valid.
std::string nose_fault_message(const ToolGeometry& t) {
  const double nose = t.corner, width = t.insert.width;
  if (width > 0) {
    if (width < 2 * nose) return translated(texts::tool_inserts::corner_above_half_width);
    return t.flutes > nose ? std::string() : translated(texts::tool_inserts::groove_depth_missing);
  }
  if (t.angle == 0) return nose > 0 ? std::string() : translated(texts::tool_inserts::nose_missing);
  if (!(t.angle > 0 && t.angle < 180)) return translated(texts::tool_inserts::nose_angle_form);
  if (!(t.flutes > 0)) return translated(texts::tool_inserts::edges_missing);
  if (t.flutes * std::sin(t.angle * rad_per_deg) < 2 * nose) return translated(texts::tool_inserts::edges_too_short);
  return {};
}

}  // namespace

std::string_view name_of_tip(const InsertGeometry& insert) {
  for (const TipName& t : tip_names)
    if (t.x == insert.tip_x && t.z == insert.tip_z) return t.name;
  return "";
}

Done insert_of(const std::string& file, const toml::table& row, InsertGeometry& insert) {
  Done done = tip_of(file, row, insert);
  double lead = 0;
  if (done) done = toml_tools::number(file, row, "lead", entering_angle, lead);
  if (done && row.get("lead") != nullptr) insert.lead = lead;
  if (done) done = toml_tools::number(file, row, "width", insert_size, insert.width);
  if (done) done = polygon_of(file, row, "profile", 3, insert.profile);
  if (done) done = polygon_of(file, row, "holder", 2, insert.holder);
  return done;
}

void complete_insert(ToolGeometry& t) {
  InsertGeometry& i = t.insert;
  if (i.width == 0 && t.angle == 0 && t.flutes == 0) t.flutes = 2 * t.corner;
  if (i.lead) return;
  if (i.width > 0) i.lead = i.tip_x == 0 && i.tip_z != 0 ? 0 : 90;
  else i.lead = (i.tip_z == 0 ? 90 : i.tip_x == 0 ? 180 : 135) - t.angle / 2;
}

std::string insert_fault_message(const ToolGeometry& t) {
  const InsertGeometry& i = t.insert;
  for (const double size : {t.corner, t.flutes, t.length, i.width})
    if (!is_within(size, insert_size)) return translated(texts::tool_library::size_must_be, range_in_words(insert_size));
  if (!is_within(t.angle, {0, 180}) || !is_within(i.lead.value_or(0), entering_angle))
    return translated(texts::tool_inserts::angle_must_be, range_in_words(entering_angle));
  if (i.profile.empty()) {
    if (std::string fault = nose_fault_message(t); !fault.empty()) return fault;
    if (i.width > 0 && i.lead != 0 && i.lead != 90) return translated(texts::tool_inserts::grooving_lead);
    if (t.length < t.flutes) return translated(texts::tool_inserts::side_below_edges);
  }
  if (std::string fault = polygon_fault_message("profile", i.profile); !fault.empty()) return fault;
  return polygon_fault_message("holder", i.holder);
}

}  // namespace kadr
