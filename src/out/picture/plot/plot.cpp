// Plot: draws the tool path as a picture, SVG or PNG, in an isometric view and in three planes. It is used by cli and out, and tested by
// tests/out/plot_test.cpp.

#include "out/picture/plot/plot.h"

#include <algorithm>

#include "action/by_kind.h"
#include "base/tolerance.h"
#include "out/picture/plot/plot_page.h"

namespace kadr {
namespace {

constexpr std::size_t max_zeros = 12;
constexpr double chord = 0.02;  // greatest distance between an arc and the straight lines that approximate it, mm
constexpr int max_arc_pieces = 720;

ProgramLine line_of(const Origin& origin) { return {origin.line, origin.file}; }

Box box_of(const Chain& chain, const Curve& curve, Vec3 shift) {
  const Extents extents = curve.extents();
  return {chain.tip(extents.least) + shift, chain.tip(extents.most) + shift, false};
}

/// True if the curve of the step is described in a programmable frame. The axes of the frame differ from those of the picture, so the box
/// of the curve cannot be used.
bool has_frame(const Step& step) { return step.from.space && step.from.space->has_frame(); }

bool is_lathe(const AxisRoles& roles) { return roles.xyz[0] >= 0 && roles.xyz[1] < 0 && roles.xyz[2] >= 0; }

Stroke stroke_of(const Motion& motion, Vec3 from, Vec3 to) {
  if (is_arc(motion.kind) || motion.kind == MotionKind::spline) return Stroke::arc;
  if (motion.kind == MotionKind::probe) return Stroke::probe;
  if (motion.kind == MotionKind::rapid || motion.kind == MotionKind::home) return Stroke::rapid;
  if (motion.detail && motion.detail->surface != PathSurface::plane) return Stroke::feed;
  const bool down = to.z < from.z && length(Vec2{to.x - from.x, to.y - from.y}) < tol::same_point;
  return down ? Stroke::plunge : Stroke::feed;
}

}  // namespace

Plot::Plot(const std::vector<std::string>& axes, AxisMask rotary, const ToolPosition& start)
    : roles_(AxisRoles::of(axes, rotary)), chain_(roles_), here_(chain_.tip(start.work)), programmed_(start) {}

void Plot::take_frame(const FrameChange& frame) {
  here_ = chain_.tip(frame.placement.space.get(), frame.work);
  const Vec3 origin = work_origin_of(chain_, frame.placement);
  if (!origin_known_ && !started_) {
    first_origin_ = origin;
    origin_known_ = true;
  }
  shift_ = origin - first_origin_;
}

/// Selects the work coordinates of the first cut as the coordinates of the picture. Everything drawn before the first cut is converted to
/// them.
void Plot::take_reference() {
  path_.move_all(-1.0 * shift_);
  if (shaded_) shaded_->move_all(-1.0 * shift_);
  start_.at = start_.at - shift_;
  first_origin_ = first_origin_ + shift_;
  shift_ = {};
}

/// Marks the origin of the present work coordinates. This function is called only for work coordinates in which the program has moved.
void Plot::mark_zero() {
  const auto same = [&](Vec3 zero) { return length(zero - shift_) < tol::same_point; };
  if (zeros_.size() < max_zeros && std::none_of(zeros_.begin(), zeros_.end(), same)) zeros_.push_back(shift_);
}

void Plot::take_motion(const Step& step, const Motion& motion) {
  const Origin& origin = step.action.origin;
  if (!started_ || origin.file != last_line_.file) files_.insert(origin.file);
  last_line_ = line_of(origin);
  const WorkTransform* const space = step.from.space.get();
  const Vec3 from = chain_.tip(space, step.from.work), to = chain_.tip(space, motion.to);
  if (!started_) {
    path_.start(from + shift_);
    start_ = {PlotMark::What::start, from + shift_, last_line_};
  }
  started_ = true;
  Stroke stroke = stroke_of(motion, from, to);
  if (stroke == Stroke::plunge && is_lathe(roles_)) stroke = Stroke::feed;  // on a lathe a cut along Z is the usual one
  if (cuts(stroke)) {
    if (zeros_.empty()) take_reference();
    mark_zero();
    directions_.take(step, shift_);
  }
  if (shaded_) {
    shaded_->wait(motion, step.from, shift_, stroke, last_line_);
    if (const Curve& curve = step.curve(); !curve.straight() && !has_frame(step)) path_.reach(box_of(chain_, curve, shift_), stroke);
  } else {
    draw(path_, step, shift_, stroke, last_line_);
  }
  here_ = to;
}

void Plot::draw(PlotPath& path, const Step& step, Vec3 shift, Stroke stroke, ProgramLine line) const {
  const Motion& motion = *step.motion();
  if (const Curve& curve = step.curve(); !curve.straight()) {
    const int pieces = std::min(curve.pieces(chord), max_arc_pieces * static_cast<int>(std::min(1 + motion.turns, 1000.0)));
    for (int i = 1; i < pieces; ++i) path.go(chain_.tip(step.from.space.get(), curve.at(double(i) / pieces)) + shift, stroke, 0, line);
    if (!has_frame(step)) path.reach(box_of(chain_, curve, shift), stroke);
  }
  path.go(chain_.tip(step.from.space.get(), motion.to) + shift, stroke, 0, line);
}

/// Processes an action of the programmed contour, and draws it if it is a motion at feed. Motions on which cutter compensation starts or
/// ends are omitted.
void Plot::follow_programmed(const Action& action) {
  if (const auto* frame = std::get_if<FrameChange>(&action.what)) {
    programmed_origin_ = work_origin_of(chain_, frame->placement);
    programmed_.take(*frame);
  }
  const auto* const motion = motion_of(action);
  if (motion == nullptr) return;
  const bool is_approach = motion->side_step == SideStep::begins || motion->side_step == SideStep::ends;
  if (motion->side != 0 && !is_approach && motion->kind != MotionKind::rapid) {
    const Vec3 from = chain_.tip(programmed_.space.get(), programmed_.work) + programmed_origin_;
    if (!has_contour_) contour_.start(from);
    else contour_.go(from, Stroke::rapid);
    has_contour_ = true;
    draw(contour_, Step(roles_, action, programmed_), programmed_origin_, Stroke::contour, line_of(action.origin));
  }
  programmed_.take(*motion);
}

void Plot::consume(const Step& step) {
  if (const Motion* const motion = step.motion()) take_motion(step, *motion);
  else if (const auto* frame = std::get_if<FrameChange>(&step.action.what)) take_frame(*frame);
}

void Plot::stop(ProgramLine line) {
  stop_ = line;
  if (line.line != 0) files_.insert(line.file);
}

/// Returns the symbols in the order of drawing. A stop comes last, so that no other symbol covers it.
std::vector<PlotMark> Plot::marks() const {
  std::vector<PlotMark> marks;
  const Vec3 here = here_ + shift_;
  if (started_) marks.push_back(start_);
  if (started_ && !stop_) marks.push_back({PlotMark::What::end, here, last_line_});
  if (stop_) marks.push_back({PlotMark::What::stop, here, *stop_});
  return marks;
}

tl::expected<void, std::string> Plot::write(const ResultFile& file, const PlotTitle& title) const {
  PlotPath contour = contour_;
  contour.move_all(-1.0 * first_origin_);
  PlotScene scene{path_, contour, zeros_, marks(), title, ShadeScale(colour_, path_), directions_.leaning()};
  scene.lathe = is_lathe(roles_);
  return draw_page(file, scene);
}

}  // namespace kadr
