#pragma once
// SmoothPath is a path of straight pieces in the axes' space whose corners are rounded within a tolerance, so that a chain of short pieces
// becomes one smooth curve. SmoothPath stores a window of a longer path: pieces are added at the end and removed at the start. A chain
// consists of gentle corners that are rounded together.
//
//   gentle corners           rounded together, with a width that varies along the path (path/smooth/chain_sums, slow_width): the work per
//                            piece does not depend on how many roundings overlap
//   sharp corners, and       rounded singly, each as wide as its own tolerance and its neighbours allow (path/smooth/soft_corner); where
//   several overlap, corners near an end      their displacements add up. An end is a position where the axes stop for an instant; no
//   rounding extends beyond an end

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/stop_token.h"
#include "path/smooth/chain_sums.h"
#include "path/smooth/slow_width.h"
#include "path/smooth/soft_corner.h"

namespace kadr {

class SmoothPath {
 public:
  explicit SmoothPath(std::size_t axes) : axes_(axes), sums_(axes) {}
  std::size_t axes() const { return axes_; }

  /// Clears the path. The new path starts at the position `at` with the length 0.
  void begin(const double* at);

  /// Adds a straight piece to the position `to`; a piece of zero length is ignored. `feed` is the greatest speed in mm/s. `tolerance` is
  /// how far the corner at the start of the piece may be rounded, mm. It must be above 0, because a corner that must not be rounded is an
  /// end of the path. `on_curve` is true if this corner lies between two chords of a curve. `tag` is a number whose meaning the caller
  /// defines. `paced` is true if the feed changes smoothly from the feed of the previous piece to the feed of this piece, along the
  /// rounding between the two pieces.
  void line_to(const double* to, double feed, double tolerance, bool on_curve, std::uint64_t tag, bool paced = false);

  /// Computes the widths of the roundings. If more pieces follow (`last` is false), the roundings near the end may still change later.
  ///   law  at every length the distance between the path and the straight pieces is at most the tolerance of the corners nearby; if `stop`
  ///        ended the work, the result is not valid
  void settle(bool last, StopToken stop = {});

  /// Removes the pieces that end before the length `before`, mm, except pieces whose roundings extend beyond this length.
  void forget(double before);
  /// The number of pieces that were removed since begin().
  std::size_t forgotten() const { return forgotten_; }

  std::size_t pieces() const { return length_.size(); }
  bool empty() const { return length_.empty(); }
  double begins() const { return at_.front(); }
  double ends() const { return at_.back(); }
  /// The path length, mm, up to which the path is final.
  double settled() const { return settled_; }

  double at(std::size_t vertex) const { return at_[vertex]; }
  double width(std::size_t vertex) const { return width_[vertex]; }
  /// |Δu|, the magnitude of the change of direction at a vertex: 0 if the path goes straight on, 2 if it reverses.
  double turn(std::size_t vertex) const { return turn_[vertex]; }
  /// True if the path reverses at the vertex. Such a vertex has no rounding, and no other rounding extends beyond it.
  bool turns_back(std::size_t vertex) const { return turn_[vertex] > turning_back; }
  /// The distance, mm, from the vertex to the nearest other vertex at which the axes stop for an instant: an end of the path, or a
  /// reversal. The value is exact below `widest` and valid for settled vertices only.
  double room(std::size_t vertex) const { return room_[vertex]; }
  bool on_curve(std::size_t vertex) const { return on_curve_[vertex] != 0; }
  /// True if the vertex is rounded together with its neighbours. The width of the rounding is then width_at().
  bool is_chained(std::size_t vertex) const { return is_chained_[vertex] != 0; }
  /// The width, mm, of the roundings of a chain of corners at the path length s.
  WidthAt width_at(double s, std::size_t piece) const { return slow_.at(squeezed(s, piece)); }
  /// How far, mm, the rounding of the vertex extends to either side, evaluated at the path length s.
  double felt(std::size_t vertex, double s, std::size_t piece) const { return is_chained(vertex) ? width_at(s, piece).w : width_[vertex]; }
  /// The vertices that are rounded singly, at which the path reverses, or at which the feed changes, in the order of the path.
  const std::vector<std::size_t>& marks() const { return marks_; }
  double feed(std::size_t piece) const { return feed_[piece]; }
  double tolerance(std::size_t vertex) const { return tolerance_[vertex]; }
  const double* point(std::size_t vertex) const { return point_.data() + vertex * axes_; }
  /// The direction of a piece, a unit vector.
  const double* direction(std::size_t piece) const { return direction_.data() + piece * axes_; }
  std::uint64_t tag(std::size_t piece) const { return tag_[piece]; }
  /// Returns the index of the piece that contains the path length s. The search starts at the piece `from`.
  std::size_t piece_at(double s, std::size_t from) const;
  /// True if the path is one straight line at one feed.
  bool is_one_line() const;

  /// Computes for each axis the position at the path length s and its first two derivatives with respect to the length. `piece` must be
  /// piece_at(s).
  void evaluate(double s, std::size_t piece, double* x, double* x1, double* x2);

