// Cuts a turned part for the page (TurnedPart). Tested by tests/view/turned_part_test.cpp, tests/serve.py.

#include "view/turned_part.h"

#include <algorithm>
#include <numbers>

#include "stock/turned/turned_surface.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr double deviation_of_width = 1.0 / 4000;               // greatest deviation of the triangles, as a share of the part's width
constexpr double least_deviation = 1e-3, most_deviation = 0.1;  // limits of this deviation, mm
constexpr double shown_chord = 0.01;                            // greatest deviation of chords from a nose in outlines, mm
constexpr double past_share = 0.25;                             // fraction of the memory limit for earlier states

double deviation_for(const TurnedRegion& blank) {
  double widest = 0;
  for (const TurnedPolygon& polygon : blank)
    for (const Vec2 p : polygon) widest = std::max(widest, 2 * p.x);
  return std::clamp(widest * deviation_of_width, least_deviation, most_deviation);
}

}  // namespace

TurnedPart::TurnedPart(const OpenedProgram& opened, const PartRequest& request, TurnedJob job, const StopToken& stop)
    : PartRun(opened, stop),
      picture_zero_(request.zero),
      turned_(std::move(job)),
      past_(turned_.blank, std::size_t(max_bytes * past_share)),
      deviation_(deviation_for(turned_.blank)) {}

tl::expected<void, std::string> TurnedPart::begin() {
  if (const auto opened = open_session(opened_.stated.contains("start")); !opened) return Failed(opened.error());
  run_ = std::make_unique<TurnedRun>(*session_, job_, turned_);
  run_->on_finding = [this](const CutFinding& f, const AlarmReport& report) {
    if (on_finding) on_finding(f, report);
  };
  run_->on_past([this](const TurnedRemoval& removal, const TurnedStock& now) { past_.add(removal, now); },
                [this](const TurnedThread& thread) { past_.add(thread); });
  return {};
}

tl::expected<void, std::string> TurnedPart::execute() {
  run_->attach(stop_);
  if (auto wrong = run_session(); !wrong) return wrong;
  run_->finish();
  past_.finish(run_->cutting().stock());
  result_ = run_->result();
  return {};
}

Vec3 TurnedPart::zero() const { return {picture_zero_.x, picture_zero_.y, run_->cutting().zero().value_or(picture_zero_.z)}; }

PartThen TurnedPart::at(double instant) const {
  PartThen then;
  then.seconds = std::clamp(instant, 0.0, std::max(result_.seconds, 0.0));
  const TurnedPast::Then state = past_.at(then.seconds);
  const auto maker_of = [&](Vec2 a, Vec2 b) { return past_.maker_of(a, b, state); };
  const TurnedView view{state.region, state.threads, maker_of, deviation_};
  then.stock = result_.stock;
  then.left = state.volume;
  then.cell = deviation_;
  then.surface = turned_surface(view);
  const TurnedView plain{state.region, state.threads, {}, deviation_};
  then.section = turned_section(plain, 0);
  then.section_y = turned_section(plain, std::numbers::pi / 2);
  then.edges = turned_edges(plain);
  return then;
}

std::vector<ShownInsert> TurnedPart::inserts() const {
  std::vector<ShownInsert> all;
  for (const auto& tool : run_->cutting().tools()) {
    const std::uint32_t number = tool->shape.geometry.number;
    if (!tool->shape.turns() || std::any_of(all.begin(), all.end(), [&](const ShownInsert& one) { return one.tool == number; })) continue;
    for (ShownInsert& one : shown_inserts(tool->shape.geometry)) all.push_back(std::move(one));
  }
  return all;
}

PartRun::Maker TurnedPart::maker_of(std::int32_t number) const {
  const TurnedPast::Maker maker = past_.who(number);
  return {maker.tool, maker.origin.line};
}

std::vector<ShownInsert> shown_inserts(const ToolGeometry& tool) {
  std::vector<ShownInsert> all;
  for (const InsertSweep& sweep : insert_sweeps(shape_of(tool), shown_chord))
    all.push_back({tool.number, sweep.part(), sweep.swept({}, {})});
  return all;
}

}  // namespace kadr
