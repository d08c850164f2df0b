#pragma once
// Loads what kadr cut needs from its options: blank, fixtures, tools, target part. Used by cli/cut.

#include <optional>

#include "cli/job/job.h"
#include "cli/options/options.h"
#include "session/cutting/cutting.h"
#include "stock/mesh/mesh.h"

namespace kadr::cli {

/// Loads everything that does not come from the program and its set-up; prints errors.
///   options  `run.to` is set to the line that --until names
///   part     is set to the target part if --part names one
bool find_cut_job(CutOptions& options, CutJob& job, std::optional<Mesh>& part);

/// Finds the number of the work system that --stock-zero names; prints errors.
bool find_system(const CutOptions& options, const Job& job, std::optional<std::uint16_t>& system);

}  // namespace kadr::cli
