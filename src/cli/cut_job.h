#pragma once
// What kadr cut works with: blank, fixtures, tools, part, from its options. For cli/cut.

#include <optional>

#include "cli/job.h"
#include "cli/options.h"
#include "session/cutting/cutting.h"
#include "stock/mesh/mesh.h"

namespace kadr::cli {

/// All of it but what the program and its set-up say; complains.
///   options  gets the line of --until as that of --to
///   part     the one that is wanted, if one is
bool find_cut_job(CutOptions& options, CutJob& job, std::optional<Mesh>& part);

/// The row of the work system that --stock-zero names; complains.
bool find_system(const CutOptions& options, const Job& job, std::optional<std::uint16_t>& system);

}  // namespace kadr::cli
