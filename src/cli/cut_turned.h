#pragma once
// kadr cut on a lathe's control: the part is cut exactly, as a body of revolution. This file is used by cli/cut.

#include "cli/job/drive.h"
#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/options/options.h"
#include "session/cutting/cutting.h"

namespace kadr::cli {

/// True if the part is cut exactly: the control is a lathe's, blank and fixtures are cylinders about X0 Y0, the machine has no [[bodies]],
/// and no option needs the lattice (--resolution, --window, --part, --deviation, --plot, --coolant).
bool cuts_turned(const CutOptions& options, const Job& job);

/// A program that has been opened, and everything that its cut needs.
struct TurnedCut {
  const CutOptions& options;
  const Job& job;
  const CutJob& cut;
  Session& session;
  Drive& drive;
  Outputs& outputs;
};

/// Cuts the part, prints what was found and writes the results. Returns the exit status.
int cut_turned(const TurnedCut& cut);

}  // namespace kadr::cli
