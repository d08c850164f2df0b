#pragma once
// GrblSettings: what a controller of the Grbl family says of itself: version and buffers ($I), settings ($$), offsets ($#), modes ($G).

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drive/grbl/grbl_reply.h"

namespace kadr::drive {

struct GrblSettings {
  std::string version;                       // "1.1h.20190830:"
  std::map<int, double> values;              // settings by number: 110 → 500
  std::map<std::string, GrblPoint> offsets;  // "G54" … "G59", "G28", "G30", "G92", in the unit of reports
  double tool_length = 0;                    // TLO, in the unit of reports
  std::string modes;                         // "G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0"
  std::optional<int> planner_blocks;         // blocks of the planner, from [OPT:…]
  std::optional<int> buffer_bytes;           // bytes of the receive buffer, from [OPT:…]

  /// Returns a setting; `missing` if the controller did not state it.
  double value(int number, double missing) const {
    const auto found = values.find(number);
    return found == values.end() ? missing : found->second;
  }
  /// Stores the content of a line in square brackets. Returns false if the line is none of the answers to $I, $#, $G.
  bool take(const GrblBracket& bracket);
};

/// Reads a file with the answers to $$, $#, $G and $I, as a terminal program records them. Other lines are ignored.
GrblSettings grbl_settings_in(std::string_view text);

}  // namespace kadr::drive
