// Writes a set-up for the user to complete, as readable JSON with one line for each table row. This file is used by cli/setup_command.

#include "out/program/setup_template.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "config/alarm_texts.h"

namespace kadr {
namespace {

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

std::string value_text(const std::optional<double>& value) { return value ? number_text(*value) : "null"; }

using Cells = std::vector<std::pair<std::string, std::optional<double>>>;

std::string cells_text(const Cells& cells) {
  std::string text;
  for (const auto& [key, value] : cells) text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", quoted(key), value_text(value));
  return "{" + text + "}";
}

std::string rows_text(const std::vector<SetupTemplate::Row>& rows) {
  std::string text;
  for (const SetupTemplate::Row& row : rows)
    text += fmt::format("{}    {}: {}", text.empty() ? "" : ",\n", quoted(row.name), cells_text(row.cells));
  return "{\n" + text + "\n  }";
}

}  // namespace

std::string template_text(const SetupTemplate& setup) {
  std::vector<std::string> parts;
  const auto table = [&](const char* key, const std::vector<SetupTemplate::Row>& rows) {
    if (!rows.empty()) parts.push_back(fmt::format("  \"{}\": {}", key, rows_text(rows)));
  };
  const auto list = [&](const char* key, const Cells& cells) {
    if (!cells.empty()) parts.push_back(fmt::format("  \"{}\": {}", key, cells_text(cells)));
  };
  table("offsets", setup.offsets);
  table("work_offsets", setup.work_offsets);
  table("zeros", setup.zeros);
  list("correctors", setup.correctors);
  list("variables", setup.variables);
  if (setup.has_skip) parts.emplace_back("  \"skip\": []");
  if (setup.has_optional_stop) parts.emplace_back("  \"optional_stop\": false");
  if (!setup.notes.empty()) {
    std::string notes;
    for (const std::string& note : setup.notes) notes += (notes.empty() ? "    " : ",\n    ") + quoted(note);
    parts.push_back(fmt::format("  \"notes\": [\n{}\n  ]", notes));
  }
  std::string text = "{\n";
  for (std::size_t i = 0; i < parts.size(); ++i) text += parts[i] + (i + 1 < parts.size() ? ",\n" : "\n");
  return text + "}\n";
}

}  // namespace kadr
