// Proposes a blank for a program (StockGuess). Used by view/page/page_part; tested by tests/view/stock_guess_test.cpp.

#include "view/stock_guess.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double level_height = 0.25;        // height of a level in mm; the heights of the path are divided into these levels
constexpr std::size_t max_levels = 100'000;  // greatest number of levels; a path with more levels is not the path of a part
constexpr double mostly = 0.1;               // greatest fraction of the sideways travel that may be above Z0, if Z0 is the top of the blank
constexpr double above = 0.01;               // limit in mm: heights that differ by less than this count as equal
// Margin as a fraction of the longest side, and the limits of this margin in mm.
constexpr double margin_share = 0.05, least_margin = 1, max_margin = 5;
constexpr std::size_t max_places = 1000;  // greatest number of positions that are checked one by one
// Limit in mm: if the distance between the end of a path and a descent of the tool is less than this, both are in the same hole.
constexpr double same_hole = 0.5;
constexpr double in_plane = 1e-3;  // tolerance in mm within which a path counts as in one plane

bool at_feed(PathKind kind) {
  return kind == PathKind::feed || kind == PathKind::arc_cw || kind == PathKind::arc_ccw || kind == PathKind::thread ||
         kind == PathKind::spline;
}

void widen(std::optional<Box3>& box, const Box3& by) {
  if (!box) box = by;
  box->include(by);
}

Box3 grown(const Box3& box, double by) {
  return {{box.least.x - by, box.least.y - by, box.least.z}, {box.most.x + by, box.most.y + by, box.most.z}};
}

/// Extends `box` in X and Y so that it contains the sides of `other`.
void take_sides(Box3& box, const Box3& other) {
  box.least.x = std::min(box.least.x, other.least.x), box.least.y = std::min(box.least.y, other.least.y);
  box.most.x = std::max(box.most.x, other.most.x), box.most.y = std::max(box.most.y, other.most.y);
}

/// Reduces the box `wide` so that a tool of the given radius at the position `at` does not touch the box. `cut` is the box around the
/// material that is cut; if `at` is inside this box, nothing changes.
void end_before(Box3& wide, const Box3& cut, Vec3 at, double radius) {
  const double left = cut.least.x - at.x, right = at.x - cut.most.x, front = cut.least.y - at.y, back = at.y - cut.most.y;
  const double farthest = std::max({left, right, front, back});
  if (farthest <= 0) return;
  if (farthest == left) wide.least.x = std::max(wide.least.x, at.x + radius);
  else if (farthest == right) wide.most.x = std::min(wide.most.x, at.x - radius);
  else if (farthest == front) wide.least.y = std::max(wide.least.y, at.y + radius);
  else wide.most.y = std::min(wide.most.y, at.y - radius);
}

/// Writes a box for `--stock`, without the noise of a conversion from inches.
std::string box_text(const Box3& box) {
  const auto plain = [](double value) { return fmt::format("{:g}", std::round(value * 1e4) / 1e4 + 0.0); };
  return fmt::format("box:{},{},{},{},{},{}", plain(box.least.x), plain(box.least.y), plain(box.least.z), plain(box.most.x),
                     plain(box.most.y), plain(box.most.z));
}

/// down() and up() round to whole mm, so that a box becomes larger: least values are rounded down, greatest values up.
double down(double value) { return std::floor(value + 1e-3) + 0.0; }
double up(double value) { return std::ceil(value - 1e-3) + 0.0; }

}  // namespace

void StockGuess::take_level(Vec3 from, Vec3 to) {
  const double height = std::max(from.z, to.z);
  if (!(std::fabs(height) < 1e6)) return;
  const int level = int(std::floor(height / level_height));
  if (levels_.size() >= max_levels && !levels_.contains(level)) return;
  Level& of = levels_[level];
  of.path_length += std::hypot(to.x - from.x, to.y - from.y);
  of.highest = std::max(of.highest, height);
}

void StockGuess::widen(Boxes& boxes, const Place& place) {
  const Box3 here{place.at, place.at};
  boxes.try_emplace(place.tool, here).first->second.include(here);
}

void StockGuess::take_path(Place from, Place to) {
  const bool sideways = std::hypot(to.at.x - from.at.x, to.at.y - from.at.y) > std::fabs(to.at.z - from.at.z);
  kadr::widen(all_, {from.at, from.at}), kadr::widen(all_, {to.at, to.at});
  if (end_) widen(certain_, *end_);
  end_.reset();
  if (sideways && after_rapid_ && starts_.size() < max_places) starts_.push_back(from);
  else widen(certain_, from);
  if (sideways) end_ = to, take_level(from.at, to.at);
  else widen(certain_, to);
}

