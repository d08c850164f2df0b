// Lattices of a job. For cli/cut and view/part_run.

#include "session/cutting/cut_cells.h"

#include <algorithm>

#include "stock/blank/blank_window.h"
#include "stock/mesh/mesh_within.h"
#include "stock/size.h"

namespace kadr {
namespace {

constexpr double share_for_material = 0.5;  // of the memory; the rest is for the surface
constexpr double share_of_cell = 0.02;      // volume error of the surface for each mm² of it, in cells: docs/stock.md

}  // namespace

double bytes_of_meshes(const CutJob& job) {
  double bytes = double(job.blank->bytes());
  for (const auto& fixture : job.fixtures) bytes += double(fixture->bytes());
  return bytes;
}

bool find_cells(double resolution, const std::optional<Box3>& window, double most_bytes, CutJob& job) {
  const double most = std::max(most_bytes * share_for_material - bytes_of_meshes(job), 0.0);
  if (!window) {
    job.cell = resolution > 0 ? resolution : cell_for(job.blank->box(), most);
    return true;
  }
  job.window = blank_within(job.blank, *window);
  if (!job.window || !(job.window->volume() > 0)) return false;
  // A whole that is finer than its window helps nobody; half of the memory each.
  job.cell = std::max(cell_for(job.blank->box(), most / 2), resolution);
  job.window_cell = resolution > 0 ? resolution : std::min(cell_for(job.window->box(), most / 2), job.cell);
  return true;
}

double bytes_of_material(const CutJob& job, const Mesh* held) {
  double bytes = bytes_of_meshes(job) + bytes_of_bricks(job.blank->box(), job.cell);
  for (const auto& fixture : job.fixtures) bytes += bytes_of_bricks(fixture->box(), job.cell);
  if (job.window) bytes += bytes_of_bricks(job.window->box(), job.window_cell);
  if (job.seen_cell > 0) bytes += bytes_of_bricks(job.blank->box(), job.seen_cell) + double(job.past_bytes);
  if (held == nullptr) return bytes;
  return bytes + (job.window ? bytes_of_comparison(job.window->box(), job.window_cell, *held, HeldPart::window)
                             : bytes_of_comparison(job.blank->box(), job.cell, *held, HeldPart::whole));
}

bool part_meets_window(const CutJob& job, const Mesh& part) {
  if (!job.window) return true;
  const Box3 box = box_of(part), window = job.window->box();
  for (int d = 0; d < 3; ++d)
    if (!(along(box.least, d) < along(window.most, d) && along(window.least, d) < along(box.most, d))) return false;
  return true;
}

PartComparison hold_against(const CutJob& job, const Stock& stock, const Surface& surface, const Mesh& part) {
  if (!job.window) return compare(stock, surface, part);
  const WindowFaces faces(job.window->box(), job.blank->box());
  return compare(stock, surface, part, &faces);
}

double error_of_volume(const Stock& stock, const Mesh& surface) { return share_of_cell * stock.lattice().cell() * area_of(surface); }

CutResult cut_figures(const Cutting& cutting, const CutJob& job, const Surface& whole, const Surface* window) {
  const double left = volume_of(whole), area = area_of(whole);
  if (window == nullptr) return cutting.result(left, share_of_cell * job.cell * area);
  const MeshWithin coarse = mesh_within(whole, job.window->box());
  WindowResult fine{job.window->volume(), volume_of(*window), share_of_cell * job.window_cell * area_of(*window), job.window_cell};
  CutResult result = cutting.result(left - coarse.volume + fine.left, share_of_cell * job.cell * (area - coarse.area) + fine.error_bound);
  result.window = fine;
  return result;
}

}  // namespace kadr
