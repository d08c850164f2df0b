#pragma once
// Draws the picture of `kadr run --plot-speed`. One diagram shows the speed along the path with the commanded feed, another how near the
// axes are to their acceleration and jerk limits; both over the time that the planner of least time computes.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "motion/time/speed_record.h"
#include "out/picture/plot/plot.h"

namespace kadr {

/// Draws the page; the ending of the file's name (.svg, .png) selects the format. `axes` are the names of the axes.
///   returns  an error sentence
tl::expected<void, std::string> draw_speed_page(const ResultFile& file, const SpeedRecord& record, const std::vector<std::string>& axes,
                                                const PlotTitle& title);

}  // namespace kadr
