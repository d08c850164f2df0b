#pragma once
// Recovery: the corners of an offset polygon lie on offsets of the edges it was made from: lines, arcs, and circles around their
// ends. Which one each chord lies on is found here, and the path becomes exact again; its corners are the meetings of these.

#include "path/area/polygon.h"

namespace kadr::area {

/// A line or circle that chords may lie on.
struct ChannelRun {
  bool line = true;
  Vec2 point;  // of a line; centre of a circle
  Vec2 way;    // unit vector of a line
  double radius = 0;
  Bounds box;
};

class Carriers {
 public:
  /// The offsets of `source` to both sides by `by` mm, and circles of that radius around the ends; by = 0: the edges themselves.
  void add(const Edges& source, double by);

  /// The edges that the corners were made of; a chord on none of them stays a line.
  ///   law  no point of the result is farther from the polygon than 3·tol::area_chord, but for its corners
  Edges recovered(const Polygon& corners, bool closed) const;

 private:
  struct Run;
  void add(const ChannelRun& channel_run) { all_.push_back(channel_run); }
  void index() const;
  std::vector<std::uint32_t> on(Vec2 a, Vec2 b) const;
  std::vector<Run> runs(const Polygon& corners, bool closed) const;

  std::vector<ChannelRun> all_;
  mutable std::vector<std::vector<std::uint32_t>> cells_;  // by place, made when first needed
  mutable Bounds box_;
};

}  // namespace kadr::area
