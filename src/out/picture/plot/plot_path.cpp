// PlotPath: stores a path as a polyline with a limited number of points. When the limit is reached, points are removed with an increasing
// tolerance. It is used by out/picture/plot/plot_shades.

#include "out/picture/plot/plot_path.h"

#include <algorithm>

namespace kadr {
namespace {

// first tolerance as a fraction of the size of the path's box; it is less than a pixel in any picture
constexpr double first_tolerance_part = 1e-4;

double distance(Vec3 a, Vec3 b) { return length(a - b); }

}  // namespace

void PlotPath::start(Vec3 at) {
  last_ = {at, Stroke::rapid, 0, {}};
  pending_ = true;
}

void PlotPath::reach(const Box& box, Stroke stroke) {
  box_.take(box);
  if (cuts(stroke)) cutting_box_.take(box);
}

void PlotPath::go(Vec3 to, Stroke stroke, float shade, ProgramLine line) {
  if (pending_ && points_.empty()) keep(last_);
  box_.take(last_.at);
  box_.take(to);
  if (cuts(stroke)) {
    cutting_box_.take(last_.at);
    cutting_box_.take(to);
  }
  ++seen_;
  // If the stroke type changes, the point before the change is stored although it is within the tolerance. Otherwise the new type would
  // start at a wrong position.
  if (pending_ && stroke != last_.stroke && !points_.empty() && distance(points_.back().at, last_.at) > tolerance_ / 4) keep(last_);
  last_ = {to, stroke, shade, line};
  pending_ = tolerance_ > 0 && !points_.empty() && distance(points_.back().at, to) < tolerance_;
  if (!pending_) keep(last_);
}

void PlotPath::keep(PlotPoint point) {
  points_.push_back(point);
  pending_ = false;
  if (points_.size() >= most_) thin();
}

void PlotPath::thin() {
  const Vec3 size = box_.most - box_.least;
  tolerance_ = std::max(tolerance_, first_tolerance_part * std::max({size.x, size.y, size.z}) / 2);
  while (points_.size() > most_ / 2) {
    tolerance_ *= 2;
    std::size_t kept = 1;
    for (std::size_t i = 1; i < points_.size(); ++i)
      if (distance(points_[i].at, points_[kept - 1].at) >= tolerance_) points_[kept++] = points_[i];
    points_.resize(kept);
    // a tolerance of 0 means here that all points are equal, since the tool has never moved; one point remains
    if (tolerance_ == 0) points_.resize(1);
  }
}

void PlotPath::move_all(Vec3 by) {
  for (PlotPoint& point : points_) point.at = point.at + by;
  last_.at = last_.at + by;
  for (Box* const box : {&box_, &cutting_box_}) {
    if (box->empty) continue;
    box->least = box->least + by;
    box->most = box->most + by;
  }
}

}  // namespace kadr
