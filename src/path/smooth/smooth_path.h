#pragma once
// SmoothPath: a path of straight pieces in the axes' space, its corners rounded within a tolerance, so that a chain of short pieces becomes
// one smooth curve. A window of a longer path: pieces come in at the end, what is done with is forgotten.
//
//   gentle corners   all together, as wide as the place asks for (path/smooth/chain_sums, slow_width): work per piece does not depend on
//   how
//                    many are felt at a place
//   sharp corners,   each as wide as its own tolerance and its neighbours allow (path/smooth/soft_corner); where several are felt, their
//   ways near an end      add up. Ends: where the axes stand for an instant; a rounding does not reach over them

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/stop.h"
#include "path/smooth/chain_sums.h"
#include "path/smooth/slow_width.h"
#include "path/smooth/soft_corner.h"

namespace kadr {

class SmoothPath {
 public:
  explicit SmoothPath(std::size_t axes) : axes_(axes), sums_(axes) {}
  std::size_t axes() const { return axes_; }

  /// Empty: it begins here, with length 0.
  void begin(const double* at);

  /// A straight piece, if it has a length. `feed`: the greatest speed, mm/s. `tolerance`: how far the corner at its beginning may be
  /// rounded, mm; more than 0, as a corner that may not be rounded is an end of the path. `on_curve`: that corner is one of a chain of
  /// chords. `tag`: the caller's own. `paced`: from the piece before to this one the feed changes as the path does where that is rounded.
  void line_to(const double* to, double feed, double tolerance, bool on_curve, std::uint64_t tag, bool paced = false);

  /// Finds how wide the corners are rounded. Those near the end wait, but if this is all (`last`).
  ///   law  at no length is the path further from the straight pieces than the tolerance of the corners around; but where `stop` asked it
  ///        to end before, then nothing may be made of it
  void settle(bool last, StopToken stop = {});

  /// Forgets the pieces that end before a length, but for those whose corners are felt after it.
  void forget(double before);
  /// So many pieces, since it began.
  std::size_t forgotten() const { return forgotten_; }

  std::size_t pieces() const { return length_.size(); }
  bool empty() const { return length_.empty(); }
  double begins() const { return at_.front(); }
  double ends() const { return at_.back(); }
  /// Up to here it is final.
  double settled() const { return settled_; }

  double at(std::size_t vertex) const { return at_[vertex]; }
  double width(std::size_t vertex) const { return width_[vertex]; }
  /// |Δu|: 0 straight on, 2 back.
  double turn(std::size_t vertex) const { return turn_[vertex]; }
  /// The path turns back on itself there: a vertex without rounding, which none other reaches over.
  bool turns_back(std::size_t vertex) const { return turn_[vertex] > turning_back; }
  /// From a vertex where the axes stand for an instant – an end of the path, one where it turns back – to the next such one, whichever is
  /// nearer: mm, exact below `widest`. Of vertices that are settled.
  double room(std::size_t vertex) const { return room_[vertex]; }
  bool on_curve(std::size_t vertex) const { return on_curve_[vertex] != 0; }
  /// Rounded together with its neighbours, as wide as width_at() says.
  bool is_chained(std::size_t vertex) const { return is_chained_[vertex] != 0; }
  /// Of the chain's corners, at a length.
  WidthAt width_at(double s, std::size_t piece) const { return slow_.at(squeezed(s, piece)); }
  /// How far its rounding is felt at a length, to either side.
  double felt(std::size_t vertex, double s, std::size_t piece) const { return is_chained(vertex) ? width_at(s, piece).w : width_[vertex]; }
  /// Vertices, in their order, that are rounded by themselves, where it turns back, and where the feed changes.
  const std::vector<std::size_t>& marks() const { return marks_; }
  double feed(std::size_t piece) const { return feed_[piece]; }
  double tolerance(std::size_t vertex) const { return tolerance_[vertex]; }
  const double* point(std::size_t vertex) const { return point_.data() + vertex * axes_; }
  /// A unit vector.
  const double* direction(std::size_t piece) const { return direction_.data() + piece * axes_; }
  std::uint64_t tag(std::size_t piece) const { return tag_[piece]; }
  /// The piece that holds a length, looked for from `from` on.
  std::size_t piece_at(double s, std::size_t from) const;
  /// No corner at all: one straight line at one feed.
  bool is_one_line() const;

  /// Position and its first two derivatives by the length, of each axis. `piece`: piece_at(s).
  void evaluate(double s, std::size_t piece, double* x, double* x1, double* x2);