void StockGuess::take(const ViewPiece& piece) {
  for (std::size_t i = 1; i < piece.vertices.size(); ++i) {
    const PathVertex& to = piece.vertices[i];
    if (at_feed(to.kind)) {
      take_path({piece.vertices[i - 1].place(), to.tool}, {to.place(), to.tool});
      after_rapid_ = false;
      continue;
    }
    after_rapid_ = true;
    if (!end_) continue;
    if (ends_.size() < max_places) ends_.push_back(*end_);
    else widen(certain_, *end_);
    end_.reset();
  }
}

/// Returns the material that the program cuts if the top of the blank is at the height `top`: the path at feed, without the paths on which
/// the tool descends outside the blank.
StockGuess::Cut StockGuess::cut_below(double top) const {
  Cut cut{certain_, {}};
  for (const Place& start : starts_) {
    if (start.at.z < top - above) cut.outside.push_back(start);
    else widen(cut.boxes, start);
  }
  const auto counts = [&](const Place& end) {
    return std::none_of(cut.outside.begin(), cut.outside.end(),
                        [&](const Place& b) { return std::hypot(b.at.x - end.at.x, b.at.y - end.at.y) < same_hole; });
  };
  for (const Place& end : ends_)
    if (counts(end)) widen(cut.boxes, end);
  if (end_ && counts(*end_)) widen(cut.boxes, *end_);
  if (cut.boxes.empty()) cut.boxes[0] = *all_, cut.outside.clear();
  return cut;
}

/// Returns the machine coordinate Z of the top of the blank. `zero` is the machine coordinate Z of the work zero.
double StockGuess::top_of(double zero) const {
  if (levels_.empty()) return all_->least.z < zero ? zero : all_->most.z;
  double all = 0, beyond = 0;
  for (const auto& [level, of] : levels_) {
    all += of.path_length;
    if (of.highest > zero + above) beyond += of.path_length;
  }
  if (all_->least.z < zero - above && beyond <= mostly * all) return zero;
  return levels_.rbegin()->second.highest;
}

bool StockGuess::is_flat(Vec3 zero) const {
  if (!all_) return false;
  const Vec3 least = all_->least - zero, most = all_->most - zero;
  return std::fabs(least.y) < in_plane && std::fabs(most.y) < in_plane && most.z > least.z &&
         (least.x > -max_margin || most.x < max_margin);
}

std::string StockGuess::text(Vec3 zero, bool turned, const RadiusOf& radius_of, const BlankHints& hints) const {
  if (!all_) return {};
  const double highest = top_of(zero.z);
  const Cut cut = turned ? Cut{{{0, *all_}}, {}} : cut_below(highest);
  std::optional<Box3> whole, swept;
  for (const auto& [tool, box] : cut.boxes)
    kadr::widen(whole, box), kadr::widen(swept, grown(box, turned || !radius_of ? 0 : radius_of(tool)));
  const Vec3 size = whole->most - whole->least;
  const double margin = std::clamp(margin_share * std::max({size.x, size.y, size.z}), least_margin, max_margin);
  Box3 blank = grown(*whole, margin), wide = grown(*swept, least_margin);
  for (const Place& one : cut.outside) end_before(wide, *whole, one.at, radius_of ? radius_of(one.tool) : 0);
  take_sides(blank, wide);
  const Vec3 least = whole->least - zero, most = whole->most - zero;
  const double bottom = down(least.z - margin);
  if (turned) {
    const double radius = std::max({std::fabs(least.x), std::fabs(most.x), std::fabs(least.y), std::fabs(most.y)});
    return turned_blank_text(hints.turned, {radius, least.z, most.z}, margin);
  }
  double top = std::round((highest - zero.z) * 1000) / 1000 + 0.0;
  if (hints.box && hints.box->cylinder) {
    const auto& [diameter, low, high] = *hints.box->cylinder;
    return fmt::format("cylinder:0,0,{:g},{:g},{:g}", low, high, diameter);
  }
  if (hints.box) return box_text(placed_box(hints.box->size, {least, most}, top));
  if (!(top > bottom)) top = bottom + 1;
  return fmt::format("box:{:g},{:g},{:g},{:g},{:g},{:g}", down(blank.least.x - zero.x), down(blank.least.y - zero.y), bottom,
                     up(blank.most.x - zero.x), up(blank.most.y - zero.y), top);
}

}  // namespace kadr
