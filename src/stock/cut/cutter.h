#pragma once
// Cutter: removes what one body of a tool sweeps in one sweep from one brick. Used by stock/cut/brick_cut.
//
// The Cutter finds the lattice lines that the body can meet, then the interval of each line that the body sweeps (upright_rows,
// level_rows), and then removes this interval from the material. Code that handles eight lines at once, one per lane of a processor vector,
// is in cutter_lanes.h; the rest is in cutter.cpp.

#include "stock/cut/brick_cut.h"
#include "stock/cut/float_lanes.h"

namespace kadr {

namespace lanes {
template <class V>
struct Swept;
/// What a sweep removes from the lines of one family, in mm, one number for each lane: the sum of the removed lengths, the greatest height
/// of removed material above the tip, the longest removed interval.
template <class V>
struct Taken;
}  // namespace lanes

/// The lattice points that a sweep can meet: indices `first` to `last` - 1 along each axis.
struct PointRange {
  int first[3], last[3];
  bool none = false;
};

class Cutter {
 public:
  Cutter(Brick& brick, const BrickScale& scale, const LocalSweep& sweep, const SweptBody& body, std::int32_t by, CutOutcome& outcome);

  bool stays_above() const { return sweep_.lowest() + below_ >= brick_.top + margin(); }
  /// True if the sweep removes the whole brick: the brick lies inside the body's cylinder, above the body's end.
  bool takes_all() const;
  void clear();
  template <class V>
  void cut();
  void end();

 protected:
  /// Safety margin in mm for skipping material that the sweep does not reach. The height bounds of the brick may be older than its last
  /// cuts. Such bounds are too high but never too low, so skipping never changes the result.
  float margin() const { return scale_.cell * 1e-3f; }
  float lowest_over_brick() const;
  template <class V>
  void narrow_by_squares(float least_place[3], float most_place[3]) const;
  template <class V>
  PointRange range() const;
  template <class V, BodyEnd end>
  void cut_families(const PointRange& range);
  template <class V, BodyEnd end, int family>
  void cut_family(const PointRange& range);
  template <class V, int family>
  void take(BrickLines& lines, int at, const lanes::Swept<V>& swept, lanes::Taken<V>& taken);
  template <class V, int family>
  void add_taken(const lanes::Taken<V>& taken);
  void split(BrickLines& lines, int at, const float* from, const float* to);
  void watch_lanes(const BrickLines& lines, int family, int at, const float* from, const float* to) const;
  void take_further(BrickLines& lines, int family, const float* from, const float* to, const float* tips);
  void watch(int family, int line, float from, float to) const;
  float tip_over(int line) const;
  void note_upright(float from, float to, float tip);

  Brick& brick_;
  const BrickScale& scale_;
  const LocalSweep& sweep_;
  const SweptBody& body_;
  std::int32_t by_;
  CutOutcome& outcome_;
  float below_, above_;  // heights of the body's bottom and top above the tip, mm
};

}  // namespace kadr
