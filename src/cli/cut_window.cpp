// --window and --resolution → two lattices. For cli/cut.

#include "cli/cut_window.h"

#include <algorithm>
#include <string>

#include "cli/cut_body.h"
#include "cli/terminal.h"
#include "config/told.h"
#include "stock/blank/blank_window.h"
#include "stock/mesh/mesh_within.h"
#include "stock/size.h"

namespace kadr::cli {
namespace {

constexpr double share_for_material = 0.5;  // of the memory; the rest is for the surface
constexpr double share_of_cell = 0.02;      // volume error of the surface for each mm² of it, in cells: docs/stock.md

double bytes_of_meshes(const CutJob& job) {
  double bytes = double(job.blank->bytes());
  for (const auto& fixture : job.fixtures) bytes += double(fixture->bytes());
  return bytes;
}

}  // namespace

bool find_cells(const CutOptions& options, double most_bytes, CutJob& job) {
  const double most = std::max(most_bytes * share_for_material - bytes_of_meshes(job), 0.0);
  if (options.window.empty()) {
    job.cell = options.resolution > 0 ? options.resolution : cell_for(job.blank->box(), most);
    return true;
  }
  const auto window = window_of(options.window);
  if (!window) return complain("--window " + window.error()), false;
  job.window = blank_within(job.blank, *window);
  if (!job.window || !(job.window->volume() > 0))
    return complain("--window " + options.window + told(": beside the blank", ": мимо заготовки")), false;
  // A whole that is finer than its window helps nobody; half of the memory each.
  job.cell = std::max(cell_for(job.blank->box(), most / 2), options.resolution);
  job.window_cell = options.resolution > 0 ? options.resolution : std::min(cell_for(job.window->box(), most / 2), job.cell);
  return true;
}

double bytes_of_material(const CutJob& job, const Mesh* held) {
  double bytes = bytes_of_meshes(job) + bytes_of_bricks(job.blank->box(), job.cell);
  for (const auto& fixture : job.fixtures) bytes += bytes_of_bricks(fixture->box(), job.cell);
  if (job.window) bytes += bytes_of_bricks(job.window->box(), job.window_cell);
  if (held == nullptr) return bytes;
  return bytes + (job.window ? bytes_of_comparison(job.window->box(), job.window_cell, *held, HeldPart::window)
                             : bytes_of_comparison(job.blank->box(), job.cell, *held, HeldPart::whole));
}

bool part_meets_window(const CutJob& job, const Mesh& part) {
  if (!job.window) return true;
  const Box3 box = box_of(part), window = job.window->box();
  for (int d = 0; d < 3; ++d)
    if (!(along(box.least, d) < along(window.most, d) && along(window.least, d) < along(box.most, d)))
      return complain(told("--window: beside the part", "--window: мимо детали")), false;
  return true;
}

PartComparison hold_against(const CutJob& job, const Stock& stock, const Surface& surface, const Mesh& part) {
  if (!job.window) return compare(stock, surface, part);
  const WindowFaces faces(job.window->box(), job.blank->box());
  return compare(stock, surface, part, &faces);
}

CutResult cut_figures(const Cutting& cutting, const CutJob& job, const Surface& whole, const Surface* window) {
  const double left = volume_of(whole), area = area_of(whole);
  if (window == nullptr) return cutting.result(left, share_of_cell * job.cell * area);
  const MeshWithin coarse = mesh_within(whole, job.window->box());
  WindowResult fine{job.window->volume(), volume_of(*window), share_of_cell * job.window_cell * area_of(*window), job.window_cell};
  CutResult result = cutting.result(left - coarse.volume + fine.left, share_of_cell * job.cell * (area - coarse.area) + fine.error_bound);
  result.window = fine;
  return result;
}

}  // namespace kadr::cli
