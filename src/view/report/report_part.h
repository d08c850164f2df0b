#pragma once
// Prepares the stock for a report: the remaining stock at the end of the program, with as few triangles as a good picture needs.

#include "view/part_run.h"
#include "view/report/page_report.h"

namespace kadr {

/// Stores the surface of the stock and the result in `part`. `run` must have ended. Its findings are not stored, since they have been
/// reported already.
void take_part(const PartRun& run, ReportPart& part, const StopToken& stop);

}  // namespace kadr
