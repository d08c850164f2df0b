#pragma once
// Writes set-ups as readable JSON with one line for each table row: one for the user to complete, or one that the page has changed.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace kadr {

/// The content that `kadr setup` writes. An unknown value is written as null, which has the same meaning as a missing key.
struct SetupTemplate {
  struct Row {
    std::string name;                                                  // name of the table row, e.g. "1", "G54"
    std::vector<std::pair<std::string, std::optional<double>>> cells;  // key → value
  };
  std::vector<Row> offsets, work_offsets, zeros;
  std::vector<std::pair<std::string, std::optional<double>>> correctors, variables;
  bool has_skip = false, has_optional_stop = false;
  std::vector<std::string> notes;
};

std::string template_text(const SetupTemplate& setup);

/// Writes a value of JSON, or of TOML if it is no table, on one line, with a space after each comma and colon.
std::string inline_text(const nlohmann::ordered_json& value);

/// Writes a set-up file: a line for each row of a table and for each note, a line for any other key.
///   setup  an object; its keys are written in their order
std::string setup_text(const nlohmann::ordered_json& setup);

}  // namespace kadr
