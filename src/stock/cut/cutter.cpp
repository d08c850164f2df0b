// The part of Cutter that handles lattice lines one by one: bricks that are removed as a whole, lines with several intervals, and the
// record of what was removed.

#include "stock/cut/cutter.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr int cuts_between_tops = 8;

/// Returns the least height above the body's bottom at which the body's radius is `radius`.
float height_at(const SweptBody& body, float radius) {
  const float beyond = std::max(radius - body.flat, 0.f);
  if (body.end == BodyEnd::flat) return 0;
  if (body.end == BodyEnd::cone) return beyond * body.stands;
  return body.corner - std::sqrt(std::max(body.corner * body.corner - beyond * beyond, 0.f));
}

}  // namespace

Cutter::Cutter(Brick& brick, const BrickScale& scale, const LocalSweep& sweep, const SweptBody& body, std::int32_t by, CutOutcome& outcome)
    : brick_(brick),
      scale_(scale),
      sweep_(sweep),
      body_(body),
      by_(by),
      outcome_(outcome),
      below_(body.turned ? -body.top : body.bottom),
      above_(body.turned ? -body.bottom : body.top) {}

/// Returns the lowest height of the body's bottom while the body passes the brick.
float Cutter::lowest_over_brick() const {
  const LocalSweep& s = sweep_;
  const float half = scale_.edge / 2, along_plane = (half - s.from[0]) * s.flat_direction[0] + (half - s.from[1]) * s.flat_direction[1];
  const float along_path = along_plane * s.per_flat * s.per_flat, around = (body_.radius + scale_.edge * 0.7072f) * s.per_flat;
  const float first = std::clamp(along_path - around, 0.f, s.length), last = std::clamp(along_path + around, 0.f, s.length);
  return below_ + (s.upright ? s.lowest() : s.from[2] + std::min(s.direction[2] * first, s.direction[2] * last));
}

bool Cutter::takes_all() const {
  if (body_.turned || sweep_.upright) return false;
  const float half = scale_.edge / 2, x = half - sweep_.from[0], y = half - sweep_.from[1];
  const float nearest = (x * sweep_.flat_direction[0] + y * sweep_.flat_direction[1]) * sweep_.per_flat * sweep_.per_flat;
  const float at = std::clamp(nearest, 0.f, sweep_.length);
  const float far_x = std::fabs(x - at * sweep_.flat_direction[0]) + half, far_y = std::fabs(y - at * sweep_.flat_direction[1]) + half;
  const float radius = std::sqrt(far_x * far_x + far_y * far_y), tip = sweep_.from[2] + sweep_.direction[2] * at;
  if (radius >= body_.radius || scale_.edge - tip > body_.top) return false;
  return tip + body_.bottom + height_at(body_, radius) <= 0;
}

void Cutter::clear() {
  BrickLines& upright = brick_.family[2];
  for (int i = 0; i < brick_lines; ++i) {
    if (!(upright.from[i] < upright.to[i])) continue;
    outcome_.length += double(upright.to[i]) - double(upright.from[i]);
    note_upright(upright.from[i], upright.to[i], tip_over(i));
  }
  for (const FurtherInterval& f : upright.further) {
    outcome_.length += double(f.to) - double(f.from);
    note_upright(f.from, f.to, tip_over(f.line));
  }
  for (int family = 0; family < 3; ++family) {
    BrickLines& lines = brick_.family[std::size_t(family)];
    if (outcome_.watched != nullptr) {
      for (int i = 0; i < brick_lines; ++i)
        if (lines.from[i] < lines.to[i]) watch(family, i, lines.from[i], lines.to[i]);
      for (const FurtherInterval& f : lines.further) watch(family, f.line, f.from, f.to);
    }
    std::fill(lines.from, lines.from + brick_lines, -1.f), std::fill(lines.to, lines.to + brick_lines, -1.f);
    lines.further.clear();
  }
  brick_.top_of_square.fill(-1.f);
  brick_.top = -1;
  outcome_.changed = true;
}

void Cutter::end() {
  if (outcome_.changed && ++brick_.cuts_since >= cuts_between_tops) refresh_tops(brick_, scale_.cell);
}

