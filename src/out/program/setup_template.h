#pragma once
// Writes a set-up to be filled in, as JSON that people read: one line for each row of a table.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kadr {

/// The content that `kadr setup` writes. A value that is not known yet is null, which means the same as leaving it out.
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
