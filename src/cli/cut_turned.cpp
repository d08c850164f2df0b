// Cuts spinning parts for kadr cut. This file is used by cli/cut and tested by tests/run_cut.py.

#include "cli/cut_turned.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/cut_guess.h"
#include "cli/cut_meshes.h"
#include "cli/job/found.h"
#include "cli/job/progress.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "config/json_text.h"
#include "config/language.h"
#include "out/picture/part_page.h"
#include "out/text/cut_load_text.h"
#include "out/text/cut_text.h"
#include "session/cutting/named_body.h"
#include "session/cutting/turned_run.h"
#include "session/cutting/turning/work_holding.h"
#include "stock/turned/turned_mesh.h"
#include "stock/turned/turned_picture.h"

namespace kadr::cli {
namespace {

constexpr double mesh_deviation = 0.01;      // mm; deviation of the mesh from the part unless --simplify states another
constexpr double picture_deviation = 0.005;  // mm
constexpr double longest_compared = 0.5;     // mm; greatest length of an edge in a picture of deviations
constexpr double endless = 1e300;
constexpr double allowed_gouge = 0.01;  // mm; default permitted depth of a gouge

TurnedJob turned_job_of(const CutOptions& options, const Job& job) {
  TurnedJob turned = *kadr::turned_job_of(job.profile, job.setup, options.stock, options.fixtures);
  turned.keeps_areas = !options.part.empty();
  turned.keeps_stages = !options.run.plot.empty();
  return turned;
}
void print_to_terminal(Found& found, std::FILE* blocks, TurnedRun& run) {
  const auto print_report = [&found](const AlarmReport& report) { found.print_report(report); };
  run.on_report = print_report;
  run.on_finding = [print_report](const CutFinding&, const AlarmReport& report) { print_report(report); };
  run.on_note = [](const std::string& note) { write_message(note + "\n"); };
  if (blocks == nullptr) return;
  write_data(blocks, blocks_heading());
  run.on_block([blocks](const BlockLoad& load) { write_data(blocks, blocks_row(load)); });
}

/// Returns the box around the body of revolution, as the picture shows it.
Box3 pictured_box(const TurnedRegion& region) {
  double radius = 0, bottom = 1e300, top = -1e300;
  for (const TurnedPolygon& polygon : region)
    for (const Vec2 corner : polygon)
      radius = std::max(radius, corner.x), bottom = std::min(bottom, corner.y), top = std::max(top, corner.y);
  return {{bottom, -radius, -radius}, {top, radius, radius}};
}

/// Returns the deviation of each point of the pictured surface from the wanted part, mm.
std::vector<float> deviations(const Surface& surface, const TurnedRegion& wanted) {
  std::map<std::pair<float, float>, float> known;  // the points of a circle have the same deviation
  std::vector<float> off;
  for (std::size_t i = 0; i < surface.point_count(); ++i) {
    const Vec3 p = surface.point(i);
    const Vec2 at{std::hypot(p.y, p.z), p.x};
    const auto [entry, is_new] = known.try_emplace({std::round(float(at.x) * 1e4F), std::round(float(at.y) * 1e4F)}, 0.F);
    if (is_new) entry->second = float(distance_from(wanted, at));
    off.push_back(entry->second);
  }
  return off;
}

/// Draws the picture if --plot requests one. Returns an error sentence if it cannot be drawn.
tl::expected<void, std::string> draw(const TurnedCut& c, const TurnedCutting& cutting, const CutResult& result) {
  if (c.options.run.plot.empty()) return {};
  const Lang lang = language(c.options.run);
  const bool compares = c.options.run.colour == "deviation";
  const Surface surface = turned_picture(cutting.stock().region(), cutting.stages(), cutting.grooves(), picture_deviation,
                                         compares ? longest_compared : endless);
  PartScene scene{surface, pictured_box(*turned_region_of(c.options.stock)), compares ? PartColour::deviation : PartColour::tool, {}, {},
                  {}};
  if (compares) scene.deviation = {deviations(surface, *c.plan.wanted), result.part->allow};
  for (const CutFinding& f : result.collisions) scene.collisions.push_back({as_pictured(f.at), f.origin.line});
  scene.title = {c.job.file, lang == Lang::ru ? c.job.def->name.ru : c.job.def->name.en, lang, cut_caption(result, lang), {}};
  for (std::size_t i = 0; i < result.tools.size(); ++i) {
    scene.colours.push_back(std::uint8_t(i));
    scene.title.legend.push_back(fmt::format("T{}", result.tools[i].tool));
  }
  return draw_part_page(*c.outputs.file("--plot"), scene);
}

bool write_results(const TurnedCut& c, const TurnedRun& run, const CutResult& result) {
  const CutOptions& options = c.options;
  if (std::FILE* const file = c.outputs.stream("--out"); file != nullptr) {
    const double deviation = options.simplify > 0 ? options.simplify : mesh_deviation;
    if (!write_part(options.out, turned_mesh(run.cutting().stock().region(), deviation), file)) return false;
  }
  if (std::FILE* const file = c.outputs.stream("--json"); file != nullptr)
    write_data(file, json_text(cut_json(result, run.alarms(), run.warnings())) + "\n");
  if (const auto drawn = draw(c, run.cutting(), result); !drawn) {
    complain(drawn.error());
    return false;
  }
  const bool prints_summary = options.json != "-" && options.out != "-" && options.blocks != "-";
  if (!options.run.quiet && prints_summary) type_out("{}", cut_summary(result, language(options.run)));
  return c.outputs.keep();
}

}  // namespace

bool can_turn(const CutOptions& o, const CutPlan& plan, bool has_part) {
  const bool needs_lattice =
      o.resolution > 0 || !o.window.empty() || !o.deviation.empty() || o.run.colour == "age" || o.run.colour == "load";
  const auto is_turned = [](const std::string& body) { return turned_region_of(body).has_value(); };
  return !needs_lattice && has_part == plan.wanted.has_value() && (o.stock == guess_word || is_turned(o.stock)) &&
         std::all_of(o.fixtures.begin(), o.fixtures.end(), is_turned);
}

int cut_turned(const TurnedCut& c) {
  TurnedRun run(c.session, c.cut, turned_job_of(c.options, c.job), c.watch);
  Found found(c.job.texts(), language(c.options.run), stderr, c.options.run.every);
  print_to_terminal(found, c.outputs.stream("--blocks"), run);
  Progress progress(c.options.run.quiet);
  run.attach(c.options.run.limits.stop, &progress);
  c.drive.execute(c.session);
  if (interrupted()) return interrupted_status();
  run.finish();
  found.finish();
  CutResult result = run.result();
  if (c.plan.wanted) {
    result.part = run.part_result(compare(run.cutting().stock().region(), *c.plan.wanted));
    result.part->allow = c.options.allow >= 0 ? c.options.allow : allowed_gouge;
    if (c.options.allow_left >= 0) result.part->allow_left = c.options.allow_left;
  }
  erase_bar();
  if (!write_results(c, run, result)) return interrupted() ? interrupted_status() : wrong_usage;
  const bool part_is_wrong = result.part && (result.part->is_gouged() || result.part->is_left_on());
  return run.alarms() != 0 || !result.collisions.empty() || part_is_wrong ? alarms : ok;
}

}  // namespace kadr::cli
