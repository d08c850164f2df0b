#pragma once
// The picture of `kadr run --plot-speed`: speed along the path with the feed commanded, and how near the axes are to their acceleration
// and jerk, over the time of the planner of least time.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "motion/time/speed_record.h"
#include "out/picture/plot.h"

namespace kadr {

/// The ending of the name (.svg, .png) says which. `axes`: their names.
///   returns  an error sentence
tl::expected<void, std::string> draw_speed_page(const ResultFile& file, const SpeedRecord& record, const std::vector<std::string>& axes,
                                                const PlotTitle& title);

}  // namespace kadr
