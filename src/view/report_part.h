#pragma once
// The part of a report: what is left at the end, as few triangles as show it.

#include "view/part_run.h"
#include "view/report.h"

namespace kadr {

/// `run` is over. Findings are not taken: they have been told.
void take_part(const PartRun& run, ReportPart& part, const StopToken& stop);

}  // namespace kadr
