#pragma once
// Writes the meshes of kadr cut: --out, --simplify, --deviation. Used by cli/cut.

#include "cli/options.h"
#include "cli/outputs.h"
#include "session/cutting/cutting.h"
#include "stock/cut_result.h"
#include "stock/part/part_compare.h"
#include "stock/surface/surface.h"

namespace kadr::cli {

/// Returns whether the meshes can be written in the formats that their names ask for; complains if not.
bool can_write_meshes(const CutOptions& options);

/// Writes the meshes into the open files; complains on errors.
///   surface  what `cutting` has left, in its window if there is one
///   result   gets `simplified`
bool write_meshes(const CutOptions& options, const Outputs& outputs, const Surface& surface, const PartComparison& held,
                  const Cutting& cutting, CutResult& result);

}  // namespace kadr::cli
