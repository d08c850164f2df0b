// Set-ups and what is in force. For convert/conversion, convert/flat_places; tested by tests/convert.py.

#include "convert/source_setup.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "config/setup_check.h"

namespace kadr {
namespace {

bool has_key(const ControlDef& def, const char* name) {
  const nlohmann::json table = {{name, nlohmann::json::object()}};
  return !fault_of(table, table, &def);
}

bool is_system(const CodeRow& row) { return row.function == Function::fixture || row.function == Function::work_zero || row.function == Function::work_system || row.function == Function::table_system; }

/// Rows of the work zeros by number, whatever the control calls them.
std::map<int, AxisValues> zeros_of(const Setup& setup, const ControlDef& def) {
  std::map<int, AxisValues> zeros = setup.zeros;
  for (const CodeRow& row : def.codes)
    if (is_system(row) && row.arg > 0)
      if (const auto found = setup.work_offsets.find(row.code); found != setup.work_offsets.end()) zeros[row.arg] = found->second;
  return zeros;
}

bool has_systems(const ControlDef& def) { return std::any_of(def.codes.begin(), def.codes.end(), is_system); }

}  // namespace

OffsetsInForce offsets_of(const Control& control) {
  OffsetsInForce now;
  double length = 0, radius = 0;
  for (const InForce& one : control.in_force()) {
    if (one.kind == InForce::Kind::offset) radius = one.value;
    if (one.kind == InForce::Kind::length_offset) length = one.value;
    if (one.kind == InForce::Kind::code && (one.code == "G43" || one.code == "G44")) now.length_sign = one.code == "G43" ? 1 : -1;
  }
  now.radius_number = std::uint32_t(radius);
  now.length_number = std::uint32_t(length != 0 ? length : radius);
  return now;
}

FlatSource flat_source_of(const Session& session) {
  FlatSource source{session.control().axes(), {}, has_systems(session.def())};
  for (const auto& [number, values] : zeros_of(session.setup(), session.def()))
    for (std::size_t a = 0; a < source.axes.size() && a < max_axes; ++a)
      if (const auto found = values.find(source.axes[a]); found != values.end()) source.zeros[number][a] = found->second;
  return source;
}

Setup corresponding_setup(const Setup& setup, const ControlDef& from, const ControlDef& to, bool plain) {
  Setup made;
  made.start = setup.start, made.start_in_work = setup.start_in_work;
  made.machine = setup.machine, made.axis_limits = setup.axis_limits;
  made.skip = setup.skip, made.optional_stop = setup.optional_stop;
  made.spindles = setup.spindles;
  made.feed_override = setup.feed_override, made.rapid_override = setup.rapid_override, made.spindle_override = setup.spindle_override;
  made.tool = setup.tool;
  made.clock = setup.clock;
  if (has_key(to, "probe")) made.probe = setup.probe;
  if (plain) return made;
  if (has_key(to, "offsets")) made.offsets = setup.offsets;
  const std::map<int, AxisValues> zeros = zeros_of(setup, from);
  if (has_key(to, "zeros")) made.zeros = zeros;
  else
    for (const CodeRow& row : to.codes)
      if (is_system(row) && row.arg > 0)
        if (const auto found = zeros.find(row.arg); found != zeros.end()) made.work_offsets[row.code] = found->second;
  return made;
}

std::string setup_text(const Setup& setup) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  const auto put_axes = [](nlohmann::ordered_json& to, const AxisValues& values) {
    to = nlohmann::ordered_json::object();
    for (const auto& [axis, value] : values) to[axis] = value;
  };
  if (!setup.start.empty()) put_axes(all["start"], setup.start);
  for (const auto& [name, values] : setup.work_offsets) put_axes(all["work_offsets"][name], values);
  for (const auto& [number, values] : setup.zeros) put_axes(all["zeros"][std::to_string(number)], values);
  for (const auto& [number, offset] : setup.offsets) {
    nlohmann::ordered_json& row = all["offsets"][std::to_string(number)];
    row = nlohmann::ordered_json::object();
    for (const auto& [name, value] : {std::pair{"length", offset.length}, {"length_wear", offset.length_wear}, {"radius", offset.radius}, {"radius_wear", offset.radius_wear}})
      if (value != 0) row[name] = value;
  }
  if (setup.tool != 0) all["tool"] = setup.tool;
  if (!setup.skip.empty()) all["skip"] = setup.skip;
  if (setup.optional_stop) all["optional_stop"] = true;
  return all.dump(1) + "\n";
}

}  // namespace kadr
