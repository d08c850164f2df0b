// Prepares the stock for a report. Used by cli/report_run; tested by tests/view/report_part_test.cpp.

#include "view/report/report_part.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "out/text/cut_text.h"
#include "stock/surface/simplified_surface.h"
#include "view/page/page_json.h"
#include "view/turned_json.h"

namespace kadr {
namespace {

constexpr double off_by_cell = 0.1;             // greatest distance of the triangles from the exact surface, in cell sizes
constexpr std::size_t max_triangles = 150'000;  // greatest number of triangles; their compressed size is some 1 MB
constexpr int max_simplifications = 3;

using Place = std::array<float, 3>;

Place place_of(const Mesh& mesh, std::size_t i) { return {mesh.points[3 * i], mesh.points[3 * i + 1], mesh.points[3 * i + 2]}; }

/// Adds to each point of `mesh` the sweep (movement of a tool) that has cut the point. The points of `mesh` are some of the points of
/// `exact`, so the sweeps are copied from there.
Surface with_makers(const Surface& exact, Mesh&& mesh) {
  std::map<Place, std::int32_t> makers;
  for (std::size_t i = 0; i < exact.point_count(); ++i) makers.emplace(place_of(exact, i), exact.made_by[i]);
  Surface simple;
  static_cast<Mesh&>(simple) = std::move(mesh);
  for (std::size_t i = 0; i < simple.point_count(); ++i) {
    const auto found = makers.find(place_of(simple, i));
    simple.made_by.push_back(found == makers.end() ? of_blank : found->second);
  }
  return simple;
}

}  // namespace

void take_part(const PartRun& run, ReportPart& part, const StopToken& stop) {
  PartThen end = run.at(run.result().seconds);
  part.cell = end.cell;
  PageJson result = cut_json(run.result(), run.alarms(), run.warnings());
  result["inserts"] = inserts_json(run.inserts());
  part.result = dumped(result);
  if (run.result().turned) {  // the triangles of a turned part are few, and its sections have no triangles
    part.off = end.cell;
    part.turned = dumped(turned_json(end, run.zero().z));
    part.frame = run.frame_of(end);
    return;
  }
  SimplifyRules rules;
  rules.most_off = off_by_cell * end.cell;
  rules.stop = stop;
  SimplifiedSurface simple = simplified_surface(end.surface, rules);
  for (int tries = 1; simple.mesh.triangle_count() > max_triangles && tries < max_simplifications; ++tries) {
    rules.most_off *= 3;
    simple = simplified_surface(end.surface, rules);
  }
  part.off = simple.off;
  end.surface = with_makers(end.surface, std::move(simple.mesh));
  part.frame = run.frame_of(end);
}

}  // namespace kadr
