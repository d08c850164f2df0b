// Prints the state after a run as JSON: the key `state` in the trace's last line (tests/golden/README.md). Used by cli/run,
// config/state/state_rows; tested by tests/config/state_json_test.cpp.

#include "config/state/state_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "config/json_text.h"

namespace kadr {
namespace {

using OrderedJson = nlohmann::ordered_json;

// 2^53: whole numbers below this are exact in a double, and are printed without a decimal point.
constexpr double most_exact = 9007199254740992;

OrderedJson json_number(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (std::abs(value) < most_exact && value == std::trunc(value)) return static_cast<std::int64_t>(value);
  return value;
}

void put_if(OrderedJson& to, const char* key, double value) {
  if (value != 0) to[key] = json_number(value);
}

OrderedJson axes(const AxisValues& values) {
  OrderedJson to = OrderedJson::object();
  for (const auto& [axis, value] : values) to[axis] = json_number(value);
  return to;
}

/// Adds the table `key` to the object, as {"name": row} for each row. A table without rows is not added.
template <class Map, class Name, class Row>
void put_table(OrderedJson& to, const char* key, const Map& rows, Name name, Row row) {
  for (const auto& [number_or_name, value] : rows) to[key][name(number_or_name)] = row(value);
}

std::string row_name(int n) { return std::to_string(n); }
std::string own_name(const std::string& name) { return name; }
std::string pocket_name(const std::pair<int, int>& place) { return std::to_string(place.first) + "/" + std::to_string(place.second); }

OrderedJson offset(const ToolOffset& o) {
  OrderedJson to = {{"length", json_number(o.length)},        {"length_wear", json_number(o.length_wear)},
                    {"radius", json_number(o.radius)},        {"radius_wear", json_number(o.radius_wear)},
                    {"corner_radius", json_number(o.corner)}, {"corner_radius_wear", json_number(o.corner_wear)}};
  put_if(to, "length_x", o.length_x);
  put_if(to, "length_x_wear", o.length_x_wear);
  put_if(to, "length_y", o.length_y);
  put_if(to, "length_y_wear", o.length_y_wear);
  put_if(to, "tip_position", o.tip_position);
  return to;
}

OrderedJson tool_info(std::uint32_t info) {
  if (info >> tool_info_letters.size() != 0) return info;
  std::string text;
  for (std::size_t bit = tool_info_letters.size(); bit-- > 0;) text += tool_info_letters[bit][info >> bit & 1U];
  return text;
}

OrderedJson tool_row(const ToolRow& row) {
  OrderedJson to = {{"T", json_number(row.type)},
                    {"info", tool_info(row.info)},
                    {"form", row.form},
                    {"status", row.status},
                    {"counter", json_number(row.counter)},
                    {"life", json_number(row.life)},
                    {"warn", json_number(row.warn)},
                    {"H", json_number(row.h)},
                    {"D", json_number(row.d)},
                    {"G", json_number(row.g)},
                    {"W", json_number(row.w)},
                    {"S", json_number(row.s)},
                    {"F", json_number(row.f)}};
  put_if(to, "user_bits", row.user_bits);
  std::size_t used = row.user.size();
  while (used > 0 && row.user[used - 1] == 0) --used;
  for (std::size_t i = 0; i < used; ++i) to["user"].push_back(json_number(row.user[i]));
  return to;
}

OrderedJson tool_form(const ToolForm& form) {
  return {{"left", json_number(form.left)},
          {"right", json_number(form.right)},
          {"up", json_number(form.up)},
          {"down", json_number(form.down)},
          {"geometry", json_number(form.geometry)}};
}

OrderedJson parameter_value(const ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return json_number(std::get<double>(value));
}

/// Returns the state of a spindle: the constant data of the set-up, and the present state of the run.
OrderedJson spindle(const SpindleSetup& fixed, const RunState::SpindleState& now) {
  OrderedJson to = OrderedJson::object();
  if (!fixed.name.empty()) to["name"] = fixed.name;
  if (fixed.channel != 1) to["channel"] = fixed.channel;
  for (const auto& [least, most] : fixed.ranges) to["ranges"].push_back({json_number(least), json_number(most)});
  to["rpm"] = json_number(now.rpm);
  to["dir"] = now.dir;
  to["loop"] = now.loop;
  to["surface_speed"] = json_number(now.surface_speed);
  to["css_axis"] = now.css_axis;
  to["master"] = now.master == 0 ? OrderedJson(nullptr) : OrderedJson(now.master);
  if (now.angle) to["angle"] = json_number(*now.angle);
  return to;
}

void put_spindles(OrderedJson& to, const RunState& state) {
  std::map<int, RunState::SpindleState> spindles = state.spindles;
  for (const auto& [n, s] : state.tables.spindles)
    spindles.insert({n, {s.loop, s.rpm, s.dir, s.surface_speed, s.css_axis, s.master, s.angle}});
  for (const auto& [n, now] : spindles) {
    const auto fixed = state.tables.spindles.find(n);
    to["spindle"][row_name(n)] = spindle(fixed == state.tables.spindles.end() ? SpindleSetup{} : fixed->second, now);
  }
}

void put_switches(OrderedJson& to, const Setup& tables) {
  if (!tables.skip.empty()) to["skip"] = tables.skip;
  if (tables.optional_stop) to["optional_stop"] = true;
  if (tables.single_block) to["single_block"] = true;
  if (!tables.mirror.empty()) to["mirror"] = tables.mirror;
}

}  // namespace

std::string state_json(const RunState& state) {
  const Setup& t = state.tables;
  OrderedJson to = OrderedJson::object();
  for (const auto& [n, row] : t.offsets)
    if (row != ToolOffset{}) to["offsets"][row_name(n)] = offset(row);
  put_table(to, "work_offsets", t.work_offsets, own_name, axes);
  put_table(to, "zeros", t.zeros, row_name, axes);
  put_table(to, "correctors", t.correctors, row_name, json_number);
  put_table(
      to, "parameters", t.parameters, [](const ParameterKey& key) { return text_of(key); }, parameter_value);
  put_table(to, "shifts", state.shifts, own_name, axes);
  put_table(to, "frame", state.frame, own_name, axes);
  if (!t.plane.empty()) to["plane"] = t.plane;
  for (const auto& [axis, on] : t.diameter) to["diameter"][axis] = on;
  if (t.feed) to["feed"] = json_number(*t.feed);
  put_spindles(to, state);
  to["tool"] = t.tool;
  put_table(to, "tool_table", t.tool_table, row_name, tool_row);
  put_table(to, "place_table", t.place_table, pocket_name, [](int row) { return row; });
  put_table(to, "form_table", t.form_table, row_name, tool_form);
  put_switches(to, t);
  return json_text(to);
}

}  // namespace kadr
