// Reads tools.toml, which describes the shapes of the tools. Used by session and cli; tested by tests/config/tool_library_test.cpp.

#include "config/tools/tool_library.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "config/nearest.h"
#include "config/range.h"
#include "config/read_file.h"
#include "config/tools/insert_keys.h"
#include "config/tools/toml_tools.h"
#include "config/tools/tool_formats.h"
#include "config/tools/tool_row.h"
#include "texts/tool_library.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;
using toml_tools::place;

struct KindName {
  std::string_view name;
  ToolKind kind;
};
constexpr KindName kind_names[] = {{"flat", ToolKind::flat},   {"ball", ToolKind::ball},   {"bull", ToolKind::bull},
                                   {"drill", ToolKind::drill}, {"taper", ToolKind::taper}, {"chamfer", ToolKind::chamfer},
                                   {"tslot", ToolKind::tslot}, {"form", ToolKind::form},   {"turning", ToolKind::turning}};

constexpr std::string_view tool_keys[] = {"number",  "name",         "kind",   "diameter", "corner", "angle",
                                          "tip",     "flute_length", "length", "profile",  "shank",  "holder",
                                          "plunges", "flute_count",  "points", "lead",     "width"};

/// Keys of files for earlier versions of Kadr, with their replacements. Kadr still reads the old names. They were replaced because they
/// mean something else in the trade (`flutes` was a length).
struct OldKey {
  std::string_view old, now;
};
constexpr OldKey old_keys[] = {{"flutes", "flute_length"}, {"teeth", "flute_count"}};

bool is_old_key(std::string_view key) {
  return std::any_of(std::begin(old_keys), std::end(old_keys), [&](const OldKey& k) { return k.old == key; });
}

std::string old_key_message(const OldKey& key) { return translated(texts::tool_library::old_key, key.old, key.now); }

std::string assumed_flutes_message(const std::vector<std::uint32_t>& tools) {
  std::string numbers;
  for (const std::uint32_t number : tools) numbers += (numbers.empty() ? "T" : ", T") + std::to_string(number);
  return translated(texts::tool_library::assumed_heights, numbers);
}

/// Returns the name under which the row states a key: the present name of the key, or a name from an earlier version of Kadr.
std::string_view key_in(const toml::table& row, std::string_view now) {
  for (const OldKey& k : old_keys)
    if (k.now == now && row.contains(k.old)) return k.old;
  return now;
}

constexpr NumberRange size_range = {0, 1e4, texts::ranges::mm};
constexpr NumberRange angle_range = {0, 180, texts::ranges::degrees};

Done known_tool_keys(const std::string& file, const toml::table& row) {
  for (const auto& [key, node] : row) {
    if (std::find(std::begin(tool_keys), std::end(tool_keys), key.str()) != std::end(tool_keys)) continue;
    if (is_old_key(key.str())) continue;
    const std::string_view near = toml_tools::nearest(key.str(), {std::begin(tool_keys), std::end(tool_keys)});
    return Failed(place(file, node) + (near.empty() ? translated(texts::tool_library::unknown_key, key.str())
                                                    : translated(texts::tool_library::unknown_key_near, key.str(), near)));
  }
  for (const auto& [old, now] : old_keys)
    if (row.contains(old) && row.contains(now))
      return Failed(place(file, *row.get(old)) + translated(texts::tool_library::same_keys, old, now));
  return {};
}

Done number_of(const std::string& file, const toml::table& row, ToolGeometry& tool) {
  const auto number = row["number"].value<std::int64_t>();
  if (!number || *number < 0 || *number > 99'999'999 || !row["number"].is_integer())
    return Failed(place(file, row, "number") + translated(texts::tool_library::number_form));
  tool.number = std::uint32_t(*number);
  return {};
}

Done teeth_of(const std::string& file, const toml::table& row, ToolGeometry& tool) {
  const std::string key(key_in(row, "flute_count"));
  const toml::node* const node = row.get(key);
  if (node == nullptr) return {};
  const auto teeth = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
  if (!teeth || *teeth < 1 || *teeth > limits::teeth)
    return Failed(place(file, *node) + translated(texts::tool_library::teeth_form, key, limits::teeth));
  tool.teeth = int(*teeth);
  return {};
}

Done kind_of(const std::string& file, const toml::table& row, ToolGeometry& tool) {
  const auto word = row["kind"].value<std::string_view>();
  for (const KindName& k : kind_names)
    if (word == k.name) {
      tool.kind = k.kind;
      return {};
    }
  return Failed(place(file, row, "kind") + translated(texts::tool_library::kind_form));
}

