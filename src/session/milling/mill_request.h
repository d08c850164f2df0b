#pragma once
// Translates a user's request for milling into a job of path/pocketing. The request comes from the command kadr mill or from a page.

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "path/pocketing/mill.h"

namespace kadr {

/// A request for milling. Lengths are in mm, angles in degrees, feeds in mm/min. A negative or empty value selects the default
/// (docs/commands/mill.md).
struct MillRequest {
  std::string task;  // what is milled: pocket, face or slot
  std::string scheme, direction, plunge = "ramp", stepover, mark;
  double tool_diameter = 0, depth = 0, pass = -1, allowance = 0, top = 0, clearance = 5, overrun = 2, angle = 0, ramp_angle = 3, width = -1;
  double feed = 300, plunge_feed = -1, speed = 0;
  std::vector<double> hole;  // X and Y (mm) of a drilled hole into which the tool plunges
  std::uint32_t tool = 0;
  bool coolant = false;
};

/// Checks the request and converts it to a complete job.
///   alarms  mill_value, mill_stepover
Result<area::Job> mill_job(const MillRequest& request);

/// True if the text is a valid name of a scheme, direction or plunge. The functions …_names() list the valid names.
bool is_scheme(std::string_view name);
bool is_direction(std::string_view name);
bool is_plunge(std::string_view name);
std::vector<std::string> scheme_names();
std::vector<std::string> direction_names();
std::vector<std::string> plunge_names();

/// Returns the name that the Russian source prints for a scheme, direction or plunge: СПИР, 1 ЗИГЗАГ; ПЧС; СПУСК.
std::string_view russian_name(area::Scheme scheme);
std::string_view russian_name(area::Direction direction);
std::string_view russian_name(area::Plunge plunge);

}  // namespace kadr
