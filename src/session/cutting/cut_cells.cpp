// Chooses the cell sizes of the stock's lattices. This file is used by cli/cut and view/part_run.

#include "session/cutting/cut_cells.h"

#include <algorithm>
#include <cmath>

#include "stock/blank/blank_window.h"
#include "stock/mesh/mesh_within.h"
#include "stock/portion/portion.h"
#include "stock/size.h"

namespace kadr {
namespace {

constexpr double share_for_material = 0.5;  // fraction (0 to 1) of the memory limit for the material; the rest is for the surface
// Error of a measured volume, in mm³ per mm² of surface, as a fraction of the cell size (docs/stock.md).
constexpr double share_of_cell = 0.02;
constexpr double cells_to_see = 2;  // least number of cells across the diameter of a tool, so that the cuts of the tool are visible
// Greatest number of tools in the tools file of a single job. A file with more tools is a library, of which the program uses only some.
constexpr std::size_t tools_of_a_job = 24;

/// Returns the diameter of the thinnest milling or drilling tool of a job, mm; 0 if it is unknown.
double finest_of(const ToolLibrary& tools) {
  double finest = 0;
  if (tools.tools.size() > tools_of_a_job) return finest;
  for (const ToolGeometry& tool : tools.tools)
    if (tool.kind != ToolKind::turning && tool.diameter > 0 && (finest == 0 || tool.diameter < finest)) finest = tool.diameter;
  return finest;
}

bool is_box(const Blank& blank) {
  constexpr double same_volume = 1e-9;
  const Vec3 size = blank.box().most - blank.box().least;
  return std::fabs(blank.volume() - size.x * size.y * size.z) <= same_volume * blank.volume();
}

/// Returns the triangles of the remaining stock's surface whose position may be inexact. If the blank is a box, these are the triangles
/// that tools have cut, since the uncut faces of a box are exact.
Mesh uncertain_part(const Surface& surface, const Blank& blank) {
  if (!is_box(blank)) return surface;
  Mesh cut;
  cut.points = surface.points;
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3)
    if (std::any_of(&surface.triangles[t], &surface.triangles[t] + 3, [&](auto point) { return surface.made_by[point] != of_blank; }))
      cut.triangles.insert(cut.triangles.end(), {surface.triangles[t], surface.triangles[t + 1], surface.triangles[t + 2]});
  return cut;
}

/// Returns the numbers of tools that have cut and are thinner than two cells. Their cuts are hardly visible.
std::vector<std::uint32_t> tools_finer_than_cells(const Stock& stock) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < stock.tools(); ++i) {
    const ToolGeometry& tool = stock.tool(i).geometry;
    if (tool.kind != ToolKind::turning && tool.diameter < cells_to_see * stock.lattice().cell()) numbers.push_back(tool.number);
  }
  return numbers;
}

}  // namespace

Lattice held_bricks(const CutJob& job) {
  const Lattice whole(job.blank->box(), job.cell);
  return job.bricks ? whole.held_only(with_neighbours(*job.bricks, whole.held())) : whole;
}

double bytes_of_meshes(const CutJob& job) {
  double bytes = double(job.blank->bytes());
  for (const auto& fixture : job.fixtures) bytes += double(fixture->bytes());
  return bytes;
}

bool find_cells(double resolution, const std::optional<Box3>& window, double max_bytes, CutJob& job) {
  const double most = std::max(max_bytes * share_for_material - bytes_of_meshes(job), 0.0);
  if (!window) {
    job.cell = resolution > 0 ? resolution : cell_for(job.blank->box(), most, finest_of(job.tools));
    return true;
  }
  job.window = blank_within(job.blank, *window);
  if (!job.window || !(job.window->volume() > 0)) return false;
  // The cells of the whole blank are not finer than those of the window. The lattices of the whole blank and of the window each get half of
  // the memory.
  job.cell = std::max(cell_for(job.blank->box(), most / 2), resolution);
  job.window_cell = resolution > 0 ? resolution : std::min(cell_for(job.window->box(), most / 2, finest_of(job.tools)), job.cell);
  return true;
}

double bytes_of_material(const CutJob& job, const Mesh* held) {
  double bytes = bytes_of_meshes(job) + bytes_of_bricks(held_bricks(job));
  for (const auto& fixture : job.fixtures) bytes += bytes_of_bricks(fixture->box(), job.cell);
  if (job.window) bytes += bytes_of_bricks(job.window->box(), job.window_cell);
  if (job.seen_cell > 0) bytes += bytes_of_bricks(job.blank->box(), job.seen_cell) + double(job.past_bytes);
  if (held == nullptr) return bytes;
  return bytes + (job.window ? bytes_of_comparison(job.window->box(), job.window_cell, *held, ComparedPart::window)
                             : bytes_of_comparison(job.blank->box(), job.cell, *held, ComparedPart::whole, job.bricks));
}

bool part_meets_window(const CutJob& job, const Mesh& part) {
  if (!job.window) return true;
  const Box3 box = box_of(part), window = job.window->box();
  for (int d = 0; d < 3; ++d)
    if (!(along(box.least, d) < along(window.most, d) && along(window.least, d) < along(box.most, d))) return false;
  return true;
}

PartComparison compare_with_part(const CutJob& job, const Stock& stock, const Surface& surface, const Mesh& part) {
  if (!job.window) return compare(stock, surface, part);
  const WindowFaces faces(job.window->box(), job.blank->box());
  return compare(stock, surface, part, &faces);
}

CutResult joined_figures(const Cutting& cutting, const CutJob& job, const JoinedSurface& whole) {
  CutResult result = cutting.result(whole.volume, share_of_cell * job.cell * (is_box(*job.blank) ? whole.cut_area : whole.area));
  result.finer_than_cell = tools_finer_than_cells(cutting.stock());
  return result;
}

CutResult cut_figures(const Cutting& cutting, const CutJob& job, const Surface& whole, const Surface* window) {
  const double left = volume_of(whole);
  const Mesh uncertain = uncertain_part(whole, *job.blank);
  const double area = area_of(uncertain);
  CutResult result;
  if (window == nullptr) {
    result = cutting.result(left, share_of_cell * job.cell * area);
    result.finer_than_cell = tools_finer_than_cells(cutting.stock());
    return result;
  }
  const Box3 box = job.window->box();
  const double of_window = area_of(uncertain_part(*window, *job.window));
  WindowResult fine{job.window->volume(), volume_of(*window), share_of_cell * job.window_cell * of_window, job.window_cell};
  const double outer_area = area - mesh_within(uncertain, box).area;
  result = cutting.result(left - mesh_within(whole, box).volume + fine.left, share_of_cell * job.cell * outer_area + fine.error_bound);
  result.window = fine;
  result.finer_than_cell = tools_finer_than_cells(*cutting.window());
  return result;
}

}  // namespace kadr