  /// The feed goes over into that of the next piece as the corner between them is rounded.
  bool is_paced(std::size_t vertex) const { return paced_[vertex] != 0 && width_[vertex] > 0; }
  /// The feed at s, mm/s, with such corners: its inverse, the time, is rounded as the axes' ways are.
  double feed_at(double s, std::size_t piece) const;

  /// How far x, the position at s, is beyond the tolerance of the corners felt there, or a part of that, as a share of it: from the
  /// straight pieces around. 0: not at all.
  double beyond(double s, std::size_t piece, const double* x, double part = 1) const;

  static constexpr double widest = SoftCorner::widest;

 private:
  static constexpr double turning_back = 2 - 1e-9;  // |Δu|
  static constexpr double squeezed_to = 40;         // mm: a piece, for what is known along it
  double squeezed(double s, std::size_t piece) const;
  ChainSums::Corners chained() const { return {at_, bend_, is_chained_}; }
  void find_ends(std::size_t first, bool last);
  bool makes_chain(std::size_t i) const;
  void tell_kinds(std::size_t first);
  void round_single_ones(std::size_t first, const StopToken& stop);
  double width_alone(std::size_t vertex) const;
  double moved(double s, std::size_t around) const;
  double moved_beside(std::size_t vertex, int side) const;
  bool overlaps(std::size_t vertex) const;
  double share_alone(std::size_t vertex) const;
  void look_at_roundings(std::size_t first);
  bool shrink(std::size_t first, std::size_t end);
  void round_chain(bool last, const StopToken& stop);
  void add_single_ways(double s, std::size_t around, double* x) const;
  double square_moved(double s, std::size_t around, double width);
  double square_beside(std::size_t vertex, double width, double most);
  double widest_in_chain(std::size_t vertex, double width);
  void open_widths();
  struct Looks {        // of a piece
    double felt, step;  // how far from its ends, how dense, mm
  };
  Looks looks(std::size_t piece, double tolerance) const;
  template <class Look>
  void beside_edges(std::size_t piece, const Look& look) const;
  double farthest(std::size_t piece);
  bool narrow(double known, bool first_round);
  void narrow_at(std::size_t piece, double over);
  double tolerance_at(double s, std::size_t piece) const;
  double squared_way_to(std::size_t piece, const double* x) const;
  template <class Take>
  void corners_near(double s, std::size_t around, double reach, const Take& take) const;

  std::size_t axes_;
  std::vector<double> point_;      // of each vertex
  std::vector<double> bend_;       // Δu of each vertex; of the ends 0
  std::vector<double> turn_;       // its length
  std::vector<double> at_;         // length at each vertex
  std::vector<double> squeezed_;   // the same, but no piece longer than squeezed_to
  std::vector<double> width_;      // of its rounding
  std::vector<double> in_chain_;   // its own limit of the chain's width; 0: not found yet
  std::vector<double> tolerance_;  // of each vertex
  std::vector<double> room_;       // of each vertex; where the axes do not stand of no meaning
  std::vector<double> direction_;  // of each piece
  std::vector<double> length_, feed_;
  std::vector<std::uint64_t> tag_;
  std::vector<char> on_curve_, paced_, is_chained_;  // of each vertex
  struct Rounding {                                  // of a vertex
    double inverse = 0;                              // of its width
    const SoftCorner* shape = nullptr;
  };
  std::vector<Rounding> roundings_;  // while it settles, of all vertices
  std::vector<double> factor_;       // likewise
  std::vector<std::size_t> marks_;
  std::vector<std::size_t> narrowed_;  // while it settles: pieces that were moved too far in the last round
  ChainSums sums_;
  SlowWidth slow_;
  double last_width_ = widest;     // that was found in the chain
  bool has_one_tolerance_ = true;  // all corners have
  double reach_ = 0;               // the widest rounding by itself
  std::size_t done_ = 0;           // vertices before are settled
  double settled_ = 0;
  std::size_t forgotten_ = 0;
};

/// The inner vertices within `reach` of s; `around`: the piece that holds it.
template <class Take>
void SmoothPath::corners_near(double s, std::size_t around, double reach, const Take& take) const {
  for (std::size_t i = around + 1; i-- > 1 && s - at_[i] < reach;) take(i);
  for (std::size_t i = around + 1; i + 1 < at_.size() && at_[i] - s < reach; ++i) take(i);
}

}  // namespace kadr
