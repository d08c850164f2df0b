#pragma once
// How fine a job is cut, and what it takes: the whole, and a window that is cut once more, finer; what volumes are with and without one.
// For cli/cut and view/part_run.

#include "session/cutting/cutting.h"
#include "stock/part/part_compare.h"
#include "stock/surface/surface.h"

namespace kadr {

/// Bytes of the blank's and the fixtures' own meshes.
double bytes_of_meshes(const CutJob& job);

/// The cells of the whole and of its window: what is asked for is that of the window, or of the whole where there is none.
///   job         its tools are there: a few, which is what one job has, decide with the blank how fine that is
///   resolution  mm; 0: as fine as is reasonable and fits
///   most_bytes  that the material may take
///   returns     false: the window lies beside the blank
bool find_cells(double resolution, const std::optional<Box3>& window, double most_bytes, CutJob& job);

/// What the material takes at most, bricks and meshes; `held`: the part that is wanted, if one is.
double bytes_of_material(const CutJob& job, const Mesh* held);

/// Some of the part that is wanted lies in the window, if there is one.
bool part_meets_window(const CutJob& job, const Mesh& part);

/// What was cut, in the window if there is one, against the part.
PartComparison hold_against(const CutJob& job, const Stock& stock, const Surface& surface, const Mesh& part);

/// Volumes by the surface; `window`: of what was cut there.
CutResult cut_figures(const Cutting& cutting, const CutJob& job, const Surface& whole, const Surface* window);

}  // namespace kadr
