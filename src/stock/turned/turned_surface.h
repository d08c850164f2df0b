#pragma once
// The surface of a turned part for display: triangles, each point with the number of what made it, and sections through the axis. Threads
// are helical grooves. It is used by view/turned_part.

#include <functional>

#include "stock/surface/surface.h"
#include "stock/turned/thread_groove.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

/// A turned part as it is displayed.
struct TurnedView {
  const TurnedRegion& region;
  const std::vector<ThreadGroove>& threads;
  /// Returns the number of what made the edge between two corners of the region; -1: it is the surface of the blank.
  std::function<std::int32_t(Vec2 a, Vec2 b)> maker_of;
  double deviation = 0.01;  // greatest distance of the triangles from the body of revolution, mm
};

/// Returns the surface of the part about Z. Surface::made_by has the numbers of TurnedView::maker_of and ThreadGroove::maker. Two edges of
/// the region that meet do not share points, so that each has its colour. The surface is closed, except where a thread runs out over the
/// end of its cylinder.
Surface turned_surface(const TurnedView& part);

/// Returns the section of the part by the half plane at an angle (rad) from X, as polygons like those of the region: with the teeth of the
/// threads.
TurnedRegion turned_section(const TurnedView& part, double angle);

/// Returns the corners of the region, apart from the axis, at which the surface has an edge: where a drawing shows a line around the part.
std::vector<Vec2> turned_edges(const TurnedView& part);

}  // namespace kadr
