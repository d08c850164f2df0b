// What all cuts for the page have in common: session, progress, frames. Used by view/page/page_part; tested by
// tests/view/part_run_test.cpp, tests/serve.py.

#include "view/part_run.h"

#include <algorithm>
#include <array>

#include "config/language.h"
#include "out/text/alarm_print.h"
#include "session/cutting/cut_setup.h"
#include "session/cutting/turned_run.h"
#include "texts/part_run.h"
#include "view/frame_bytes.h"
#include "view/lattice_part.h"
#include "view/turned_part.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr std::uint16_t of_no_tool = 65535;  // tool number that a frame contains for surface that no tool has cut

}  // namespace

tl::expected<std::unique_ptr<PartRun>, std::string> PartRun::make(const OpenedProgram& opened, const PartRequest& request,
                                                                  const StopToken& stop) {
  std::unique_ptr<PartRun> run;
  // Cut exactly: the part of a lathe, unless a cell size is stated or the machine has bodies, which only the lattice knows
  const bool turns = request.resolution == 0 && opened.def->behaviour.lathe != Lathe::none && opened.machine.bodies.empty();
  auto turned = turns ? turned_job_of(opened.machine, opened.setup, request.stock, request.fixtures) : std::nullopt;
  TurnedPart* const exact = turned ? new TurnedPart(opened, request, std::move(*turned), stop) : nullptr;
  LatticePart* const cells = turned ? nullptr : new LatticePart(opened, stop);
  run.reset(exact != nullptr ? static_cast<PartRun*>(exact) : cells);
  run->job_.tools = request.tools;
  run->notes_ = request.tools.notes;
  run->job_.threads = threads_at_once();
  run->job_.stop = stop;
  const auto begun = exact != nullptr ? exact->begin() : cells->begin(request);
  if (!begun) return Failed(begun.error());
  return run;
}

tl::expected<void, std::string> PartRun::open_session(bool starts_known) {
  auto program = opened_.program();
  if (!program) return Failed(program.error());
  auto session = Session::open(opened_.spec(std::move(*program), stop_));
  if (!session) return Failed(in_thread_language(session.error().fault.en, session.error().fault.ru));
  session_ = std::move(*session);
  session_->control().watch_calls();
  take_session(*session_, starts_known, job_);
  return {};
}

void PartRun::report_progress() {
  if (!progress_clock_.is_due()) return;
  // The factor 1.25 allows for the memory of the stored sweeps; max_bytes is the limit for the stocks alone.
  too_much_ = bytes() > max_bytes * 1.25;
  if (!on_progress) return;
  const Control& control = session_->settled_control();
  const double all = double(control.bytes());
  on_progress(all > 0 ? std::min(double(control.bytes_read()) / all, 1.0) : 0);
}

tl::expected<void, std::string> PartRun::fault() const {
  if (stop_.requested()) return Failed(translated(texts::part_run::stopped));
  if (too_much_) return Failed(translated(texts::part_run::cut_too_large));
  if (const auto& report = without_shape()) {
    const Finding f = finding_of(*report, *opened_.texts, thread_language());
    return Failed(translated(texts::part_run::line_stops, f.line, f.text));
  }
  return {};
}

tl::expected<void, std::string> PartRun::run_session() {
  Session::State state = Session::State::running;
  while (state == Session::State::running && !stop_.requested() && !too_much_ && !without_shape()) {
    state = session_->go_on();
    report_progress();
  }
  return fault();
}

/// Returns the frame of kind 3 with the surface of the stock. The points are relative to the machine's zero point, in the same way as the
/// points of the path.
std::string PartRun::frame_of(const PartThen& then) const {
  const Surface& s = then.surface;
  const Vec3 from = zero();
  FrameBytes frame(3, 0, std::uint32_t(s.point_count()), std::uint32_t(s.triangle_count()));
  constexpr std::size_t head = 16, point = 20, triangle = 12;
  frame.reserve(head + point * s.point_count() + triangle * s.triangle_count());
  for (std::size_t i = 0; i < s.point_count(); ++i) {
    const Vec3 at = from + s.point(i);
    frame.put(std::array<float, 3>{float(at.x), float(at.y), float(at.z)});
  }
  frame.put_all(s.triangles.data(), s.triangles.size());
  std::int32_t last = of_blank;
  Maker maker;
  std::vector<std::uint32_t> lines;
  lines.reserve(s.made_by.size());
  for (const std::int32_t by : s.made_by) {
    if (by != last) {
      last = by;
      maker = by < 0 ? Maker() : maker_of(by);
    }
    frame.put(std::array<std::uint16_t, 2>{std::uint16_t(std::min<std::uint32_t>(maker.tool, of_no_tool)), 0});
    lines.push_back(maker.line);
  }
  frame.put_all(lines.data(), lines.size());
  return frame.take();
}

}  // namespace kadr
