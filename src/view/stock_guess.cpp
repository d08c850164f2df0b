// The blank that a program seems to be written for. For view/page_part; tested by tests/view/stock_guess_test.cpp.

#include "view/stock_guess.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double level_height = 0.25;          // mm
constexpr std::size_t most_levels = 100'000;   // what lies higher or lower than so many is no part
constexpr double mostly = 0.1;                 // of the way sideways may lie above a zero that is the top of the blank
constexpr double above = 0.01;                 // mm that lie in it
constexpr double margin_share = 0.05, least_margin = 1, most_margin = 5;  // of the longest side; mm
constexpr double in_plane = 1e-3;              // mm

bool at_feed(PathKind kind) {
  return kind == PathKind::feed || kind == PathKind::arc_cw || kind == PathKind::arc_ccw || kind == PathKind::thread || kind == PathKind::spline;
}

Vec3 place(const PathVertex& v) { return {double(v.at[0]), double(v.at[1]), double(v.at[2])}; }

/// To whole mm, outwards.
double down(double value) { return std::floor(value + 1e-3) + 0.0; }
double up(double value) { return std::ceil(value - 1e-3) + 0.0; }

}  // namespace

void StockGuess::take(const ViewPiece& piece) {
  for (std::size_t i = 1; i < piece.vertices.size(); ++i) {
    if (!at_feed(piece.vertices[i].kind)) continue;
    const Vec3 from = place(piece.vertices[i - 1]), to = place(piece.vertices[i]), way = to - from;
    const Box3 both{{std::min(from.x, to.x), std::min(from.y, to.y), std::min(from.z, to.z)},
                    {std::max(from.x, to.x), std::max(from.y, to.y), std::max(from.z, to.z)}};
    if (!any_) box_ = both;
    box_.include(both);
    any_ = true;
    const double sideways = std::hypot(way.x, way.y);
    if (!(sideways > std::fabs(way.z)) || !(std::fabs(both.most.z) < 1e6)) continue;
    const int level = int(std::floor(both.most.z / level_height));
    if (levels_.size() >= most_levels && !levels_.contains(level)) continue;
    Level& of = levels_[level];
    of.way += sideways;
    of.highest = std::max(of.highest, both.most.z);
  }
}

/// In machine coordinates.
double StockGuess::top_of(double zero) const {
  if (levels_.empty()) return box_.least.z < zero ? zero : box_.most.z;
  double all = 0, beyond = 0;
  for (const auto& [level, of] : levels_) {
    all += of.way;
    if (of.highest > zero + above) beyond += of.way;
  }
  if (box_.least.z < zero - above && beyond <= mostly * all) return zero;
  return levels_.rbegin()->second.highest;
}

bool StockGuess::is_flat(Vec3 zero) const {
  const Vec3 least = box_.least - zero, most = box_.most - zero;
  return any_ && std::fabs(least.y) < in_plane && std::fabs(most.y) < in_plane && most.z > least.z && (least.x > -most_margin || most.x < most_margin);
}

std::string StockGuess::text(Vec3 zero, bool turned) const {
  if (!any_) return {};
  const Vec3 size = box_.most - box_.least;
  const double margin = std::clamp(margin_share * std::max({size.x, size.y, size.z}), least_margin, most_margin);
  const Vec3 least = box_.least - zero, most = box_.most - zero;
  const double bottom = down(least.z - margin);
  if (turned) {
    const double radius = std::max({std::fabs(least.x), std::fabs(most.x), std::fabs(least.y), std::fabs(most.y)});
    const double face = most.z > 0 && least.z < 0 ? margin_share * 20 : up(most.z);
    return fmt::format("cylinder:0,0,{:g},{:g},{:g}", bottom, face, 2 * up(radius));
  }
  double top = top_of(zero.z) - zero.z;
  top = std::round(top * 1000) / 1000 + 0.0;
  if (!(top > bottom)) top = bottom + 1;
  return fmt::format("box:{:g},{:g},{:g},{:g},{:g},{:g}", down(least.x - margin), down(least.y - margin), bottom, up(most.x + margin),
                     up(most.y + margin), top);
}

}  // namespace kadr
