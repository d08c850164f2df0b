// The blank that a program seems to be written for. For view/page_part; tested by tests/view/stock_guess_test.cpp.

#include "view/stock_guess.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double level_height = 0.25;         // mm
constexpr std::size_t most_levels = 100'000;  // what lies higher or lower than so many is no part
constexpr double mostly = 0.1;                // of the way sideways may lie above a zero that is the top of the blank
constexpr double above = 0.01;                // mm that lie in it
constexpr double margin_share = 0.05, least_margin = 1, most_margin = 5;  // of the longest side; mm
constexpr std::size_t most_places = 1000;                                 // that are looked at one by one
constexpr double same_hole = 0.5;                                         // mm
constexpr double turned_face = 1;                                         // mm that a face at Z0 is cleaned of
constexpr double in_plane = 1e-3;                                         // mm

bool at_feed(PathKind kind) {
  return kind == PathKind::feed || kind == PathKind::arc_cw || kind == PathKind::arc_ccw || kind == PathKind::thread ||
         kind == PathKind::spline;
}

void widen(std::optional<Box3>& box, Vec3 place) {
  if (!box) box = Box3{place, place};
  box->include({place, place});
}

/// To whole mm, outwards.
double down(double value) { return std::floor(value + 1e-3) + 0.0; }
double up(double value) { return std::ceil(value - 1e-3) + 0.0; }

}  // namespace

void StockGuess::take_level(Vec3 from, Vec3 to) {
  const double height = std::max(from.z, to.z);
  if (!(std::fabs(height) < 1e6)) return;
  const int level = int(std::floor(height / level_height));
  if (levels_.size() >= most_levels && !levels_.contains(level)) return;
  Level& of = levels_[level];
  of.way += std::hypot(to.x - from.x, to.y - from.y);
  of.highest = std::max(of.highest, height);
}

void StockGuess::take_way(Vec3 from, Vec3 to) {
  const bool sideways = std::hypot(to.x - from.x, to.y - from.y) > std::fabs(to.z - from.z);
  widen(all_, from), widen(all_, to);
  if (end_) widen(certain_, *end_);
  end_.reset();
  if (sideways && after_rapid_ && starts_.size() < most_places) starts_.push_back(from);
  else widen(certain_, from);
  if (sideways) end_ = to, take_level(from, to);
  else widen(certain_, to);
}

void StockGuess::take(const ViewPiece& piece) {
  for (std::size_t i = 1; i < piece.vertices.size(); ++i) {
    if (at_feed(piece.vertices[i].kind)) {
      take_way(piece.vertices[i - 1].place(), piece.vertices[i].place());
      after_rapid_ = false;
      continue;
    }
    after_rapid_ = true;
    if (!end_) continue;
    if (ends_.size() < most_places) ends_.push_back(*end_);
    else widen(certain_, *end_);
    end_.reset();
  }
}

/// Without the ways in and out beside a blank with that top.
Box3 StockGuess::cut_below(double top) const {
  std::optional<Box3> box = certain_;
  std::vector<Vec3> beside;
  for (const Vec3& start : starts_) {
    if (start.z < top - above) beside.push_back(start);
    else widen(box, start);
  }
  const auto counts = [&](Vec3 end) {
    return std::none_of(beside.begin(), beside.end(), [&](Vec3 b) { return std::hypot(b.x - end.x, b.y - end.y) < same_hole; });
  };
  for (const Vec3& end : ends_)
    if (counts(end)) widen(box, end);
  if (end_ && counts(*end_)) widen(box, *end_);
  return box.value_or(*all_);
}

/// In machine coordinates.
double StockGuess::top_of(double zero) const {
  if (levels_.empty()) return all_->least.z < zero ? zero : all_->most.z;
  double all = 0, beyond = 0;
  for (const auto& [level, of] : levels_) {
    all += of.way;
    if (of.highest > zero + above) beyond += of.way;
  }
  if (all_->least.z < zero - above && beyond <= mostly * all) return zero;
  return levels_.rbegin()->second.highest;
}

bool StockGuess::is_flat(Vec3 zero) const {
  if (!all_) return false;
  const Vec3 least = all_->least - zero, most = all_->most - zero;
  return std::fabs(least.y) < in_plane && std::fabs(most.y) < in_plane && most.z > least.z &&
         (least.x > -most_margin || most.x < most_margin);
}

std::string StockGuess::text(Vec3 zero, bool turned) const {
  if (!all_) return {};
  const double highest = top_of(zero.z);
  const Box3 box = turned ? *all_ : cut_below(highest);
  const Vec3 least = box.least - zero, most = box.most - zero, size = most - least;
  const double margin = std::clamp(margin_share * std::max({size.x, size.y, size.z}), least_margin, most_margin);
  const double bottom = down(least.z - margin);
  if (turned) {
    const double radius = std::max({std::fabs(least.x), std::fabs(most.x), std::fabs(least.y), std::fabs(most.y)});
    const double face = most.z > 0 && least.z < 0 ? turned_face : up(most.z);
    return fmt::format("cylinder:0,0,{:g},{:g},{:g}", bottom, face, 2 * up(radius));
  }
  double top = std::round((highest - zero.z) * 1000) / 1000 + 0.0;
  if (!(top > bottom)) top = bottom + 1;
  return fmt::format("box:{:g},{:g},{:g},{:g},{:g},{:g}", down(least.x - margin), down(least.y - margin), bottom, up(most.x + margin),
                     up(most.y + margin), top);
}

}  // namespace kadr
