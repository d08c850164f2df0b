#pragma once
// Chooses the cell size of a job and estimates its memory, for the whole and for a window that is cut again with finer cells; compares and
// measures the result. Used by cli/cut and view/part_run.

#include "session/cutting/cutting.h"
#include "stock/part/part_compare.h"
#include "stock/surface/surface.h"

namespace kadr {

/// Bytes of the meshes of blank and fixtures.
double bytes_of_meshes(const CutJob& job);

/// Chooses the cells of the whole and of its window. The requested resolution applies to the window, or to the whole if there is no window.
///   job         with its tools: if they are few enough for one job, they decide together with the blank
///   resolution  mm; 0: as fine as is reasonable and fits into memory
///   most_bytes  memory limit of the material
///   returns     false if the window is outside the blank
bool find_cells(double resolution, const std::optional<Box3>& window, double most_bytes, CutJob& job);

/// Upper bound of the memory of the material, bricks and meshes; `held`: the wanted part, if any.
double bytes_of_material(const CutJob& job, const Mesh* held);

/// True if the wanted part reaches into the window, or if there is no window.
bool part_meets_window(const CutJob& job, const Mesh& part);

/// Compares what was cut, inside the window if there is one, with the wanted part.
PartComparison hold_against(const CutJob& job, const Stock& stock, const Surface& surface, const Mesh& part);

/// Volumes by the surface; `window`: the surface of what was cut in the window, or nullptr.
CutResult cut_figures(const Cutting& cutting, const CutJob& job, const Surface& whole, const Surface* window);

}  // namespace kadr
