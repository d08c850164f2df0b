#pragma once
// JobLine: one line of a job for a controller of the Grbl family, with everything that Kadr knows of it: what it moves, how long it takes,
// and whether the controller must have finished the lines before it.

#include <cstdint>
#include <string>
#include <vector>

#include "drive/grbl/grbl_reply.h"

namespace kadr::drive {

/// How a line is sent.
enum class LineKind : std::uint8_t {
  plain,  // as soon as the receive buffer has space
  alone,  // after the answer to all lines before it, and nothing follows until it is answered: it writes the EEPROM, or it probes
  stop,   // not sent at all: the job stops here until the operator continues it (M0, M6)
};

struct JobLine {
  std::string text;          // what is sent, without the end of line; for a stop the source text
  std::uint32_t number = 0;  // number of the line in the program
  LineKind kind = LineKind::plain;
  double seconds = 0;           // how long the controller needs for it, s
  std::vector<GrblPoint> path;  // points of its path in machine coordinates, mm; empty: the line moves nothing
  bool probes = false;          // a probe motion
  bool changes_tool = false;    // a stop for a tool change
};

}  // namespace kadr::drive
