// Cuts a blank on a lattice for the page (LatticePart). Tested by tests/view/part_run_test.cpp, tests/serve.py.

#include "view/lattice_part.h"

#include <algorithm>

#include "config/language.h"
#include "out/text/cut_text.h"
#include "session/cutting/body_watch.h"
#include "session/cutting/cut_cells.h"
#include "session/cutting/named_body.h"
#include "texts/part_run.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr double bytes_per_mb = 1 << 20;
// Number of cells along the longest side of the displayed stock, which gives some hundred thousand triangles.
constexpr double cells_seen = 200;
constexpr double share_for_past = 0.25;               // fraction of the memory limit for earlier states of the displayed stock
constexpr double least_cell = 1e-3, max_cell = 1000;  // limits of the cell size in a request, mm

double longest_side(const Box3& box) {
  const Vec3 size = box.most - box.least;
  return std::max({size.x, size.y, size.z});
}

std::string memory_full_message(double bytes) { return translated(texts::part_run::material_too_large, bytes / bytes_per_mb); }

}  // namespace

tl::expected<std::shared_ptr<const Blank>, std::string> LatticePart::body(const std::string& text) {
  auto named = body_of(text, max_bytes, opened_.door);
  if (!named) return Failed(named.error());
  notes_.insert(notes_.end(), named->notes.begin(), named->notes.end());
  return named->body;
}

/// Chooses the cell sizes. The fine stock has the same cells as in `kadr cut`. The displayed stock has larger cells, so that its state at
/// any instant can be computed within a second.
tl::expected<void, std::string> LatticePart::find_material(const PartRequest& request) {
  auto blank = body(request.stock);
  if (!blank) return Failed(blank.error());
  job_.blank = *blank;
  for (const std::string& text : request.fixtures) {
    auto fixture = body(text);
    if (!fixture) return Failed(fixture.error());
    job_.fixtures.push_back(*fixture);
  }
  if (request.resolution != 0 && !(request.resolution >= least_cell && request.resolution <= max_cell))
    return Failed(translated(texts::part_run::resolution_limits));
  const double for_material = max_bytes * (1 - share_for_past);
  (void)find_cells(request.resolution, std::nullopt, for_material, job_);
  job_.past_bytes = std::size_t(max_bytes * share_for_past / 2);
  job_.seen_cell = job_.cell;
  while (longest_side(job_.blank->box()) > cells_seen * job_.seen_cell * (1 + 1e-9)) job_.seen_cell *= 2;
  const double bytes = bytes_of_material(job_, nullptr);
  if (bytes > max_bytes) return Failed(memory_full_message(bytes));
  return {};
}

tl::expected<void, std::string> LatticePart::begin(const PartRequest& request) {
  if (const auto material = find_material(request); !material) return Failed(material.error());
  if (const auto opened = open_session(opened_.stated.contains("start")); !opened) return Failed(opened.error());
  auto watch =
      watch_bodies(*session_, job_, work_of(job_, request.stock, request.fixtures, request.fixture_names), max_bytes, notes_, opened_.door);
  if (!watch) return Failed(watch.error());
  watch_ = std::move(*watch);
  run_ = std::make_unique<CutRun>(*session_, job_, watch_.get());
  run_->on_note = [this](const std::string& note) { notes_.push_back(note); };
  run_->on_finding = [this](const CutFinding& f, const AlarmReport& report) {
    if (on_finding) on_finding(f, report);
  };
  return {};
}

tl::expected<void, std::string> LatticePart::execute() {
  run_->attach(stop_);
  if (auto wrong = run_session(); !wrong) return wrong;
  run_->finish();
  const Surface surface = surface_of(run_->cutting().stock());
  if (stop_.requested()) return fault();
  result_ = run_->named(cut_figures(run_->cutting(), job_, surface, nullptr));
  if (const std::string note = too_coarse_message(result_, thread_language()); !note.empty()) notes_.push_back(note);
  return {};
}

PartThen LatticePart::at(double instant) const {
  const Cutting& cutting = run_->cutting();
  PartThen then;
  then.seconds = std::clamp(instant, 0.0, std::max(result_.seconds, 0.0));
  const SweepProgress place = cutting.sweeps_at(then.seconds);
  const Stock stock = cutting.seen()->at(place.count, place.share);
  then.stock = result_.stock;
  then.cell = stock.lattice().cell();
  then.surface = surface_of(stock);
  then.left = volume_of(then.surface);
  return then;
}

PartRun::Maker LatticePart::maker_of(std::int32_t number) const {
  const Stock& stock = *run_->cutting().seen();
  return {stock.tool(stock.sweep(std::size_t(number)).tool).geometry.number, run_->cutting().line_of(number).line};
}

}  // namespace kadr
