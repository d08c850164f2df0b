#pragma once
// Decides how kadr cut cuts: exactly, as a body of revolution, or on the lattice. Finds blank and tools where the user does not state them.
// For this purpose the program is executed once before the cut. This file is used by cli/cut.

#include "cli/job/job.h"
#include "config/tools/tool_library.h"
#include "stock/turned/turned_part.h"

namespace kadr::cli {

inline constexpr const char* guess_word = "guess";

struct CutPlan {
  bool turned = false;                   // true: the part is cut exactly, as a body of revolution
  std::optional<TurnedRegion> wanted{};  // the wanted part, if it is a body of revolution
};

/// Finds a blank if --stock is missing or `guess`, and tools if --tools is `guess`, and prints them. Decides how the part is cut. Prints an
/// error if no suitable ones are found.
///   options  `stock` receives the description of a solid, in the form in which a user types it
///   part     the wanted part; nullopt: none
///   tools    the tools of the tools file; if there is none, they receive the tools with which the program cuts
///   turned   blank and fixtures are bodies of revolution about X0 Y0, no option needs the lattice, and every tool that cuts is a turning
///            tool or is on the axis. On a lathe's control, motions that mill are left out if the lattice cannot cut them: the form of a
///            tool is known only from the offset table, or no kinematics is known of the C axis.
///   returns  nullopt if the program cuts nothing, if the shape of a tool is unknown, or if the program cannot be read twice
std::optional<CutPlan> plan_cut(CutOptions& options, const Job& job, const std::optional<Mesh>& part, ToolLibrary& tools);

}  // namespace kadr::cli
