#pragma once
// Cutter: one sweep of one body in one brick. Used by stock/cut/brick_cut.
//
// It finds the lines that the sweep can meet, what is swept of them (upright_rows, level_rows), and what is removed. Work on eight
// lines at once is in cutter_lanes.h, the rest in cutter.cpp.

#include "stock/cut/brick_cut.h"
#include "stock/cut/lanes.h"

namespace kadr {

namespace lanes {
template <class V>
struct Swept;
/// What is removed from the lines of one family, per lane, mm: total material, greatest height above the tip, longest piece.
template <class V>
struct Taken;
}  // namespace lanes

/// Lattice points that a sweep can meet: `first` to `last` - 1 along each axis.
struct PointRange {
  int first[3], last[3];
  bool none = false;
};

class Cutter {
 public:
  Cutter(Brick& brick, const BrickScale& scale, const LocalSweep& sweep, const SweptBody& body, std::int32_t by, CutOutcome& outcome);

  bool stays_above() const { return sweep_.lowest() + below_ >= brick_.top + margin(); }
  /// True if the whole brick is swept: it lies in the cylinder that the body contains above some height.
  bool takes_all() const;
  void clear();
  template <class V>
  void cut();
  void end();

 protected:
  /// Safety margin for skipping: the result is the same to the bit, however old the bounds of the brick are.
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
  float below_, above_;  // the body's bottom and top, from the tip, mm
};

}  // namespace kadr
