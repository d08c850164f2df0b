#pragma once
// Prepares the stock for a report: the remaining stock at the end of the program, with no more triangles than a good picture needs.

#include "view/part_run.h"
#include "view/report/page_report.h"

namespace kadr {

/// Stores the surface of the stock, and the result of the cut, in `part`. `run` must have ended. The findings of the run are not stored,
/// because they have already been reported.
void take_part(const PartRun& run, ReportPart& part, const StopToken& stop);

}  // namespace kadr
