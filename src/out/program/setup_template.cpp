// Writes set-ups as readable JSON with one line for each table row. This file is used by cli/setup_command and view/page/page_setup.

#include "out/program/setup_template.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/alarm_texts.h"
#include "config/json_text.h"

namespace kadr {
namespace {

constexpr double largest_whole = 1e15;  // greatest whole number that is written without an exponent

}  // namespace

std::string inline_text(const nlohmann::ordered_json& value) {
  if (value.is_number_float() && std::fabs(value.get<double>()) < largest_whole) return number_text(value.get<double>());
  if (!value.is_structured()) return json_text(value);
  std::string text;
  for (const auto& [key, one] : value.items()) {
    if (!text.empty()) text += ", ";
    if (value.is_object()) text += json_text(nlohmann::ordered_json(key)) + ": ";
    text += inline_text(one);
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

namespace {

using SetupJson = nlohmann::ordered_json;
using Cells = std::vector<std::pair<std::string, std::optional<double>>>;

/// True if the elements of the value are written on a line each: tables of rows, and lists of texts.
bool has_lines(const SetupJson& value) {
  if (!value.is_structured() || value.empty()) return false;
  return std::all_of(value.begin(), value.end(),
                     [&](const SetupJson& one) { return value.is_object() ? one.is_object() : one.is_string(); });
}

std::string value_text(const SetupJson& value) {
  if (!has_lines(value)) return inline_text(value);
  std::string text;
  for (const auto& [key, one] : value.items()) {
    text += text.empty() ? "    " : ",\n    ";
    if (value.is_object()) text += json_text(SetupJson(key)) + ": ";
    text += inline_text(one);
  }
  return (value.is_object() ? "{\n" : "[\n") + text + (value.is_object() ? "\n  }" : "\n  ]");
}

SetupJson cells_json(const Cells& cells) {
  SetupJson json = SetupJson::object();
  for (const auto& [key, value] : cells) json[key] = value ? SetupJson(*value) : SetupJson();
  return json;
}

SetupJson rows_json(const std::vector<SetupTemplate::Row>& rows) {
  SetupJson json = SetupJson::object();
  for (const SetupTemplate::Row& row : rows) json[row.name] = cells_json(row.cells);
  return json;
}

}  // namespace

std::string setup_text(const nlohmann::ordered_json& setup) {
  std::string text = "{\n";
  std::size_t left = setup.size();
  for (const auto& [key, value] : setup.items())
    text += "  " + json_text(SetupJson(key)) + ": " + value_text(value) + (--left > 0 ? ",\n" : "\n");
  return text + "}\n";
}

std::string template_text(const SetupTemplate& setup) {
  SetupJson json = SetupJson::object();
  if (!setup.offsets.empty()) json["offsets"] = rows_json(setup.offsets);
  if (!setup.work_offsets.empty()) json["work_offsets"] = rows_json(setup.work_offsets);
  if (!setup.zeros.empty()) json["zeros"] = rows_json(setup.zeros);
  if (!setup.correctors.empty()) json["correctors"] = cells_json(setup.correctors);
  if (!setup.variables.empty()) json["variables"] = cells_json(setup.variables);
  if (setup.has_skip) json["skip"] = SetupJson::array();
  if (setup.has_optional_stop) json["optional_stop"] = false;
  if (!setup.notes.empty()) json["notes"] = setup.notes;
  return setup_text(json);
}

}  // namespace kadr
