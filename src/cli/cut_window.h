#pragma once
// The window of a cut: what of the blank is cut once more, finer; what a cut's volumes are with and without one. For cli/cut.

#include "cli/options.h"
#include "session/cutting/cutting.h"
#include "stock/part/part_compare.h"
#include "stock/surface/surface.h"

namespace kadr::cli {

/// The window that --window names, and both cells: --resolution is that of the window, or of the whole where there is none. Complains.
///   most_bytes  that the material may take
bool find_cells(const CutOptions& options, double most_bytes, CutJob& job);

/// What the material takes at most, bricks and meshes; `held`: the part that is wanted, if one is.
double bytes_of_material(const CutJob& job, const Mesh* held);

/// Beside the part that is wanted there is nothing to compare; complains.
bool part_meets_window(const CutJob& job, const Mesh& part);

/// What was cut, in the window if there is one, against the part.
PartComparison hold_against(const CutJob& job, const Stock& stock, const Surface& surface, const Mesh& part);

/// Volumes by the surface; `window`: of what was cut there.
CutResult cut_figures(const Cutting& cutting, const CutJob& job, const Surface& whole, const Surface* window);

}  // namespace kadr::cli
