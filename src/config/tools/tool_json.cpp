// Reads tool libraries in JSON: CAMotics, FreeCAD, Fusion. Used by config/tools/tool_library; tested by tests/config/tool_library_test.cpp.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/units.h"
#include "base/vec.h"
#include "config/json_scan.h"
#include "config/json_text.h"
#include "config/nearest.h"
#include "config/tools/tool_formats.h"
#include "texts/tool_formats.h"

namespace kadr {
namespace {

using nlohmann::json;
using Failed = tl::unexpected<std::string>;

tl::expected<json, std::string> parsed_json(std::string_view text, const std::string& file) {
  if (const std::string fault = json_fault_message(text, file); !fault.empty()) return Failed(fault);
  json value = json_of(text);
  if (value.is_discarded() || !value.is_object()) return Failed(file + ": " + translated(texts::tool_formats::no_json_object));
  return value;
}

/// Returns the member `key` of an object; an empty value if the object does not have it.
const json& part(const json& of, const char* key) {
  static const json none;
  if (!of.is_object()) return none;
  const auto found = of.find(key);
  return found == of.end() ? none : *found;
}

std::string word_of(const json& value) { return value.is_string() ? value.get<std::string>() : std::string(); }

/// Returns a length or an angle that is stated as a number, or as a text with unit: "5.000 mm", "0.25 in", "60.00 °".
double amount(const json& value, double unit) {
  if (value.is_number()) return value.get<double>() * unit;
  if (!value.is_string()) return 0;
  const std::string text = value.get<std::string>();
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc()) return 0;
  const std::string_view rest(read.ptr, std::size_t(text.data() + text.size() - read.ptr));
  return number * (rest.find("in") != std::string_view::npos || rest.find('"') != std::string_view::npos ? mm_per_inch : 1);
}

/// Adds the tool to the library if its shape is valid; else adds a note with the reason why the tool is left out.
void take(ToolLibrary& library, ToolGeometry tool, const std::string& file, const std::string& shape) {
  complete(tool);
  const std::string fault = tool_fault_message(tool);
  if (fault.empty() && library.tools.size() < limits::tools) return library.tools.push_back(std::move(tool));
  library.notes.push_back(file + ": " + translated(texts::tool_formats::left_out, tool.number, shape, fault));
}

void leave_out(ToolLibrary& library, std::uint32_t number, const std::string& file, const std::string& shape) {
  library.notes.push_back(file + ": " + translated(texts::tool_formats::unknown_form, number, shape));
}

tl::expected<ToolLibrary, std::string> not_empty(ToolLibrary library, const std::string& file) {
  if (!library.tools.empty()) return library;
  return Failed(library.notes.empty() ? file + ": " + translated(texts::tool_formats::no_tools) : library.notes.front());
}

/// Returns the number of teeth, which may also be a text such as "2"; 0 if the value is no valid number of teeth.
int teeth_in(const json& value) {
  const double teeth = amount(value, 1);
  return teeth >= 1 && teeth <= limits::teeth && teeth == std::floor(teeth) ? int(teeth) : 0;
}

double degrees(double radians) { return radians / rad_per_deg; }

/// Returns the outline of an ellipsoid of revolution with this diameter and length.
std::vector<ProfilePoint> spheroid(double diameter, double length) {
  constexpr int steps = 64;
  std::vector<ProfilePoint> outline;
  for (int i = 0; i <= steps; ++i) {
    const double angle = pi * i / steps;
    outline.push_back({diameter * std::sin(angle), length * (1 - std::cos(angle)) / 2});
  }
  return outline;
}

bool camotics_shape(ToolGeometry& tool, const std::string& shape, double snub) {
  const double half = tool.diameter / 2;
  if (shape == "cylindrical") tool.kind = ToolKind::flat;
  else if (shape == "ballnose") tool.kind = ToolKind::ball;
  else if (shape == "conical" || shape == "snubnose") {
    tool.kind = ToolKind::chamfer;
    tool.tip = shape == "conical" ? 0 : snub;
    tool.angle = 2 * degrees(std::atan2(half - tool.tip / 2, tool.length));
  } else if (shape == "spheroid") {
    tool.kind = ToolKind::form;
    tool.profile = spheroid(tool.diameter, tool.length);
  } else {
    return false;
  }
  return true;
}

bool mentions_any(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return text.find(w) != std::string::npos; });
}

