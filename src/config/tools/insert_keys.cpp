// Reads turning tools from a tools file. Used by config/tools/tool_library; tested by tests/config/tool_library_test.cpp.

#include "config/tools/insert_keys.h"

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "config/language.h"
#include "config/range.h"
#include "config/tools/convex_parts.h"
#include "config/tools/toml_tools.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;
using toml_tools::place;

constexpr NumberRange insert_size = {0, 1e4, "mm", "мм"};
constexpr NumberRange insert_place = {-1e4, 1e4, "mm", "мм"};
constexpr NumberRange entering_angle = {-360, 360, "degrees", "градусов"};

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
  return Failed(place(file, row, "points") +
                told("points: where the tip points, from the nose's centre to the programmed point: -x-z, -x+z, +x-z, +x+z, -x, +x, -z, +z "
                     "or centre",
                     "points: куда смотрит вершина, от центра радиуса к запрограммированной точке: -x-z, -x+z, +x-z, +x+z, -x, +x, -z, +z "
                     "или centre"));
}

/// Reads [[x, z], …].
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
  return Failed(place(file, *node) + std::string(key) +
                told(": of a turning tool a list of [x, z], 2 (a rectangle's opposite corners; a profile 3) to 64 of them, each number ",
                     ": у резца список [x, z], от 2 (противоположные углы прямоугольника; у profile 3) до 64, каждое число ") +
                told(insert_place));
}

std::string polygon_fault_message(std::string_view key, const InsertOutline& outline) {
  if (outline.empty() || !convex_parts(outline).empty()) return {};
  return std::string(key) + told(" crosses itself or has no area", " пересекает сам себя или не имеет площади");
}

/// Returns what is wrong with the nose, such as cutting edges that are too short for their nose radius.
std::string nose_fault_message(const ToolGeometry& t) {
  const double nose = t.corner, width = t.insert.width;
  if (width > 0) {
    if (width < 2 * nose) return told("corner is more than half of the width", "corner больше половины width");
    return t.flutes > nose ? std::string() : told("flute_length is missing: how deep it can groove", "нет flute_length: глубина канавки");
  }
  if (t.angle == 0)
    return nose > 0 ? std::string()
                    : told("angle is missing: of the nose; or width of a grooving insert; or corner of a round one",
                           "нет angle: угол при вершине; или width канавочной пластины; или corner круглой");
  if (!(t.angle > 0 && t.angle < 180)) return told("angle must be above 0 and below 180 degrees", "angle: больше 0 и меньше 180 градусов");
  if (!(t.flutes > 0)) return told("flute_length is missing: the length of the cutting edges", "нет flute_length: длина режущих кромок");
  if (t.flutes * std::sin(t.angle * rad_per_deg) < 2 * nose)
    return told("flute_length is too short for that corner", "flute_length слишком мало для такого corner");
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
    if (!is_within(size, insert_size)) return told("a size must be ", "размер должен быть ") + told(insert_size);
  if (!is_within(t.angle, {0, 180}) || !is_within(i.lead.value_or(0), entering_angle))
    return told("an angle must be ", "угол должен быть ") + told(entering_angle);
  if (i.profile.empty()) {
    if (std::string fault = nose_fault_message(t); !fault.empty()) return fault;
    if (i.width > 0 && i.lead != 0 && i.lead != 90)
      return told("lead of a grooving insert: 90, it plunges along x, or 0, along z",
                  "lead канавочной пластины: 90 — врезается по x, или 0 — по z");
    if (t.length < t.flutes)
      return told("length (of the insert's side) is less than flute_length", "length (сторона пластины) меньше flute_length");
  }
  if (std::string fault = polygon_fault_message("profile", i.profile); !fault.empty()) return fault;
  return polygon_fault_message("holder", i.holder);
}

}  // namespace kadr
