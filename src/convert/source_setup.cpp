// Finds the set-up of the target control and the offsets in force. Used by convert/conversion and convert/flat/flat_ranges; tested by
// tests/convert.py.

#include "convert/source_setup.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <nlohmann/json.hpp>

#include "config/json_text.h"
#include "config/machine/machine_codes.h"
#include "config/setup/setup_check.h"
#include "config/setup/setup_keys.h"
#include "config/setup/setup_names.h"
#include "convert/variable_numbers.h"
#include "out/program/codes.h"

namespace kadr {
namespace {

bool is_system(const CodeRow& row) {
  return row.function == Function::fixture || row.function == Function::work_zero || row.function == Function::work_system ||
         row.function == Function::table_system;
}

/// Returns the work offsets by number of the work system, independent of their names on the control.
std::map<int, AxisValues> zeros_of(const Setup& setup, const ControlDef& def) {
  std::map<int, AxisValues> zeros = setup.zeros;
  for (const WorkSystem& system : work_systems(def))
    if (const auto found = setup.work_offsets.find(system.name); found != setup.work_offsets.end())
      zeros[static_cast<int>(system.row)] = found->second;
  return zeros;
}

/// Returns the number of the imaginary tip of a turning tool on LinuxCNC, for its number on other controls, or the reverse. LinuxCNC draws
/// the tips with X pointing down, so the two numbers differ by a mirror image in X (spec/fanuc-t 7.1).
double mirrored_tip(double tip) {
  constexpr std::array<int, 10> numbers{0, 4, 3, 2, 1, 5, 8, 7, 6, 9};
  return tip >= 0 && tip < double(numbers.size()) ? numbers[static_cast<std::size_t>(tip)] : tip;
}

/// N1416 #2 TOL of the NCT: the offset table has the lengths of turning tools (nct 15.4).
ParameterKey turning_table_bit() { return {"1416", "", "2"}; }

/// Returns the row of the target control's offset table that moves the machine like this row of the source control. A lathe has geometry
/// and wear of each axis; the other controls have one value, their sum. The NCT states the length along a diameter axis as a diameter (nct
/// 5.3).
ToolOffset offset_there(const ToolOffset& offset, const Setup& setup, const ControlDef& from, const ControlDef& to) {
  if (is_lathe(from) == is_lathe(to)) {
    ToolOffset same = offset;
    if (!has(to, SetupNeeds::corner_radius)) same.corner = same.corner_wear = 0;
    return same;
  }
  ToolOffset sum;
  sum.length = offset.whole_length(), sum.radius = offset.whole_radius();
  sum.length_x = offset.length_x + offset.length_x_wear, sum.length_y = offset.length_y + offset.length_y_wear;
  const bool mirrors = from.has_parameter_file() != to.has_parameter_file();
  const auto x = setup.diameter.find("X");
  if (turning_length_code(to) != nullptr) sum.length_x *= 2;
  if (turning_length_code(from) != nullptr && x != setup.diameter.end() && x->second) sum.length_x /= 2;
  sum.tip_position = mirrors ? mirrored_tip(offset.tip_position) : offset.tip_position;
  return sum;
}

bool has_systems(const ControlDef& def) { return std::any_of(def.codes.begin(), def.codes.end(), is_system); }

/// The axes that the target machine has. Filters tables by the names of these axes.
class KnownAxes {
 public:
  KnownAxes(const ControlDef& to, const std::vector<std::string>& axes) : names_(axes.empty() ? to.axes : axes) {}
  AxisValues of(const AxisValues& all) const {
    AxisValues known;
    for (const auto& [axis, value] : all)
      if (std::find(names_.begin(), names_.end(), axis) != names_.end()) known[axis] = value;
    return known;
  }

