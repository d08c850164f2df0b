#pragma once
// Draws the picture of `kadr run --plot-speed`. One diagram shows the speed along the path with the commanded feed. Another diagram shows
// the axes' accelerations and jerks relative to their limits. The horizontal axis of both diagrams is the time that the least-time planner
// computes.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "motion/time/speed_record.h"
#include "out/picture/plot/plot.h"

namespace kadr {

/// Draws the page. The ending of the file's name (.svg, .png) selects the format. `axes`: the names of the axes.
///   returns  an error sentence if the page cannot be drawn
tl::expected<void, std::string> draw_speed_page(const ResultFile& file, const SpeedRecord& record, const std::vector<std::string>& axes,
                                                const PlotTitle& title);

}  // namespace kadr
