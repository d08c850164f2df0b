#pragma once
// Chooses the cell size of the stock's lattice and estimates the memory it needs, for the whole blank and for a window (a box that is cut
// again with finer cells). Compares the result with the wanted part and measures volumes. Used by cli/cut and view/part_run.

#include "session/cutting/cutting.h"
#include "stock/part/part_compare.h"
#include "stock/surface/surface.h"

namespace kadr {

/// Returns the bytes that the meshes of blank and fixtures need.
double bytes_of_meshes(const CutJob& job);

/// Chooses the cell sizes of blank and window. `resolution` applies to the window if there is one, else to the whole blank.
///   job         must contain the tools; if they are few, as for a single job, the cell size depends on the tools as well as on the blank
///   resolution  requested cell size, mm; 0: cells as small as is useful and fits into memory
///   max_bytes  memory limit of the stock
///   returns     false if the window is outside the blank
bool find_cells(double resolution, const std::optional<Box3>& window, double max_bytes, CutJob& job);

/// Upper bound of the memory of the stock, its lattice bricks and the meshes. `held`: the wanted part; nullptr: none.
double bytes_of_material(const CutJob& job, const Mesh* held);

/// True if the wanted part extends into the window, or if there is no window.
bool part_meets_window(const CutJob& job, const Mesh& part);

/// Compares the remaining stock with the wanted part; only inside the window if there is one.
PartComparison compare_with_part(const CutJob& job, const Stock& stock, const Surface& surface, const Mesh& part);

/// Computes the result with volumes enclosed by the surface. `window`: surface of the remaining stock in the window; nullptr: no window.
CutResult cut_figures(const Cutting& cutting, const CutJob& job, const Surface& whole, const Surface* window);

}  // namespace kadr
