#pragma once
// Chooses the cell size of the stock's lattice and estimates the memory that the lattice needs, for the whole blank and for a window (a box
// that is cut again with finer cells). It also compares the result with the target part and measures volumes. It is used by cli/cut and
// view/part_run.

#include "session/cutting/cutting.h"
#include "stock/part/part_compare.h"
#include "stock/portion/joined_surface.h"
#include "stock/surface/surface.h"

namespace kadr {

/// Returns the memory that the meshes of blank and fixtures need, bytes.
double bytes_of_meshes(const CutJob& job);

/// Chooses the cell sizes of blank and window. `resolution` applies to the window if there is one, otherwise to the whole blank.
///   job         must contain the tools; if they are few, as for a single job, the cell size depends on the tools as well as on the blank
///   resolution  requested cell size, mm; 0: the cells are as small as is useful and as the memory allows
///   max_bytes   memory limit of the stock
///   returns     false if the window is outside the blank
bool find_cells(double resolution, const std::optional<Box3>& window, double max_bytes, CutJob& job);

/// Returns an upper bound of the memory of the stock, its lattice bricks and the meshes, bytes. `held`: the target part; nullptr: no part
/// is given.
double bytes_of_material(const CutJob& job, const Mesh* held);

/// True if the target part extends into the window. True also if there is no window.
bool part_meets_window(const CutJob& job, const Mesh& part);

/// Compares the remaining stock with the target part. If there is a window, only its inside is compared.
PartComparison compare_with_part(const CutJob& job, const Stock& stock, const Surface& surface, const Mesh& part);

/// Computes the results of the cut, including the volumes that the surfaces enclose. `whole`, `window`: surfaces of the remaining stock in
/// the whole blank and in the window; nullptr: no window.
CutResult cut_figures(const Cutting& cutting, const CutJob& job, const Surface& whole, const Surface* window);

/// Computes the same from the surface that portions have together. `cutting` has joined what they removed.
CutResult joined_figures(const Cutting& cutting, const CutJob& job, const JoinedSurface& whole);

/// Returns the lattice of the blank with the bricks that a process holds in memory.
Lattice held_bricks(const CutJob& job);

}  // namespace kadr
