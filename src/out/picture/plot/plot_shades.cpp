// Colours a path by its speed, or by what limits the speed (kadr run --colour). A motion waits until the least-time planner has computed
// its times. Then the motion is drawn in segments, each with its own shade. This file is used by out/picture/plot/plot.

#include "out/picture/plot/plot_shades.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "out/picture/canvas.h"
#include "out/picture/plot/plot_view.h"

namespace kadr {
namespace {

constexpr double shade_chord = 0.02;  // greatest distance between an arc and the straight lines that approximate it, mm
constexpr float same_shade = 0.02F;   // relative difference of shades below which they count as equal
constexpr std::size_t speed_steps = 24;
/// Colours from speed 0 to the greatest speed. The colour of slow motion is the most conspicuous one.
constexpr std::array<unsigned, 6> speed_inks = {0xB2182B, 0xE08214, 0x9A9A1F, 0x1B9E77, 0x2166AC, 0x3B1F8F};
/// Colours of the limits, in the order of the enum Limit.
constexpr std::array<unsigned, limit_count> limit_inks = {0x009E73, 0xD55E00, 0xCC79A7, 0x6A3D9A, 0xE69F00, 0x0072B2, 0x000000};

Colour between(unsigned a, unsigned b, double part) {
  const Colour from = colour(a), to = colour(b);
  const auto mixed = [part](double x, double y) { return x + part * (y - x); };
  return {mixed(from.red, to.red), mixed(from.green, to.green), mixed(from.blue, to.blue)};
}

}  // namespace

void ShadedMotions::wait(const Motion& motion, const ToolPosition& from, Vec3 shift, Stroke stroke, ProgramLine line) {
  waiting_.push_back({motion, from, shift, stroke, line, 0, 0});
}

void ShadedMotions::move_all(Vec3 by) {
  for (Waiting& motion : waiting_) motion.shift = motion.shift + by;
  held_.at = held_.at + by;
}

void ShadedMotions::take(const TimedCells& cells, const MotionLimits& limits, PlotPath& path) {
  constexpr double finest = 16;  // number of segments into which a cell is divided if its speed starts at 0
  for (std::size_t k = 0; k < cells.laws.size(); ++k) {
    const TimeLaw& law = cells.laws[k];
    if (!(law.length > 0)) continue;
    while (!waiting_.empty() && waiting_.front().number < cells.sources[k].motion) draw_rest(held_.shade, path);
    if (waiting_.empty() || waiting_.front().number > cells.sources[k].motion) continue;
    const double from = law.at(0).speed, to = law.at(1).speed;
    const bool by_speed = by_ == PlotColour::speed;
    const int pieces = by_speed ? std::max(1, static_cast<int>(finest * std::fabs(to - from) / std::max(from, to))) : 1;
    const auto limit = by_speed ? 0.0F : static_cast<float>(limited_by(cells, k, limits).limit);
    for (int i = 0; i < pieces; ++i) {
      const double middle = (i + 0.5) / pieces, end = (i + 1.0) / pieces;
      const auto shade = by_speed ? static_cast<float>(60 * shares_at(cells, k, middle, limits).speed) : limit;
      draw_to(gone_ + law.at(end).distance, shade, path);
    }
    gone_ += law.length;
  }
}

/// Draws the first waiting motion up to the distance `distance` (mm) from its start. The rest is drawn when the cells of the next motion
/// arrive.
void ShadedMotions::draw_to(double distance, float shade, PlotPath& path) {
  const Waiting& motion = waiting_.front();
  const double part = motion.distance > 0 ? std::clamp(distance / motion.distance, drawn_, 1.0) : 1;
  draw_part(motion, drawn_, part, shade, path);
  drawn_ = part;
}

/// Draws the rest of the first waiting motion. Its last cell may extend into the next motion.
void ShadedMotions::draw_rest(float shade, PlotPath& path) {
  if (drawn_ < 1) draw_part(waiting_.front(), drawn_, 1, shade, path);
  let_go(path);
  gone_ = std::max(0.0, gone_ - waiting_.front().distance);
  drawn_ = 0;
  waiting_.pop_front();
}

void ShadedMotions::draw_part(const Waiting& motion, double from, double to, float shade, PlotPath& path) {
  const Curve curve(roles_, motion.from.work, motion.motion);
  const int pieces = curve.straight() ? 1 : std::max(1, static_cast<int>(std::ceil(curve.pieces(shade_chord) * (to - from))));
  for (int i = 1; i <= pieces; ++i) {
    const double part = i == pieces ? to : from + (to - from) * i / pieces;
    keep({chain_.tip(motion.from.space.get(), curve.at(part)) + motion.shift, motion.stroke, shade, motion.line}, curve.straight(), path);
  }
}

void ShadedMotions::keep(PlotPoint point, bool may_replace, PlotPath& path) {
  const bool goes_on = may_replace && point.line == held_.line && std::fabs(point.shade - held_.shade) <= same_shade * held_.shade;
  if (!goes_on) let_go(path);
  held_ = {point.at, point.stroke, holds_ ? held_.shade : point.shade, point.line};
  holds_ = true;
}

void ShadedMotions::let_go(PlotPath& path) {
  if (holds_) path.go(held_.at, held_.stroke, held_.shade, held_.line);
  holds_ = false;
}

void ShadedMotions::finish(PlotPath& path) {
  while (!waiting_.empty()) draw_rest(held_.shade, path);
}

ShadeScale::ShadeScale(PlotColour by, const PlotPath& path) : by_(by) {
  double most = 0;
  const auto each = [&](const auto& take) {
    for (const PlotPoint& point : path.points())
      if (cuts(point.stroke)) take(point);
  };
  each([&](const PlotPoint& point) { most = std::max(most, double(point.shade)); });
  if (by == PlotColour::speed && most > 0) {
    constexpr double ticks = 5;
    const double step = round_step(most / ticks);
    top_ = step * std::ceil(most / step - 1e-3);
  }
  each([&](const PlotPoint& point) { occurs_ |= 1U << step_of(point.shade); });
}

std::size_t ShadeScale::steps() const { return by_ == PlotColour::speed ? speed_steps : limit_count; }

std::size_t ShadeScale::step_of(float shade) const {
  const double step = by_ == PlotColour::speed ? double(shade) / top_ * speed_steps : double(shade);
  return std::min(static_cast<std::size_t>(std::max(step, 0.0)), steps() - 1);
}

Colour ShadeScale::ink(std::size_t step) const {
  if (by_ != PlotColour::speed) return colour(limit_inks[step]);
  const double at = (double(step) + 0.5) / speed_steps * (speed_inks.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), speed_inks.size() - 2);
  return between(speed_inks[below], speed_inks[below + 1], at - double(below));
}

}  // namespace kadr
