#pragma once
// Loads what kadr cut needs according to its options: blank, fixtures, tools, target part. This file is used by cli/cut.

#include <optional>

#include "cli/job/job.h"
#include "cli/options/options.h"
#include "session/cutting/cutting.h"
#include "stock/mesh/mesh.h"

namespace kadr::cli {

/// Loads blank, fixtures and target part for a cut on the lattice. If an error occurs, it is printed and the function returns false.
bool find_cut_job(CutOptions& options, CutJob& job, const std::optional<Mesh>& part);

/// Reads the target part if --part names its file. If an error occurs, it is printed and the function returns false.
bool find_part(const CutOptions& options, std::optional<Mesh>& part);

/// Loads the tools, and the instant or line at which the cut ends. If an error occurs, it is printed and the function returns false.
///   options  `run.to` receives the line that --until names
bool find_tools_and_end(CutOptions& options, CutJob& job);

/// Finds the number of the work offset that --stock-zero names. If an error occurs, it is printed and the function returns false.
bool find_system(const CutOptions& options, const Job& job, std::optional<std::uint16_t>& system);

}  // namespace kadr::cli
