#pragma once
// Loads what kadr cut needs according to its options: blank, fixtures, tools, target part. This file is used by cli/cut.

#include <optional>

#include "cli/job/job.h"
#include "cli/options/options.h"
#include "session/cutting/cutting.h"
#include "stock/mesh/mesh.h"

namespace kadr::cli {

/// Loads everything that does not come from the program and its set-up. If an error occurs, it is printed and the function returns false.
///   options  `run.to` receives the line that --until names
///   part     receives the target part if --part names its file
bool find_cut_job(CutOptions& options, CutJob& job, std::optional<Mesh>& part);

/// Loads only the tools, and the instant or line at which the cut ends. If an error occurs, it is printed and the function returns false.
bool find_tools_and_end(CutOptions& options, CutJob& job);

/// Finds the number of the work offset that --stock-zero names. If an error occurs, it is printed and the function returns false.
bool find_system(const CutOptions& options, const Job& job, std::optional<std::uint16_t>& system);

}  // namespace kadr::cli
