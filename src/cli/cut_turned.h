#pragma once
// kadr cut of a turned part: it is cut exactly, as a body of revolution. This file is used by cli/cut.

#include "cli/cut_guess.h"
#include "cli/job/drive.h"
#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/options/options.h"
#include "session/cutting/machine_watch.h"

namespace kadr::cli {

/// True if the options permit an exact cut: blank and fixtures are cylinders about X0 Y0 (the blank may be `guess`), the wanted part, if
/// there is one, is a body of revolution, and no option needs the lattice (--resolution, --window, --deviation, --colour age or load).
bool can_turn(const CutOptions& options, const CutPlan& plan, bool has_part);

/// A program that has been opened, and everything that its cut needs.
struct TurnedCut {
  const CutOptions& options;
  const Job& job;
  const CutJob& cut;
  Session& session;
  Drive& drive;
  Outputs& outputs;
  const CutPlan& plan;
  MachineWatch* watch;  // the collision check of the machine's bodies; nullptr: the machine has none
};

/// Cuts the part, prints what was found and writes the results. Returns the exit status.
int cut_turned(const TurnedCut& cut);

}  // namespace kadr::cli