/// Recognises a shape by its name in FreeCAD, such as endmill.fcstd or endmill.
bool freecad_shape(ToolGeometry& tool, const std::string& shape, const json& sizes) {
  const double full = amount(part(sizes, "CuttingEdgeAngle"), 1);
  if (mentions_any(shape, {"ballend"})) tool.kind = ToolKind::ball;
  else if (mentions_any(shape, {"bullnose", "torus", "radius"})) {
    tool.kind = ToolKind::bull;
    tool.corner = amount(part(sizes, "CornerRadius"), 1);
    if (tool.corner == 0) tool.corner = (tool.diameter - 2 * amount(part(sizes, "FlatRadius"), 1)) / 2;
  } else if (mentions_any(shape, {"chamfer", "v-bit", "vbit"})) {
    tool.kind = ToolKind::chamfer;
    tool.angle = full;
    tool.tip = amount(part(sizes, "TipDiameter"), 1);
  } else if (mentions_any(shape, {"drill"})) {
    tool.kind = ToolKind::drill;
    tool.angle = amount(part(sizes, "TipAngle"), 1);
  } else if (mentions_any(shape, {"slittingsaw"})) {
    tool.kind = ToolKind::tslot;
    tool.flutes = amount(part(sizes, "BladeThickness"), 1);
  } else if (mentions_any(shape, {"endmill", "reamer"})) {
    tool.kind = ToolKind::flat;
  } else {
    return false;
  }
  return true;
}

bool fusion_shape(ToolGeometry& tool, const std::string& type, const json& sizes, double unit) {
  const auto length = [&](const char* key) { return amount(part(sizes, key), unit); };
  if (mentions_any(type, {"ball"})) tool.kind = ToolKind::ball;
  else if (mentions_any(type, {"bull nose"})) tool.kind = ToolKind::bull, tool.corner = length("RE");
  else if (mentions_any(type, {"drill"})) tool.kind = ToolKind::drill, tool.angle = amount(part(sizes, "SIG"), 1);
  else if (mentions_any(type, {"counter sink", "countersink"})) tool.kind = ToolKind::chamfer, tool.angle = amount(part(sizes, "SIG"), 1);
  else if (mentions_any(type, {"chamfer mill"})) {
    tool.kind = ToolKind::chamfer;
    tool.angle = 2 * amount(part(sizes, "TA"), 1);
    tool.tip = length("tip-diameter");
    // The diameter DC of a tapered mill is the diameter at its tip. Kadr supports tapered mills only without corner radius
  } else if (mentions_any(type, {"tapered mill"})) {
    if (length("RE") > 0) return false;
    tool.kind = ToolKind::taper;
    tool.angle = amount(part(sizes, "TA"), 1);
    tool.diameter += 2 * tool.flutes * std::tan(tool.angle * rad_per_deg);
  } else if (mentions_any(type, {"flat end", "face mill", "reamer", "counter bore"})) tool.kind = ToolKind::flat;
  else if (mentions_any(type, {"slot mill"})) tool.kind = ToolKind::tslot;
  else return false;
  return true;
}

/// Reads the segments of an outline from the lowest upwards: {"height", "lower-diameter", "upper-diameter"}.
std::vector<ProfilePoint> segments_of(const json& body, double unit, double from) {
  std::vector<ProfilePoint> outline;
  double height = from;
  for (const json& s : part(body, "segments")) {
    if (outline.size() + 2 > limits::outline_points) break;
    const double tall = amount(part(s, "height"), unit);
    outline.push_back({amount(part(s, "lower-diameter"), unit), height});
    outline.push_back({amount(part(s, "upper-diameter"), unit), height + tall});
    height += std::max(tall, 0.0);
  }
  return outline;
}

