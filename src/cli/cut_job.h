#pragma once
// Finds what kadr cut needs from its options: blank, fixtures, tools, part. Used by cli/cut.

#include <optional>

#include "cli/job.h"
#include "cli/options.h"
#include "session/cutting/cutting.h"
#include "stock/mesh/mesh.h"

namespace kadr::cli {

/// Finds all that is not given by the program and its set-up; complains on errors.
///   options  --to gets the line of --until
///   part     gets the target part, if one is named
bool find_cut_job(CutOptions& options, CutJob& job, std::optional<Mesh>& part);

/// Finds the row of the work system that --stock-zero names; complains on errors.
bool find_system(const CutOptions& options, const Job& job, std::optional<std::uint16_t>& system);

}  // namespace kadr::cli
