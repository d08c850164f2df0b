#pragma once
// The state before the start (--setup FILE.json); the keys are defined in tests/golden/README.md.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace kadr {

using AxisValues = std::map<std::string, double>;  // axis name → mm or degrees

struct ToolOffset {
  double length = 0;  // mm, geometry and wear
  double radius = 0;
};

struct AxisLimits {
  std::optional<double> rapid;                      // mm/min
  std::optional<std::pair<double, double>> limits;  // machine mm
};

struct ProbeHole {
  double tip_radius = 0;
  double center_x = 0, center_y = 0;
  double diameter = 0, top = 0, depth = 0;
};

struct Setup {
  std::vector<std::string> axes;  // empty: the control's own
  AxisValues start;
  bool start_in_work = false;
  std::vector<std::string> modal;  // code words
  std::optional<double> feed;      // mm/min
  std::map<int, ToolOffset> offsets;
  std::map<std::string, AxisValues> work_offsets;  // "G54", "G59 P7", "common"
  std::map<int, AxisValues> zeros;
  std::map<int, double> correctors;
  std::map<std::string, std::optional<double>> variables;  // "#100", "R2"
  std::map<std::string, AxisLimits> machine;               // axis or "*"
  double spindle_rpm = 0;
  std::string spindle_dir = "stop";
  int tool = 0;
  std::vector<int> skip;  // switches that are on
  bool optional_stop = false;
  std::vector<std::string> mirror;                 // axes
  std::map<int, AxisValues> reference_points;      // machine
  std::map<int, std::optional<AxisValues>> probe;  // input → work position of the signal
  std::optional<ProbeHole> probe_hole;
  std::vector<double> points;
  std::vector<std::string> watch;
  double feed_override = 100, rapid_override = 100, spindle_override = 100;  // %
};

/// From JSON text.
///   returns  an error sentence naming the key that is unknown, of the wrong form, or not served yet
tl::expected<Setup, std::string> parse_setup(std::string_view json);
tl::expected<Setup, std::string> load_setup(const std::string& file);

}  // namespace kadr
