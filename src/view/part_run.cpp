// Cuts a blank with a program for the page (PartRun). Used by view/page/page_part; tested by tests/view/part_run_test.cpp, tests/serve.py.

#include "view/part_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "config/language.h"
#include "out/text/alarm_print.h"
#include "out/text/cut_text.h"
#include "session/cutting/body_watch.h"
#include "session/cutting/cut_cells.h"
#include "session/cutting/cut_setup.h"
#include "session/cutting/named_body.h"
#include "stock/size.h"
#include "texts/part_run.h"
#include "view/frame_bytes.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr double bytes_per_mb = 1 << 20;
// Number of cells along the longest side of the displayed stock, which gives some hundred thousand triangles.
constexpr double cells_seen = 200;
constexpr double share_for_past = 0.25;               // fraction of the memory limit for earlier states of the displayed stock
constexpr double least_cell = 1e-3, max_cell = 1000;  // limits of the cell size in a request, mm
constexpr std::uint16_t of_no_tool = 65535;           // tool number that a frame contains for surface that no tool has cut

double longest_side(const Box3& box) {
  const Vec3 size = box.most - box.least;
  return std::max({size.x, size.y, size.z});
}

std::string memory_full_message(double bytes) { return translated(texts::part_run::material_too_large, bytes / bytes_per_mb); }

}  // namespace

tl::expected<std::shared_ptr<const Blank>, std::string> PartRun::body(const std::string& text) {
  auto named = body_of(text, max_bytes, opened_.door);
  if (!named) return Failed(named.error());
  notes_.insert(notes_.end(), named->notes.begin(), named->notes.end());
  return named->body;
}

/// Chooses the cell sizes. The fine stock has the same cells as in `kadr cut`. The displayed stock has larger cells, so that its state at
/// any instant can be computed within a second.
tl::expected<void, std::string> PartRun::find_material(const PartRequest& request) {
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

tl::expected<void, std::string> PartRun::open_session(const PartRequest& request) {
  auto program = opened_.program();
  if (!program) return Failed(program.error());
  auto session = Session::open(opened_.spec(std::move(*program), stop_));
  if (!session) return Failed(in_thread_language(session.error().fault.en, session.error().fault.ru));
  session_ = std::move(*session);
  session_->control().watch_calls();
  take_session(*session_, opened_.stated.contains("start"), job_);
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

tl::expected<std::unique_ptr<PartRun>, std::string> PartRun::make(const OpenedProgram& opened, const PartRequest& request,
                                                                  const StopToken& stop) {
  std::unique_ptr<PartRun> run(new PartRun(opened, stop));
  run->job_.tools = request.tools;
  run->notes_ = request.tools.notes;
  run->job_.threads = std::max(1, int(std::thread::hardware_concurrency()));
  run->job_.stop = stop;
  if (const auto material = run->find_material(request); !material) return Failed(material.error());
  if (const auto session = run->open_session(request); !session) return Failed(session.error());
  return run;
}

void PartRun::report_progress() {
  if (!progress_clock_.is_due()) return;
  // The factor 1.25 allows for the memory of the stored sweeps; max_bytes is the limit for the stocks alone.
  too_much_ = double(run_->cutting().bytes()) > max_bytes * 1.25;
  if (!on_progress) return;
  const Control& control = session_->settled_control();
  const double bytes = double(control.bytes());
  on_progress(bytes > 0 ? std::min(double(control.bytes_read()) / bytes, 1.0) : 0);
}

tl::expected<void, std::string> PartRun::fault() const {
  if (stop_.requested()) return Failed(translated(texts::part_run::stopped));
  if (too_much_) return Failed(translated(texts::part_run::cut_too_large));
  if (const auto& report = run_->without_shape()) {
    const Finding f = finding_of(*report, *opened_.texts, thread_language());
    return Failed(translated(texts::part_run::line_stops, f.line, f.text));
  }
  return {};
}

tl::expected<void, std::string> PartRun::execute() {
  run_->attach(stop_);
  Session::State state = Session::State::running;
  while (state == Session::State::running && !stop_.requested() && !too_much_ && !run_->without_shape()) {
    state = session_->go_on();
    report_progress();
  }
  if (auto wrong = fault(); !wrong) return wrong;
  run_->finish();
  const Surface surface = surface_of(run_->cutting().stock());
  if (stop_.requested()) return fault();
  result_ = run_->named(cut_figures(run_->cutting(), job_, surface, nullptr));
  if (const std::string note = too_coarse_message(result_, thread_language()); !note.empty()) notes_.push_back(note);
  return {};
}

PartThen PartRun::at(double instant) const {
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

/// Returns the frame of kind 3 with the surface of the stock. The points are relative to the machine's zero point, in the same way as the
/// points of the path.
std::string PartRun::frame_of(const PartThen& then) const {
  const Surface& s = then.surface;
  const Cutting& cutting = run_->cutting();
  const Stock& stock = *cutting.seen();
  const Vec3 zero = cutting.zero();
  FrameBytes frame(3, 0, std::uint32_t(s.point_count()), std::uint32_t(s.triangle_count()));
  constexpr std::size_t head = 16, point = 20, triangle = 12;
  frame.reserve(head + point * s.point_count() + triangle * s.triangle_count());
  for (std::size_t i = 0; i < s.point_count(); ++i) {
    const Vec3 at = zero + s.point(i);
    frame.put(std::array<float, 3>{float(at.x), float(at.y), float(at.z)});
  }
  frame.put_all(s.triangles.data(), s.triangles.size());
  std::int32_t last = of_blank;
  std::array<std::uint16_t, 2> tool{of_no_tool, 0};
  for (const std::int32_t by : s.made_by) {
    if (by != last) {
      last = by;
      const std::uint32_t number = by < 0 ? of_no_tool : stock.tool(stock.sweep(std::size_t(by)).tool).geometry.number;
      tool[0] = std::uint16_t(std::min<std::uint32_t>(number, of_no_tool));
    }
    frame.put(tool);
  }
  for (const std::int32_t by : s.made_by) frame.put(cutting.line_of(by).line);
  return frame.take();
}

}  // namespace kadr
