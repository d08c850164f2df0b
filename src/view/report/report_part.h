#pragma once
// Prepares the stock for a report: the remaining stock at the end of the program, with as few triangles as a good picture needs.

#include "view/part_run.h"
#include "view/report/page_report.h"

namespace kadr {

/// Sets the stock and the result in `part`. The run must have ended. Its findings are not copied, since they have been reported already.
void take_part(const PartRun& run, ReportPart& part, const StopToken& stop);

}  // namespace kadr
