#pragma once
// Draws the picture of `kadr run --plot-speed`: speed along the path with the commanded feed, and how near the axes are to their
// acceleration and jerk limits, over the time of the planner of least time.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "motion/time/speed_record.h"
#include "out/picture/plot.h"

namespace kadr {

/// Draws the page; the ending of the file's name (.svg, .png) selects the format. `axes`: their names.
///   returns  an error sentence
tl::expected<void, std::string> draw_speed_page(const ResultFile& file, const SpeedRecord& record, const std::vector<std::string>& axes,
                                                const PlotTitle& title);

}  // namespace kadr
