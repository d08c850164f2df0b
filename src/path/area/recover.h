#pragma once
// Recovery of exact paths: the corners of an offset polygon lie on offsets of the edges that it was made from: lines, arcs, and circles
// around their ends. For each chord, the carrier (the line or circle it lies on) is found here; the path becomes exact again, with the
// intersections of the carriers as its corners.

#include "path/area/polygon.h"

namespace kadr::area {

/// A carrier: a line or circle on which chords may lie.
struct ChannelRun {
  bool line = true;
  Vec2 point;  // a point of a line; the centre of a circle
  Vec2 way;    // direction of a line, a unit vector
  double radius = 0;
  Bounds box;
};

class Carriers {
 public:
  /// Adds the offsets of `source` to both sides by `by` mm, and circles of that radius around its ends; by = 0: the edges themselves.
  void add(const Edges& source, double by);

  /// Returns the edges that the corners were made from; a chord without a carrier stays a line.
  ///   law  no point of the result, except its corners, is farther from the polygon than 3·tol::area_chord
  Edges recovered(const Polygon& corners, bool closed) const;

 private:
  struct Run;
  void add(const ChannelRun& channel_run) { all_.push_back(channel_run); }
  void index() const;
  std::vector<std::uint32_t> on(Vec2 a, Vec2 b) const;
  std::vector<Run> runs(const Polygon& corners, bool closed) const;

  std::vector<ChannelRun> all_;
  mutable std::vector<std::vector<std::uint32_t>> cells_;  // carriers by position, created when first needed
  mutable Bounds box_;
};

}  // namespace kadr::area
