#pragma once
// The surface of a turned part for its picture: lying, with a quarter cut out where it has a bore. It is used by cli/cut_turned.

#include <cstdint>
#include <vector>

#include "stock/surface/surface.h"
#include "stock/turned/thread_groove.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

/// A tool has worked from here on.
struct TurnedStage {
  std::int32_t maker = 0;  // number of the tool in Surface::made_by
  TurnedRegion before;     // the part when the tool began
};

/// Returns a position of the part as the picture shows it: Z to the right (picture X), radius X upwards (picture Z).
constexpr Vec3 as_pictured(Vec3 at) { return {at.z, -at.y, at.x}; }

/// Returns the surface as the picture shows it. `made_by` of its points: the tool that cut there last; of_blank on the blank's surface and
/// in the section. If an edge of the region faces the axis, the quarter between the front and the top is left out, so that the front view
/// is a half section. Threads are helical grooves.
///   stages     in the order of the work
///   threads    ThreadGroove::maker is the number of the tool
///   deviation  greatest distance of the surface from the body, mm
///   longest    greatest length of an edge of its outline, mm
Surface turned_picture(const TurnedRegion& region, const std::vector<TurnedStage>& stages, const std::vector<ThreadGroove>& threads,
                       double deviation, double longest = 1e300);

}  // namespace kadr