std::optional<std::uint32_t> number_in(const std::string& text) {
  std::uint32_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

tl::expected<ToolLibrary, std::string> tools_of_camotics(std::string_view text, const std::string& file) {
  const auto root = parsed_json(text, file);
  if (!root) return Failed(root.error());
  ToolLibrary library;
  const json& tools = part(*root, "tools").is_object() ? part(*root, "tools") : *root;
  for (const auto& [key, row] : tools.items()) {
    const auto number = number_in(key);
    if (!number || !row.is_object()) continue;
    ToolGeometry tool;
    tool.number = *number;
    tool.name = word_of(part(row, "description"));
    const double unit = in_small_letters(word_of(part(row, "units"))) == "imperial" ? mm_per_inch : 1;
    tool.diameter = amount(part(row, "diameter"), unit);
    tool.length = tool.flutes = amount(part(row, "length"), unit);
    const std::string shape = in_small_letters(word_of(part(row, "shape")));
    if (camotics_shape(tool, shape, amount(part(row, "snub_diameter"), unit))) take(library, tool, file, shape);
    else leave_out(library, tool.number, file, shape);
  }
  return not_empty(std::move(library), file);
}

/// Reads a single tool, which has no number. ToolLibrary::find() returns this tool for every number that a program states.
tl::expected<ToolLibrary, std::string> tools_of_freecad(std::string_view text, const std::string& file) {
  const auto root = parsed_json(text, file);
  if (!root) return Failed(root.error());
  ToolLibrary library;
  const json& sizes = part(*root, "parameter");
  ToolGeometry tool;
  tool.name = word_of(part(*root, "name"));
  tool.diameter = amount(part(sizes, "Diameter"), 1);
  tool.flutes = amount(part(sizes, "CuttingEdgeHeight"), 1);
  tool.length = amount(part(sizes, "Length"), 1);
  tool.teeth = teeth_in(part(sizes, "Flutes"));
  const std::string shape = in_small_letters(word_of(part(*root, "shape")));
  if (!freecad_shape(tool, shape, sizes)) {
    leave_out(library, 0, file, shape);
    return not_empty(std::move(library), file);
  }
  if (const double shank = amount(part(sizes, "ShankDiameter"), 1); shank > 0 && tool.flutes > 0 && tool.length > tool.flutes)
    tool.shank = {{shank, tool.flutes}, {shank, tool.length}};
  take(library, tool, file, shape);
  return not_empty(std::move(library), file);
}

tl::expected<ToolLibrary, std::string> tools_of_fusion(std::string_view text, const std::string& file) {
  const auto root = parsed_json(text, file);
  if (!root) return Failed(root.error());
  ToolLibrary library;
  for (const json& row : part(*root, "data")) {
    const std::string type = in_small_letters(word_of(part(row, "type")));
    if (type == "holder" || type.empty()) continue;
    ToolGeometry tool;
    const json& number = part(part(row, "post-process"), "number");
    tool.number = number.is_number_unsigned() ? std::uint32_t(std::min<std::uint64_t>(number.get<std::uint64_t>(), 99'999'999)) : 0;
    tool.name = word_of(part(row, "description"));
    const double unit = in_small_letters(word_of(part(row, "unit"))) == "inches" ? mm_per_inch : 1;
    const json& sizes = part(row, "geometry");
    const auto length = [&](const char* key) { return amount(part(sizes, key), unit); };
    tool.diameter = length("DC");
    tool.flutes = length("LCF");
    tool.teeth = teeth_in(part(sizes, "NOF"));
    tool.length = length("LB") > 0 ? length("LB") : length("OAL");
    if (const double shaft = length("SFDM"); shaft > 0 && tool.flutes > 0 && tool.length > tool.flutes)
      tool.shank = {{shaft, tool.flutes}, {shaft, tool.length}};
    tool.holder = segments_of(part(row, "holder"), unit, 0);
    if (fusion_shape(tool, type, sizes, unit)) take(library, tool, file, type);
    else leave_out(library, tool.number, file, type);
  }
  return not_empty(std::move(library), file);
}

}  // namespace kadr