/// Reads an outline as a list of points: [[diameter, height], …].
Done outline_of(const std::string& file, const toml::table& row, std::string_view key, std::vector<ProfilePoint>& to) {
  const toml::node* const node = row.get(key);
  if (node == nullptr) return {};
  const toml::array* const list = node->as_array();
  bool fits = list != nullptr && list->size() >= 2 && list->size() <= limits::outline_points;
  for (std::size_t i = 0; fits && i < list->size(); ++i) {
    const toml::array* const pair = list->get(i)->as_array();
    const auto diameter = pair != nullptr && pair->size() == 2 ? pair->get(0)->value<double>() : std::nullopt;
    const auto height = pair != nullptr && pair->size() == 2 ? pair->get(1)->value<double>() : std::nullopt;
    fits = diameter && height && is_within(*diameter, size_range) && is_within(*height, size_range);
    if (fits) to.push_back({*diameter, *height});
  }
  if (fits) return {};
  return Failed(place(file, *node) + translated(texts::tool_library::outline_form, key, range_in_words(size_range)));
}

/// Returns a message about a wrong outline; empty if the outline is valid.
std::string outline_fault_message(std::string_view key, const std::vector<ProfilePoint>& outline) {
  double widest = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (!is_within(outline[i].diameter, size_range) || !is_within(outline[i].height, size_range))
      return translated(texts::tool_library::outline_number, key, range_in_words(size_range));
    widest = std::max(widest, outline[i].diameter);
    if (i != 0 && outline[i].height < outline[i - 1].height) return translated(texts::tool_library::heights_fall, key);
  }
  const bool flat = !outline.empty() && !(outline.back().height > outline.front().height && widest > 0);
  return flat ? translated(texts::tool_library::outline_without_extent, key) : std::string();
}

std::string end_fault_message(const ToolGeometry& t) {
  const double max_angle = t.kind == ToolKind::taper ? 90 : 180;
  switch (t.kind) {
    case ToolKind::bull:
      if (!(t.corner <= t.diameter / 2)) return translated(texts::tool_library::corner_too_large);
      break;
    case ToolKind::drill:
    case ToolKind::chamfer:
    case ToolKind::taper:
      if (!(t.angle > 0 && t.angle < max_angle))
        return translated(t.kind == ToolKind::taper ? texts::tool_library::half_angle_missing : texts::tool_library::point_angle_missing);
      if (!(t.tip < t.diameter)) return translated(texts::tool_library::tip_too_wide);
      break;
    default: break;
  }
  return {};
}

}  // namespace

std::string_view name_of(ToolKind kind) {
  for (const KindName& k : kind_names)
    if (k.kind == kind) return k.name;
  return "";
}

const ToolGeometry* ToolLibrary::find(std::uint32_t number) const {
  const auto found = std::find_if(tools.begin(), tools.end(), [&](const ToolGeometry& t) { return t.number == number; });
  if (found != tools.end()) return &*found;
  return tools.size() == 1 && tools.front().number == 0 ? &tools.front() : nullptr;
}

bool assume_heights(ToolGeometry& t) {
  // Assumed lengths as multiples of the diameter; most catalogues have such lengths.
  constexpr double flutes_share = 3, length_share = 5, drill_flutes_share = 8, drill_length_share = 10;
  const bool is_known = t.flutes != 0 || t.length != 0 || !t.profile.empty() || !t.shank.empty() || t.kind == ToolKind::turning;
  if (is_known || !(t.diameter > 0)) return false;
  const bool drills = t.kind == ToolKind::drill;
  t.flutes = t.diameter * (drills ? drill_flutes_share : flutes_share);
  t.length = t.diameter * (drills ? drill_length_share : length_share);
  return true;
}

void complete(ToolGeometry& t) {
  if (t.kind == ToolKind::form && !t.profile.empty()) {
    if (t.flutes == 0) t.flutes = t.profile.back().height;
    for (const ProfilePoint& p : t.profile) t.diameter = std::max(t.diameter, p.diameter);
  }
  if (t.kind == ToolKind::turning) complete_insert(t);
  if (t.length == 0) t.length = t.shank.empty() ? t.flutes : std::max(t.flutes, t.shank.back().height);
  if (t.flutes == 0) t.flutes = t.length;
}

std::string tool_fault_message(const ToolGeometry& t) {
  if (t.kind == ToolKind::turning) return insert_fault_message(t);
  if (t.kind == ToolKind::form && t.profile.empty()) return translated(texts::tool_library::profile_missing);
  for (const double size : {t.diameter, t.corner, t.tip, t.flutes, t.length})
    if (!is_within(size, size_range)) return translated(texts::tool_library::size_must_be, range_in_words(size_range));
  if (!(t.diameter > 0)) return translated(texts::tool_library::diameter_missing);
  if (!(t.flutes > 0)) return translated(texts::tool_library::flute_length_missing);
  if (t.length < t.flutes) return translated(texts::tool_library::length_below_flutes);
  if (const std::string end = end_fault_message(t); !end.empty()) return end;
  for (const auto& [key, outline] : {std::pair("profile", &t.profile), std::pair("shank", &t.shank), std::pair("holder", &t.holder)})
    if (std::string fault = outline_fault_message(key, *outline); !fault.empty()) return fault;
  return {};
}