 private:
  std::vector<std::string> names_;
};

/// Returns the axes that the program needs, if set-ups of the target control list the axes of the machine; else an empty list.
std::vector<std::string> axes_for(const Setup& setup, const ControlDef& from, const ControlDef& to, const ProgramNames& names) {
  if (!to.machine_axes()) return {};
  if (from.machine_axes() && (is_lathe(from) || !is_lathe(to) || !setup.axes.empty())) return setup.axes;
  std::vector<std::string> axes = {"X", "Z"};
  if (!is_lathe(to)) axes.insert(axes.begin() + 1, "Y");
  for (const std::string& axis : from.axes)
    if (axis.size() == 1 && (names.letters >> (axis.front() - 'A') & 1U) != 0 && std::find(axes.begin(), axes.end(), axis) == axes.end())
      axes.push_back(axis);
  return axes.size() > 3 || is_lathe(to) ? axes : std::vector<std::string>();
}

/// Returns what the set-up of the target control may state of an axis.
AxisLimits limits_there(const AxisLimits& limits, const ControlDef& to) {
  AxisLimits there = limits;
  if (!to.machine_axes()) there.zone3.reset(), there.switches.reset(), there.apart.reset(), there.position_error = 0;
  return there;
}

/// Copies the spindles into the new set-up. If the target control's set-up describes its spindles, all are copied; otherwise only speed and
/// direction of the main spindle.
void take_spindles(Setup& made, const Setup& setup, const ControlDef& from, const ControlDef& to) {
  if (to.machine_axes() && from.machine_axes()) made.spindles = setup.spindles;
  const auto main = setup.spindles.find(1);
  if (made.spindles.empty() && main != setup.spindles.end() && main->second.rpm != 0) {
    SpindleSetup& one = made.spindles[1];
    one.rpm = main->second.rpm, one.dir = main->second.dir;
  }
}

void take_tables(Setup& made, const Setup& setup, const ControlDef& from, const ControlDef& to, const KnownAxes& axes,
                 const ProgramNames& names) {
  const SetupNamesOf known(&to, to.axes, to.axes);
  for (const auto& [number, offset] : setup.offsets)
    if (allows_key(to, "offsets") && known.allows(SetupNames::offset, std::to_string(number)))
      made.offsets[number] = offset_there(offset, setup, from, to);
  // M6 and G43 look the tool up in a tool table, so each offset needs a row there (spec/linuxcnc 5)
  if (to.has_parameter_file() && !made.offsets.empty())
    for (const std::uint32_t tool : names.tools)
      if (known.allows(SetupNames::offset, std::to_string(tool))) made.offsets.emplace(static_cast<int>(tool), ToolOffset{});
  const VariableNumbers numbers(from, to);
  if (allows_key(to, "variables"))
    for (const auto& [name, value] : setup.variables)
      if (const auto there = numbers.given(name); there && known.allows(SetupNames::variable, *there)) made.variables[*there] = value;
  const std::map<int, AxisValues> zeros = zeros_of(setup, from);
  if (allows_key(to, "zeros")) {
    for (const auto& [number, values] : zeros)
      if (known.allows(SetupNames::zero, std::to_string(number))) made.zeros[number] = axes.of(values);
    return;
  }
  for (const WorkSystem& system : work_systems(to))
    if (const auto found = zeros.find(static_cast<int>(system.row)); found != zeros.end() && system.works)
      made.work_offsets[system.name] = axes.of(found->second);
}

}  // namespace

bool is_lathe(const ControlDef& def) { return def.behaviour.lathe != Lathe::none; }

bool turns(const ControlDef& from, const ControlDef& to) { return is_lathe(from) || is_lathe(to); }

const CodeRow* turning_length_code(const ControlDef& def) {
  constexpr int turning = 437;
  const bool has_table = std::any_of(def.parameters.begin(), def.parameters.end(),
                                     [](const ParameterRow& row) { return row.name == turning_table_bit().name; });
  return is_lathe(def) || !has_table ? nullptr : row_that_does(def, {{Function::length_comp, turning}});
}

bool wears_alike(const ControlDef& from, const ControlDef& to) { return is_lathe(to) && from.behaviour.lathe == to.behaviour.lathe; }

bool allows_key(const ControlDef& def, const char* key) {
  const SetupKey& row = *setup_key(key);
  // The names in a table depend on the control, so that its example may be wrong there.
  const nlohmann::json value = row.form == SetupForm::table ? nlohmann::json::object() : json_of(row.example);
  const nlohmann::json table = {{key, value}};
  return !fault_of(table, table, &def);
}

OffsetsInForce offsets_of(const Control& control, const ControlDef& def) {
  OffsetsInForce now;
  const auto number_in = [](const std::string& word) { return std::uint32_t(std::strtoul(word.c_str() + 1, nullptr, 10)); };
  // The words D and H in force are read from state_now(), not from in_force(), which also returns the variables, of which there may be
  // thousands.
  for (const std::string& word : control.state_now().modal) {
    if (word.front() == 'D') now.radius_number = number_in(word);
    if (word.front() == 'H') now.length_number = number_in(word);
    if (word == "G43" || word == "G44" || word == "G43.7") now.length_sign = word == "G44" ? -1 : 1;
  }
  if (now.length_number == 0) now.length_number = now.radius_number;
  if (def.grammar.klartext_blocks) {  // TOOL CALL puts length and radius of its tool into force (spec/heidenhain 2.4)
    now.length_number = now.radius_number = control.state_now().tool;
    now.length_sign = now.length_number != 0 ? 1 : 0;
  }
  if (is_lathe(def)) now.length_sign = now.length_number != 0 ? 1 : 0;  // the T word puts the offset into force
  return now;
}

FlatSource flat_source_of(const Session& session, const ControlDef& to) {
  FlatSource source{session.control().axes(), {}, has_systems(session.def()), shows_same_messages(session.def(), to)};
  source.systems = system_names(to);
  source.turns = turns(session.def(), to);
  const auto has_thread = [](const ControlDef& def) { return row_that_does(def, {{Function::thread, 0}}) != nullptr; };
  source.same_threads = has_thread(session.def()) && has_thread(to);
  source.turning_length = is_lathe(session.def()) ? turning_length_code(to) : nullptr;
  const bool has_diameters = row_that_does(to, {{Function::diameter_mode, 1}}) != nullptr || turning_length_code(to) != nullptr;
  source.diameters = is_lathe(to) || (is_lathe(session.def()) && has_diameters);
  const MachineCodes codes(session.def(), to);
  for (const auto& [here, there] : codes.pairs()) {
    source.machine_codes[here] = there;
    const CodeRow* const row = machine_row(session.def(), here);
    constexpr Function coolants[] = {Function::coolant_off, Function::coolant_mist, Function::coolant_flood};
    for (std::size_t i = 0; i < std::size(coolants); ++i)
      if (row != nullptr && row->function == coolants[i]) source.coolants[i] = there;
  }
  for (const auto& [number, values] : zeros_of(session.setup(), session.def()))
    for (std::size_t a = 0; a < source.axes.size() && a < max_axes; ++a)
      if (const auto found = values.find(source.axes[a]); found != values.end()) source.zeros[number][a] = found->second;
  return source;
}

bool changes_tools(const ControlDef& def) {
  return is_lathe(def) || def.grammar.klartext_blocks ||
         row_that_does(
             def, {{Function::change_tool, any_argument}, {Function::exchange_tool, any_argument}, {Function::load_tool, any_argument}}) !=
             nullptr;
}

bool probe_elsewhere(Setup& setup) {
  constexpr double apart = 0.0937;  // distance by which the probed surface is shifted, mm
  for (auto& [input, at] : setup.probe)
    if (at)
      for (auto& [axis, value] : *at) value += apart;
  if (setup.probe_hole) setup.probe_hole->center_x += apart, setup.probe_hole->center_y -= apart, setup.probe_hole->diameter += apart;
  return !setup.probe.empty() || setup.probe_hole;
}

bool shows_same_messages(const ControlDef& from, const ControlDef& to) {
  const auto kind = [](const ControlDef& def) { return def.grammar.has_statements() ? 1 : def.grammar.expressions ? 2 : 0; };
  return kind(from) == kind(to) && kind(from) != 0;
}

namespace {

/// True if the control passes M1 to its machine, which reads the optional-stop switch itself. The control then reports M1 whether the
/// switch is on or off.
bool reports_optional_stops(const ControlDef& def) {
  return std::any_of(def.codes.begin(), def.codes.end(),
                     [](const CodeRow& row) { return row.function == Function::optional_stop && row.arg == 1; });
}

}  // namespace

Setup corresponding_setup(const Setup& setup, const ControlDef& from, const ControlDef& to, const ProgramNames& names, bool plain) {
  Setup made;
  made.axes = axes_for(setup, from, to, names);
  if (is_lathe(from) && turning_length_code(to) != nullptr) {
    if (made.axes.empty()) made.axes = {"X", "Z"};
    made.diameter["X"] = true;
    made.parameters[turning_table_bit()] = 1.0;
  }
  const KnownAxes axes(to, made.axes);
  made.start = axes.of(setup.start), made.start_in_work = setup.start_in_work;
  for (const auto& [axis, limits] : setup.machine)
    if (axis == "*" || !axes.of({{axis, 0}}).empty()) made.machine[axis] = limits_there(limits, to);
  made.axis_limits = setup.axis_limits;
  made.skip = setup.skip, made.optional_stop = setup.optional_stop || reports_optional_stops(from);
  take_spindles(made, setup, from, to);
  made.feed_override = setup.feed_override, made.rapid_override = setup.rapid_override, made.spindle_override = setup.spindle_override;
  made.tool = setup.tool;
  if (allows_key(to, "clock")) made.clock = setup.clock;
  if (has(to, SetupNeeds::turning)) made.chuck_face = setup.chuck_face, made.tailstock = setup.tailstock;
  if (allows_key(to, "probe")) made.probe = setup.probe, made.probe_hole = setup.probe_hole;
  // Default of Grbl's $30, the greatest spindle speed in rev/min, to which a higher S is reduced (spec/grbl 8)
  constexpr double usual_speed = 1000;
  if (to.has_lines_alone() && names.most_speed > usual_speed) made.parameters[{"0030", "", ""}] = names.most_speed;
  if (allows_key(to, "reference_points"))
    for (const auto& [point, values] : setup.reference_points) made.reference_points[point] = axes.of(values);
  if (!plain) take_tables(made, setup, from, to, axes, names);
  return made;
}

namespace {

void put_probe(nlohmann::ordered_json& all, const Setup& setup) {
  for (const auto& [input, at] : setup.probe) {
    nlohmann::ordered_json& one = all["probe"][std::to_string(input)];
    if (at)
      for (const auto& [axis, value] : *at) one[axis] = value;
  }
  if (!setup.probe_hole) return;
  const ProbeHole& hole = *setup.probe_hole;
  all["probe_workpiece"] = {
      {"tip_radius", hole.tip_radius},
      {"hole",
       {{"center", {{"X", hole.center_x}, {"Y", hole.center_y}}}, {"diameter", hole.diameter}, {"top", hole.top}, {"depth", hole.depth}}}};
}

using Json = nlohmann::ordered_json;

void put_span(Json& to, const char* key, const std::optional<std::pair<double, double>>& span) {
  if (span) to[key] = {span->first, span->second};
}

void put_limits(Json& to, const AxisLimits& limits) {
  to = Json::object();
  if (limits.rapid) to["rapid"] = *limits.rapid;
  put_span(to, "limits", limits.limits);
  put_span(to, "zone3", limits.zone3);
  put_span(to, "switches", limits.switches);
  if (limits.apart) to["apart"] = *limits.apart;
  if (limits.no_acceleration) to["acceleration"] = nullptr;
  else if (limits.acceleration) to["acceleration"] = *limits.acceleration;
  if (limits.jerk_time) to["jerk_time"] = *limits.jerk_time;
  if (limits.position_error != 0) to["position_error"] = limits.position_error;
}

void put_spindle(Json& to, const SpindleSetup& spindle) {
  const SpindleSetup usual;
  to = Json::object();
  if (!spindle.name.empty()) to["name"] = spindle.name;
  if (spindle.channel != usual.channel) to["channel"] = spindle.channel;
  if (spindle.rpm != usual.rpm) to["rpm"] = spindle.rpm;
  if (spindle.dir != usual.dir) to["dir"] = spindle.dir;
  if (spindle.angle) to["angle"] = *spindle.angle;
  for (const auto& [least, most] : spindle.ranges) to["ranges"].push_back({least, most});
  if (spindle.loop != usual.loop) to["loop"] = spindle.loop;
  if (spindle.surface_speed != usual.surface_speed) to["surface_speed"] = spindle.surface_speed;
  if (spindle.css_axis != usual.css_axis) to["css_axis"] = spindle.css_axis;
  if (spindle.master != usual.master) to["master"] = spindle.master;
}

void put_overrides(Json& all, const Setup& setup) {
  for (const auto& [name, percent] :
       {std::pair{"feed", setup.feed_override}, {"rapid", setup.rapid_override}, {"spindle", setup.spindle_override}})
    if (percent != 100) all["override"][name] = percent;
}

}  // namespace

std::string setup_text(const Setup& setup) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  const auto put_axes = [](nlohmann::ordered_json& to, const AxisValues& values) {
    to = nlohmann::ordered_json::object();
    for (const auto& [axis, value] : values) to[axis] = value;
  };
  if (!setup.axes.empty()) all["axes"] = setup.axes;
  if (!setup.start.empty()) put_axes(all["start"], setup.start);
  if (setup.start_in_work) all["start_frame"] = "work";
  for (const auto& [name, values] : setup.work_offsets) put_axes(all["work_offsets"][name], values);
  for (const auto& [number, values] : setup.zeros) put_axes(all["zeros"][std::to_string(number)], values);
  for (const auto& [number, values] : setup.reference_points) put_axes(all["reference_points"][std::to_string(number)], values);
  for (const auto& [number, offset] : setup.offsets) {
    nlohmann::ordered_json& row = all["offsets"][std::to_string(number)];
    row = nlohmann::ordered_json::object();
    for (const auto& [name, value] : {std::pair{"length", offset.length},
                                      {"length_wear", offset.length_wear},
                                      {"radius", offset.radius},
                                      {"radius_wear", offset.radius_wear},
                                      {"corner_radius", offset.corner},
                                      {"corner_radius_wear", offset.corner_wear},
                                      {"length_x", offset.length_x},
                                      {"length_x_wear", offset.length_x_wear},
                                      {"length_y", offset.length_y},
                                      {"length_y_wear", offset.length_y_wear},
                                      {"tip_position", offset.tip_position}})
      if (value != 0) row[name] = value;
  }
  for (const auto& [name, value] : setup.variables)
    all["variables"][name] = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  for (const auto& [key, value] : setup.parameters)
    if (const double* const number = std::get_if<double>(&value)) all["parameters"][text_of(key)] = *number;
  for (const auto& [axis, on] : setup.diameter) all["diameter"][axis] = on;
  put_probe(all, setup);
  for (const auto& [axis, limits] : setup.machine) put_limits(all["machine"][axis], limits);
  for (const auto& [number, spindle] : setup.spindles) put_spindle(all["spindle"][std::to_string(number)], spindle);
  put_overrides(all, setup);
  if (!setup.clock.empty()) all["clock"] = setup.clock;
  if (setup.chuck_face) all["chuck_face"] = *setup.chuck_face;
  if (setup.tailstock) all["tailstock"] = *setup.tailstock;
  if (setup.tool != 0) all["tool"] = setup.tool;
  if (!setup.skip.empty()) all["skip"] = setup.skip;
  if (setup.optional_stop) all["optional_stop"] = true;
  return json_text(all, 1) + "\n";
}

}  // namespace kadr
