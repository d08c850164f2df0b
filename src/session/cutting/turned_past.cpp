// Computes earlier states of a turned part. Used by view/turned_part; tested by tests/view/turned_part_test.cpp.

#include "session/cutting/turned_past.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr std::size_t first_between = 256;  // removals between kept regions: some 10 ms of work
constexpr double same_edge = 5e-5;          // mm; an edge this near to the boundary of a swept area was made by it

double off_edge(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double square = dot(d, d), part = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return length(a + part * d - p);
}

double off_boundary(Vec2 p, const TurnedPolygon& polygon) {
  double least = 1e300;
  for (std::size_t i = 0; i < polygon.size(); ++i) least = std::min(least, off_edge(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  return least;
}

/// Returns the fraction of a motion that has been executed at an instant.
double share_at(double instant, double begins, double seconds) {
  return seconds > 0 ? std::clamp((instant - begins) / seconds, 0.0, 1.0) : instant >= begins ? 1 : 0;
}

}  // namespace

TurnedPast::TurnedPast(TurnedRegion blank, std::size_t most_bytes) : most_bytes_(most_bytes), between_(first_between) {
  kept_bytes_ = bytes_of(blank);
  kept_.push_back({0, std::move(blank)});
}

std::size_t TurnedPast::bytes_of(const TurnedRegion& region) {
  std::size_t bytes = sizeof(Kept);
  for (const TurnedPolygon& polygon : region) bytes += sizeof(TurnedPolygon) + polygon.size() * sizeof(Vec2);
  return bytes;
}

std::size_t TurnedPast::bytes() const {
  return kept_bytes_ + removals_.size() * (sizeof(TurnedRemoval) + sizeof(Box)) + threads_.size() * sizeof(TurnedThread);
}

void TurnedPast::add(const TurnedRemoval& removal, const TurnedStock& now) {
  removals_.push_back(removal);
  Box box{{1e300, 1e300}, {-1e300, -1e300}};
  for (const Vec2 p : removal.body->swept(removal.from, removal.to)) {
    box.least = {std::min(box.least.x, p.x), std::min(box.least.y, p.y)};
    box.most = {std::max(box.most.x, p.x), std::max(box.most.y, p.y)};
  }
  boxes_.push_back(box);
  if (removals_.size() < kept_.back().removals + between_) return;
  kept_.push_back({removals_.size(), now.region()});
  kept_bytes_ += bytes_of(kept_.back().region);
  if (kept_bytes_ <= most_bytes_ || kept_.size() < 3) return;
  std::vector<Kept> fewer;
  kept_bytes_ = 0;
  for (std::size_t i = 0; i < kept_.size(); i += 2) {
    kept_bytes_ += bytes_of(kept_[i].region);
    fewer.push_back(std::move(kept_[i]));
  }
  kept_ = std::move(fewer);
  between_ *= 2;
}

void TurnedPast::add(const TurnedThread& thread) { threads_.push_back(thread); }

void TurnedPast::finish(const TurnedStock& end) {
  kept_.push_back({removals_.size(), end.region()});
  end_volume_ = end.volume();
}

TurnedPast::Then TurnedPast::at(double instant) const {
  Then then;
  then.instant = instant;
  const auto over = [&](const TurnedRemoval& r) { return r.begins + r.seconds <= instant; };
  const auto begun = [&](const TurnedRemoval& r) { return r.begins < instant || over(r); };
  const auto whole = std::size_t(std::partition_point(removals_.begin(), removals_.end(), over) - removals_.begin());
  then.removals = std::size_t(std::partition_point(removals_.begin(), removals_.end(), begun) - removals_.begin());
  auto from = std::partition_point(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.removals <= whole; });
  --from;
  if (from->removals == removals_.size() && end_volume_) {
    then.region = from->region, then.volume = *end_volume_;
  } else {
    TurnedStock stock(from->region);
    for (std::size_t i = from->removals; i < then.removals; ++i) {
      const TurnedRemoval& r = removals_[i];
      stock.remove(r.body->swept(r.from, r.from + share_at(instant, r.begins, r.seconds) * (r.to - r.from)));
    }
    then.region = stock.region(), then.volume = stock.volume();
  }
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    const TurnedThread& thread = threads_[i];
    const double share = share_at(instant, thread.begins, thread.seconds);
    if (!(share > 0)) continue;
    ThreadGroove groove = thread.groove;
    groove.to = groove.from + share * (groove.to - groove.from);
    groove.maker = std::int32_t(removals_.size() + i);
    then.threads.push_back(std::move(groove));
  }
  return then;
}

std::int32_t TurnedPast::maker_of(Vec2 a, Vec2 b, const Then& then) const {
  const Vec2 middle = 0.5 * (a + b);
  const Vec2 places[2] = {middle, {-middle.x, middle.y}};  // what lies below radius 0 cuts above
  for (std::size_t i = then.removals; i-- > 0;) {
    const Box& box = boxes_[i];
    for (const Vec2 p : places) {
      if (p.x < box.least.x - same_edge || p.x > box.most.x + same_edge || p.y < box.least.y - same_edge || p.y > box.most.y + same_edge)
        continue;
      const TurnedRemoval& r = removals_[i];
      const Vec2 end = r.from + share_at(then.instant, r.begins, r.seconds) * (r.to - r.from);
      if (off_boundary(p, r.body->swept(r.from, end)) <= same_edge) return std::int32_t(i);
    }
  }
  return -1;
}

TurnedPast::Maker TurnedPast::who(std::int32_t maker) const {
  if (maker < 0) return {};
  const auto i = std::size_t(maker);
  if (i < removals_.size()) return {removals_[i].origin, removals_[i].tool};
  return {threads_[i - removals_.size()].origin, threads_[i - removals_.size()].tool};
}

}  // namespace kadr