tl::expected<ToolGeometry, std::string> tool_of(const std::string& file, const toml::table& row) {
  ToolGeometry tool;
  Done done = known_tool_keys(file, row);
  if (done) done = number_of(file, row, tool);
  if (done) done = kind_of(file, row, tool);
  if (done) done = teeth_of(file, row, tool);
  const auto number = [&](std::string_view key, const NumberRange& range, double& to) {
    if (done) done = toml_tools::number(file, row, key, range, to);
  };
  number("diameter", size_range, tool.diameter);
  number("corner", size_range, tool.corner);
  number("angle", angle_range, tool.angle);
  number("tip", size_range, tool.tip);
  number(key_in(row, "flute_length"), size_range, tool.flutes);
  number("length", size_range, tool.length);
  const bool turns = tool.kind == ToolKind::turning;
  if (done && turns) done = insert_of(file, row, tool.insert);
  if (done && !turns) done = outline_of(file, row, "profile", tool.profile);
  if (done && !turns) done = outline_of(file, row, "shank", tool.shank);
  if (done && !turns) done = outline_of(file, row, "holder", tool.holder);
  if (!done) return Failed(done.error());
  tool.name = toml_tools::value_or<std::string>(row, "name", "");
  tool.plunges = toml_tools::value_or(row, "plunges", true);
  (void)assume_heights(tool);
  complete(tool);
  if (const std::string fault = tool_fault_message(tool); !fault.empty())
    return Failed(place(file, row, "number") + translated(texts::tool_library::fault_of_tool, tool.number, fault));
  return tool;
}

Done add_tool(const std::string& file, const toml::table& row, ToolGeometry tool, ToolLibrary& to) {
  const auto same = [&](const ToolGeometry& other) { return other.number == tool.number; };
  if (std::any_of(to.tools.begin(), to.tools.end(), same))
    return Failed(place(file, row, "number") + translated(texts::tool_library::stands_twice, tool.number));
  to.tools.push_back(std::move(tool));
  return {};
}

tl::expected<ToolLibrary, std::string> tools_of_toml(std::string_view text, const std::string& file) {
  auto table = toml_tools::parsed(text, file);
  if (!table) return Failed(table.error());
  for (const auto& [key, node] : *table)
    if (key.str() != "tool") return Failed(place(file, node) + translated(texts::tool_library::unknown_key_of_file, key.str()));
  const toml::array* const rows = (*table)["tool"].as_array();
  if (rows == nullptr || rows->empty() || rows->size() > limits::tools)
    return Failed(file + ": " + translated(texts::tool_library::tables_wanted));
  ToolLibrary library;
  std::set<std::string_view> old;
  std::vector<std::uint32_t> assumed;
  for (const toml::node& row : *rows) {
    if (!row.is_table()) return Failed(place(file, row) + translated(texts::tool_library::no_table));
    auto tool = tool_of(file, *row.as_table());
    if (!tool) return Failed(tool.error());
    ToolGeometry stated = *tool;
    for (const std::string_view key : {"flute_length", "length"})
      if (!row.as_table()->contains(key_in(*row.as_table(), key))) (key == "length" ? stated.length : stated.flutes) = 0;
    if (assume_heights(stated)) assumed.push_back(tool->number);
    if (const Done added = add_tool(file, *row.as_table(), std::move(*tool), library); !added) return Failed(added.error());
    for (const OldKey& k : old_keys)
      if (row.as_table()->contains(k.old)) old.insert(k.old);
  }
  for (const OldKey& k : old_keys)
    if (old.contains(k.old)) library.notes.push_back(file + ": " + old_key_message(k));
  if (!assumed.empty()) library.notes.push_back(file + ": " + assumed_flutes_message(assumed));
  return library;
}

tl::expected<ToolLibrary, std::string> load_tools(const std::string& path, const FileAccess* door) {
  const auto text = read_file(path, limits::config_file_bytes, door);
  if (!text) return Failed(text.error());
  switch (tool_format_of(*text, path)) {
    case ToolFormat::toml: return tools_of_toml(*text, path);
    case ToolFormat::linuxcnc: return tools_of_linuxcnc(*text, path);
    case ToolFormat::camotics: return tools_of_camotics(*text, path);
    case ToolFormat::freecad: return tools_of_freecad(*text, path);
    case ToolFormat::fusion: return tools_of_fusion(*text, path);
  }
  return Failed(path);
}

}  // namespace kadr