  /// True if the feed changes smoothly along the rounding of the vertex, from the feed of the piece before the vertex to the feed of the
  /// piece after the vertex.
  bool is_paced(std::size_t vertex) const { return paced_[vertex] != 0 && width_[vertex] > 0; }
  /// Returns the feed at the path length s, mm/s. At a corner with is_paced(), the reciprocal of the feed (the time per mm) is smoothed in
  /// the same manner as the axis positions.
  double feed_at(double s, std::size_t piece) const;

  /// Checks the position `x` at the path length s. The distance of `x` from the nearby straight pieces may be at most `part` times the
  /// tolerance of the corners whose roundings cover s.
  ///   returns  by how much the distance exceeds this limit, as a fraction of the limit; 0 if the distance is within the limit
  double beyond(double s, std::size_t piece, const double* x, double part = 1) const;

  static constexpr double widest = SoftCorner::widest;

 private:
  static constexpr double turning_back = 2 - 1e-9;  // the change of direction |Δu| above which the path reverses at a vertex
  // greatest length, mm, with which a piece counts in the path length of slow_ (the width of the roundings)
  static constexpr double squeezed_to = 40;
  double squeezed(double s, std::size_t piece) const;
  ChainSums::Corners chained() const { return {at_, bend_, is_chained_}; }
  void find_ends(std::size_t first, bool last);
  bool makes_chain(std::size_t i) const;
  void classify_corners(std::size_t first);
  void round_single_ones(std::size_t first, const StopToken& stop);
  double width_alone(std::size_t vertex) const;
  double moved(double s, std::size_t around) const;
  double moved_near_vertex(std::size_t vertex, int side) const;
  bool overlaps(std::size_t vertex) const;
  double share_alone(std::size_t vertex) const;
  void look_at_roundings(std::size_t first);
  bool shrink(std::size_t first, std::size_t end);
  void round_chain(bool last, const StopToken& stop);
  void add_single_shifts(double s, std::size_t around, double* x) const;
  double square_moved(double s, std::size_t around, double width);
  double square_near_vertex(std::size_t vertex, double width, double most);
  double widest_in_chain(std::size_t vertex, double width);
  void open_widths();
  struct Looks {  // The sampling of a piece of the path.
    // `felt` is the distance from both ends of the piece within which the displacement is sampled, and `step` the distance between two
    // samples, both in mm.
    double felt, step;
  };
  Looks looks(std::size_t piece, double tolerance) const;
  template <class Look>
  void look_at_edges(std::size_t piece, const Look& look) const;
  double farthest(std::size_t piece);
  bool narrow(double known, bool first_round);
  void narrow_at(std::size_t piece, double over);
  double tolerance_at(double s, std::size_t piece) const;
  double squared_distance_to(std::size_t piece, const double* x) const;
  template <class Take>
  void corners_near(double s, std::size_t around, double reach, const Take& take) const;

  std::size_t axes_;
  std::vector<double> point_;     // coordinates of each vertex
  std::vector<double> bend_;      // change of direction Δu at each vertex, per axis; 0 at the ends of the path
  std::vector<double> turn_;      // |Δu| of each vertex
  std::vector<double> at_;        // path length at each vertex, mm
  std::vector<double> squeezed_;  // path length at each vertex, mm, if a piece longer than squeezed_to counts as squeezed_to
  std::vector<double> width_;     // width of the rounding at each vertex, mm
  // Limit in mm that the vertex sets to the width of the roundings in its chain of corners; 0: the limit is not computed yet.
  std::vector<double> in_chain_;
  std::vector<double> tolerance_;  // corner tolerance of each vertex, mm
  std::vector<double> room_;       // room() of each vertex
  std::vector<double> direction_;  // direction of each piece, a unit vector
  std::vector<double> length_, feed_;
  std::vector<std::uint64_t> tag_;
  std::vector<char> on_curve_, paced_, is_chained_;  // flags of each vertex
  struct Rounding {                                  // The rounding of one vertex of the path.
    double inverse = 0;                              // reciprocal of the width of the rounding, 1/mm
    const SoftCorner* shape = nullptr;
  };
  std::vector<Rounding> roundings_;  // one rounding per vertex; used only while settle() computes
  std::vector<double> factor_;       // used during settle()
  std::vector<std::size_t> marks_;
  // Indices of the pieces that the roundings moved farther than the tolerance in the last pass; used during settle().
  std::vector<std::size_t> narrowed_;
  ChainSums sums_;
  SlowWidth slow_;
  // width, mm, that the search for a chain of corners found at the last vertex; the search at the next vertex starts from it
  double last_width_ = widest;
  bool has_one_tolerance_ = true;  // true if all corners of the stored path have the same tolerance
  double reach_ = 0;               // the greatest width of a single rounding, mm
  std::size_t done_ = 0;           // number of vertices at the start of the path whose roundings are final
  double settled_ = 0;
  std::size_t forgotten_ = 0;
};

/// Calls `take(i)` for each inner vertex i that is closer than `reach` to the path length s. `around` is the piece that contains s.
template <class Take>
void SmoothPath::corners_near(double s, std::size_t around, double reach, const Take& take) const {
  for (std::size_t i = around + 1; i-- > 1 && s - at_[i] < reach;) take(i);
  for (std::size_t i = around + 1; i + 1 < at_.size() && at_[i] - s < reach; ++i) take(i);
}

}  // namespace kadr
