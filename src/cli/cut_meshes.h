#pragma once
// Writes the surface meshes of kadr cut: --out, --simplify, --deviation. Used by cli/cut.

#include "cli/job/outputs.h"
#include "cli/options/options.h"
#include "session/cutting/cutting.h"
#include "stock/cut_result.h"
#include "stock/part/part_compare.h"
#include "stock/surface/surface.h"

namespace kadr::cli {

/// Returns true if the meshes can be written in the formats that the file names select; prints an error if not.
bool can_write_meshes(const CutOptions& options);

/// Writes the meshes into the open files; prints errors.
///   surface  surface of the part after the cut; of its window, if --window names one
///   result   its member `simplified` is set
bool write_meshes(const CutOptions& options, const Outputs& outputs, const Surface& surface, const PartComparison& held,
                  const Cutting& cutting, CutResult& result);

}  // namespace kadr::cli