/// Returns the height of the tip when the body is lowest over a lattice line along Z. This is exact for a flat end; for other ends, the
/// tip's height at the position nearest to the line is used.
float Cutter::tip_over(int line) const {
  const LocalSweep& s = sweep_;
  const float x = scale_.place[line % brick_edge] - s.from[0], y = scale_.place[line / brick_edge] - s.from[1];
  const float nearest = (x * s.flat_direction[0] + y * s.flat_direction[1]) * (s.per_flat * s.per_flat);
  const float aside = x * s.flat_direction[1] - y * s.flat_direction[0], apart = aside * s.per_flat;
  const float half = std::sqrt(std::max(body_.flat * body_.flat - apart * apart, 0.f)) * s.per_flat;
  const float lowest = s.direction[2] > 0.f ? nearest - half : nearest + half;
  return s.rise == 0.f ? s.from[2] : std::min(std::max(lowest, 0.f), s.length) * s.direction[2] + s.from[2];
}

/// Records an interval removed from a lattice line along Z.
void Cutter::note_upright(float from, float to, float tip) {
  outcome_.longest = std::max(outcome_.longest, to - from);
  outcome_.depth = std::max(outcome_.depth, to - tip);
}

void Cutter::watch(int family, int line, float from, float to) const {
  if (to - from < outcome_.least_piece) return;
  RemovedBox& box = *outcome_.watched;
  const auto around = [&](int axis, float low, float high) {
    box.least[axis] = std::min(box.least[axis], low);
    box.most[axis] = std::max(box.most[axis], high);
  };
  const float lane = scale_.place[line % brick_edge], row = scale_.place[line / brick_edge];
  around(family, from, to);
  around((family + 1) % 3, lane, lane);
  around((family + 2) % 3, row, row);
}

void Cutter::watch_lanes(const BrickLines& lines, int family, int at, const float* from, const float* to) const {
  for (int i = 0; i < lanes::lane_count; ++i) {
    const float low = std::max(from[i], lines.from[at + i]), high = std::min(to[i], lines.to[at + i]);
    if (low < high) watch(family, at + i, low, high);
  }
}

/// Handles lattice lines on which the sweep removes the middle of the first interval of material: the lower part remains the first
/// interval, and the upper part is added to the further intervals.
void Cutter::split(BrickLines& lines, int at, const float* from, const float* to) {
  for (int i = 0; i < lanes::lane_count; ++i) {
    if (!(from[i] > lines.from[at + i] && to[i] < lines.to[at + i] && from[i] < to[i])) continue;
    lines.further.push_back({at + i, to[i], lines.to[at + i], by_, lines.to_by[at + i]});
    lines.to[at + i] = from[i];
    lines.to_by[at + i] = by_;
  }
}

/// Removes the swept intervals from the further intervals (the second and later ones) of the lines.
void Cutter::take_further(BrickLines& lines, int family, const float* from, const float* to, const float* tips) {
  std::vector<FurtherInterval>& further = lines.further;
  const std::size_t count = further.size();
  for (std::size_t k = 0; k < count; ++k) {
    const float a = from[further[k].line], b = to[further[k].line], low = further[k].from, high = further[k].to;
    if (!(a < b && a < high && b > low)) continue;
    outcome_.changed = true;
    const float first = std::max(a, low), last = std::min(b, high);
    if (family == 2) outcome_.length += double(last) - double(first);
    if (family == 2) note_upright(first, last, tips[further[k].line]);
    outcome_.longest = std::max(outcome_.longest, last - first);
    if (outcome_.watched != nullptr) watch(family, further[k].line, first, last);
    if (a <= low && b >= high) {
      further[k].to = further[k].from;
    } else if (a <= low) {
      further[k].from = b, further[k].from_by = by_;
    } else if (b >= high) {
      further[k].to = a, further[k].to_by = by_;
    } else {
      const FurtherInterval above{further[k].line, b, high, by_, further[k].to_by};
      further[k].to = a, further[k].to_by = by_;
      further.push_back(above);
    }
  }
  std::erase_if(further, [](const FurtherInterval& f) { return f.to <= f.from; });
}

}  // namespace kadr
