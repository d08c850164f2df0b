#pragma once
// The part of a report: the remaining stock at the end, with as few triangles as display it well.

#include "view/part_run.h"
#include "view/report.h"

namespace kadr {

/// `run` has ended. Findings are not copied: they have been reported already.
void take_part(const PartRun& run, ReportPart& part, const StopToken& stop);

}  // namespace kadr
