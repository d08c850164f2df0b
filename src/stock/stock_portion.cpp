// What a portion of a stock contributes to the whole, and a stock that is joined from portions (class Stock).

#include <bit>
#include <cassert>

#include "stock/portion/sweep_touches.h"
#include "stock/stock.h"

namespace kadr {
namespace {

/// A number that depends on all values and on their order (FNV-1a).
struct Fingerprint {
  std::uint64_t value = 0xcbf29ce484222325;

  void take(std::uint64_t bits) {
    constexpr std::uint64_t prime = 0x100000001b3;
    value = (value ^ bits) * prime;
    value ^= value >> 32;
  }
  void take(float number) { take(std::uint64_t{std::bit_cast<std::uint32_t>(number)}); }
  void take(double number) { take(std::bit_cast<std::uint64_t>(number)); }
  void take(const float (&place)[3]) {
    for (const float number : place) take(number);
  }
};

void take_tool(const ToolShape& tool, Fingerprint& all) {
  for (const ConvexBody& body : tool.bodies)
    for (const RoundSolid& solid : body.solids) {
      all.take(std::uint64_t(body.part) << 8 | std::uint64_t(solid.form));
      for (const double size : {solid.bottom, solid.top, solid.bottom_radius, solid.top_radius}) all.take(size);
    }
  for (const InsertBody& body : tool.insert)
    for (const InsertCorner& corner : body.corners)
      for (const double size : {corner.centre.x, corner.centre.z, corner.radius}) all.take(size);
}

}  // namespace

PortionCut Stock::portion_cut() const {
  assert(is_portion_);
  PortionCut cut;
  cut.touches = touches_;
  for (std::size_t i = 0; i < removed_.size(); ++i) {
    const Removed& r = removed_[i];
    const SweepRemoval one{std::uint32_t(first_ + i), r.depth.load(std::memory_order_relaxed), r.longest.load(std::memory_order_relaxed),
                           r.length.load(std::memory_order_relaxed)};
    if (one.length != 0 || one.depth != 0 || one.longest != 0) cut.removed.push_back(one);
  }
  return cut;
}

std::vector<Touch> Stock::add_portions(const std::vector<PortionCut>& portions) {
  std::vector<Touch> touches;
  for (const PortionCut& portion : portions) {
    touches.insert(touches.end(), portion.touches.begin(), portion.touches.end());
    for (const SweepRemoval& one : portion.removed) {
      if (one.sweep < first_ || one.sweep - first_ >= removed_.size()) continue;  // of another program: its fingerprint differs
      Removed& all = removed_[one.sweep - first_];
      all.length += one.length;
      all.depth = std::max(all.depth.load(), one.depth), all.longest = std::max(all.longest.load(), one.longest);
    }
  }
  std::erase_if(touches, [&](const Touch& t) { return t.sweep < first_ || t.sweep >= sweeps_.size(); });
  return one_for_each_sweep(std::move(touches));
}

std::uint64_t Stock::fingerprint() const {
  Fingerprint all;
  for (const ToolShape& tool : tools_) take_tool(tool, all);
  each_sweep([&](std::size_t, const KeptSweep& s) {
    all.take(s.from), all.take(s.to);
    all.take(std::uint64_t(s.tool) << 2 | std::uint64_t(s.watched) << 1 | std::uint64_t(s.leans));
  });
  for (const TiltedEnds& ends : tilted_ends_) all.take(ends.from), all.take(ends.to);
  return all.value;
}

}  // namespace kadr
