// Reads tools from a JSON list. The list is converted to the tables of a tools file, so that the same checks apply. Used by
// view/page/page_part; tested by tests/config/tool_list_test.cpp.

#include "config/tools/tool_list.h"

#include <nlohmann/json.hpp>

#include "config/json_scan.h"
#include "config/json_text.h"
#include "config/tools/insert_keys.h"
#include "config/tools/tool_row.h"
#include "texts/tool_library.h"

namespace kadr {
namespace {

using nlohmann::json;
using Failed = tl::unexpected<std::string>;

toml::table table_of(const json& object);
toml::array array_of(const json& list);

/// Converts a JSON value to a value of toml++, and calls `take` with it; for null, does not call `take`.
template <class Take>
void each_kind(const json& value, const Take& take) {
  if (value.is_object()) take(table_of(value));
  else if (value.is_array()) take(array_of(value));
  else if (value.is_string()) take(value.get<std::string>());
  else if (value.is_boolean()) take(value.get<bool>());
  else if (value.is_number_integer() && value <= json(INT64_MAX)) take(value.get<std::int64_t>());
  else if (value.is_number()) take(value.get<double>());
}

toml::table table_of(const json& object) {
  toml::table table;
  for (const auto& [key, value] : object.items()) each_kind(value, [&, &name = key](auto&& node) { table.insert(name, std::move(node)); });
  return table;
}

toml::array array_of(const json& list) {
  toml::array array;
  for (const json& value : list) each_kind(value, [&](auto&& node) { array.push_back(std::move(node)); });
  return array;
}

/// Returns the name of a list element for messages: "T5", or the position in the list if the tool has no number.
std::string called_in_list(const json& row, std::size_t i) {
  const auto number = row.find("number");
  if (number != row.end() && number->is_number_integer()) return "T" + number->dump();
  return translated(texts::tool_library::number_in_list, i + 1);
}

nlohmann::ordered_json points_json(const std::vector<ProfilePoint>& outline) {
  auto list = nlohmann::ordered_json::array();
  for (const ProfilePoint& p : outline) list.push_back({p.diameter, p.height});
  return list;
}

nlohmann::ordered_json points_json(const std::vector<InsertPoint>& outline) {
  auto list = nlohmann::ordered_json::array();
  for (const InsertPoint& p : outline) list.push_back({p.x, p.z});
  return list;
}

}  // namespace

nlohmann::ordered_json tool_json(const ToolGeometry& t) {
  const bool turns = t.kind == ToolKind::turning;
  nlohmann::ordered_json json = {{"number", t.number}, {"kind", name_of(t.kind)}};
  if (!t.name.empty()) json["name"] = t.name;
  const auto put = [&](const char* key, double value) {
    if (value != 0) json[key] = value;
  };
  put("diameter", t.diameter), put("corner", t.corner), put("angle", t.angle), put("tip", t.tip), put("flute_length", t.flutes);
  put("length", t.length), put("width", t.insert.width);
  if (turns && !name_of_tip(t.insert).empty() && (t.insert.profile.empty() || name_of_tip(t.insert) != "centre"))
    json["points"] = name_of_tip(t.insert);
  if (t.insert.lead) json["lead"] = *t.insert.lead;
  const auto put_outline = [&](const char* key, const auto& outline) {
    if (!outline.empty()) json[key] = points_json(outline);
  };
  if (turns) put_outline("profile", t.insert.profile), put_outline("holder", t.insert.holder);
  else put_outline("profile", t.profile), put_outline("shank", t.shank), put_outline("holder", t.holder);
  if (!t.plunges) json["plunges"] = false;
  if (t.teeth != 0) json["flute_count"] = t.teeth;
  return json;
}

tl::expected<ToolLibrary, std::string> tools_of_list(std::string_view text) {
  if (const std::string fault = json_fault_message(text, "tools"); !fault.empty()) return Failed(fault);
  const json list = json_of(text);
  if (!list.is_array() || list.empty() || list.size() > limits::tools)
    return Failed("tools: " + translated(texts::tool_library::list_wanted, limits::tools));
  ToolLibrary library;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_object()) return Failed("tools: " + translated(texts::tool_library::objects_wanted));
    const std::string name = called_in_list(list[i], i);
    const toml::table row = table_of(list[i]);
    auto tool = tool_of(name, row);
    if (!tool) return Failed(tool.error());
    if (const auto added = add_tool(name, row, std::move(*tool), library); !added) return Failed(added.error());
  }
  return library;
}

}  // namespace kadr
