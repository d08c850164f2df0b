#pragma once
// A set-up to be filled in, as JSON that people read: a row of a table a line.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kadr {

/// What `kadr setup` writes. A value that nobody knows yet is null: as if it were not stated.
struct SetupTemplate {
  struct Row {
    std::string name;                                                  // "1", "G54"
    std::vector<std::pair<std::string, std::optional<double>>> cells;  // key → value
  };
  std::vector<Row> offsets, work_offsets, zeros;
  std::vector<std::pair<std::string, std::optional<double>>> correctors, variables;
  bool has_skip = false, has_optional_stop = false;
  std::vector<std::string> notes;
};

std::string template_text(const SetupTemplate& setup);

}  // namespace kadr
