#pragma once
// The meshes that kadr cut writes: --out, --simplify, --deviation. For cli/cut.

#include "cli/options.h"
#include "cli/outputs.h"
#include "session/cutting/cutting.h"
#include "stock/cut_result.h"
#include "stock/part/part_compare.h"
#include "stock/surface/surface.h"

namespace kadr::cli {

/// Whether they can be written in the form that their names ask for; complains.
bool can_write_meshes(const CutOptions& options);

/// Into the open files; complains.
///   surface  of what `cutting` has left, in its window if there is one
///   result   gets `simplified`
bool write_meshes(const CutOptions& options, const Outputs& outputs, const Surface& surface, const PartComparison& held,
                  const Cutting& cutting, CutResult& result);

}  // namespace kadr::cli
