// SmoothPath, the widths of its roundings. This file determines which corners are rounded together, and computes the widths in the chain of
// gentle corners.

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.h"
#include "path/smooth/smooth_path.h"
#include "path/smooth/soft_corner.h"

namespace kadr {
namespace {

// The change of direction |Δu| below which two pieces count as collinear. The value allows for rounding errors.
constexpr double straight_on = 1e-12;
constexpr double sharp = 0.3;  // The change of direction |Δu| from which a corner is rounded singly.
// A corner and its neighbour form a chain if the |Δu| of the neighbour is at least this fraction of the |Δu| of the corner.
constexpr double alike = 0.1;
// Relative difference of feeds that count as equal. Small differences occur because a feed is calculated as length / time.
constexpr double feed_alike = 1e-6;
// Fraction of the tolerance that the roundings of a chain of corners use. The rest is a reserve for the positions between the samples.
constexpr double used_by_chain = 0.95;
// Distance in mm by which the path must be known beyond a corner of a chain before the width of this corner can be computed.
constexpr double felt_ahead = 2.5 * SoftCorner::widest;

}  // namespace

/// Computes room_: for each vertex the distance, mm, to the nearest other vertex at which the axes stop for an instant.
void SmoothPath::find_ends(std::size_t first, bool last) {
  const std::size_t vertices = at_.size();
  double edge = 0;  // path length of the last stop, mm; no rounding extends beyond a stop
  for (std::size_t i = first; i-- > 0 && edge == 0 && at_[first] - at_[i] < widest;)
    if (turns_back(i)) edge = at_[i];
  for (std::size_t i = first; i + 1 < vertices; ++i) {
    room_[i] = at_[i] - edge;
    if (turns_back(i)) edge = at_[i];
  }
  room_.back() = at_.back() - edge;
  edge = last ? at_.back() : at_.back() + widest;
  for (std::size_t i = vertices - 1; i-- > first;) {
    room_[i] = std::min(room_[i], edge - at_[i]);
    if (turns_back(i)) edge = at_[i];
  }
  if (first == 1) room_[0] = edge - at_[0];
}

/// Returns true for a gentle corner that is not near a stop and whose rounding extends over another corner with a similar |Δu|.
bool SmoothPath::makes_chain(std::size_t i) const {
  if (turn_[i] > sharp || room_[i] < widest) return false;
  const double reach = std::min(widest, width_alone(i));
  bool any = false;
  corners_near(at_[i], i, reach, [&](std::size_t k) { any = any || (k != i && turn_[k] <= sharp && turn_[k] >= alike * turn_[i]); });
  return any;
}

void SmoothPath::classify_corners(std::size_t first) {
  marks_.erase(std::lower_bound(marks_.begin(), marks_.end(), first), marks_.end());
  for (std::size_t i = first; i + 1 < at_.size(); ++i) {
    const bool bends = turn_[i] > straight_on;
    is_chained_[i] = bends && makes_chain(i) ? 1 : 0;
    if (is_chained_[i] == 0) width_[i] = in_chain_[i] = 0;
    const bool other_feed = std::fabs(feed_[i] - feed_[i - 1]) > feed_alike * (feed_[i] + feed_[i - 1]);
    if ((bends && is_chained_[i] == 0) || other_feed) marks_.push_back(i);
  }
}

void SmoothPath::settle(bool last, StopToken stop) {
  const std::size_t first = std::max<std::size_t>(done_, 1);
  const auto [least, most] = std::minmax_element(tolerance_.begin() + (tolerance_.size() > 1 ? 1 : 0), tolerance_.end() - 1);
  has_one_tolerance_ = tolerance_.size() <= 2 || *least == *most;
  find_ends(first, last);
  classify_corners(first);
  sums_.forget();
  round_single_ones(first, stop);
  round_chain(last, stop);
  const double ahead = felt_ahead + SlowWidth::felt();
  settled_ = last ? at_.back() : std::max(settled_, at_.back() - ahead);
  slow_.settle(squeezed(settled_, piece_at(settled_, 0)));
  while (done_ < at_.size() && (last || at_[done_] < settled_ + widest)) ++done_;
}

/// Returns the squared displacement of the path, mm², at the path length s if the roundings of the chain of corners have the given width.
double SmoothPath::square_moved(double s, std::size_t around, double width) {
  std::array<double, max_axes> sum{};
  sums_.move(chained(), s, width, sum.data());
  if (reach_ > 0) add_single_shifts(s, around, sum.data());
  double squares = 0;
  for (std::size_t a = 0; a < axes_; ++a) squares += sum[a] * sum[a];
  return squares;
}

/// Returns the greatest squared displacement, mm², at a vertex and at positions near the vertex. The positions depend on the given width.
/// The search ends as soon as a squared displacement exceeds `most`.
double SmoothPath::square_near_vertex(std::size_t vertex, double width, double most) {
  // The distance of a single corner's greatest outward deviation from the corner, as a fraction of the width.
  constexpr double flank = 0.65;
  const double s = at_[vertex], after = length_[vertex], before = length_[vertex - 1];
  double square = square_moved(s, vertex, width);
  if (square <= most && after > 0.25 * width) square = std::max(square, square_moved(s + after / 2, vertex, width));
  if (square <= most && after > 0.8 * width) {
    square = std::max(square, square_moved(s + std::min(after / 4, flank * width), vertex, width));
    square = std::max(square, square_moved(s + (after * 0.75 > 1.5 * width ? flank * width : after * 0.75), vertex, width));
  }
  if (square <= most && before > 0.8 * width)
    square = std::max(square, square_moved(s - std::min(flank * width, before / 2), vertex - 1, width));
  return square;
}

/// Returns the greatest width, mm, of the roundings of a chain of corners at which the path keeps the tolerance at a vertex. The search
/// starts at `width`.
double SmoothPath::widest_in_chain(std::size_t vertex, double width) {
  constexpr double narrowest = 1e-4;  // least width of a rounding, mm
  // The search for the width ends when the squared displacement exceeds this fraction of the squared tolerance.
  constexpr double enough = 0.98;
  constexpr double max_growth = 1.19, least_growth = 1.002;
  const double allowed = used_by_chain * tolerance_[vertex], most = allowed * allowed;
  const auto towards = [&](double square) {
    return 0.997 * std::sqrt(std::sqrt(most / square));
  };  // The displacement of the path grows with the square of the width of the roundings.
  double square = square_near_vertex(vertex, width, most);
  if (square > most) {
    while (square > most && width > narrowest) {
      width *= std::clamp(towards(square), 0.5, 0.998);
      square = square_near_vertex(vertex, width, most);
    }
    return width;
  }
  while (width < widest && square < enough * most) {
    const double wider = std::min(widest, width * std::clamp(towards(square + 1e-30), least_growth, max_growth));
    square = square_near_vertex(vertex, wider, most);
    if (square > most) break;
    width = wider;
    // The vertices are so close that the search at the next vertex continues from this width. The search at this vertex therefore ends.
    if (length_[vertex - 1] < 0.25 * width) break;
  }
  return width;
}

void SmoothPath::open_widths() {
  slow_.open(squeezed_.back());
  for (std::size_t i = done_ > 0 ? done_ - 1 : 0; i-- > 1 && at_[i] > settled_ - widest;) {
    if (in_chain_[i] > 0) slow_.limit(squeezed_[i], in_chain_[i]);
  }
  for (std::size_t i = std::max<std::size_t>(done_, 2) - 1; i + 1 < at_.size(); ++i)
    if (in_chain_[i] > 0) slow_.limit(squeezed_[i], in_chain_[i]);
  slow_.close();
}

/// Rounds the corners of all chains (corners that are rounded together) in three steps. First each corner becomes as wide as its tolerance
/// allows. Then the width is smoothed along the path. Finally the width is reduced where the path still exceeds the tolerance.
void SmoothPath::round_chain(bool last, const StopToken& stop) {
  constexpr int max_rounds = 30;
  const double known = last ? at_.back() : at_.back() - felt_ahead;
  for (std::size_t i = std::max<std::size_t>(done_, 1); i + 1 < at_.size() && at_[i] <= known && !stop.requested(); ++i) {
    if (is_chained_[i] == 0 || in_chain_[i] > 0) continue;
    in_chain_[i] = last_width_ = widest_in_chain(i, last_width_);
  }
  open_widths();
  narrowed_.clear();
  for (int round = 0; round < max_rounds && !stop.requested() && narrow(known, round == 0); ++round) open_widths();
  for (std::size_t i = done_; i + 1 < at_.size(); ++i)
    if (is_chained_[i] != 0) width_[i] = slow_.at(squeezed_[i]).w;
}

/// Returns the distance between the samples of a piece, mm. The samples are as dense as the narrowest rounding on the piece requires. They
/// are also so dense that the sharpest corner changes the displacement between two samples by only a small fraction of the tolerance.
SmoothPath::Looks SmoothPath::looks(std::size_t piece, double tolerance) const {
  // numbers of samples per width of a rounding: of a rounding in a chain of corners, and of a single rounding
  constexpr double in_chain = 4, alone = 24;
  constexpr double unseen = 0.02;  // greatest change of displacement between two samples, as a fraction of the tolerance
  constexpr double max_places = 96, beyond_it = 1.25;
  const double from = at_[piece], to = at_[piece + 1];
  const double width_before = width_at(from, piece).w, width_after = width_at(to, piece).w, narrower = std::min(width_before, width_after);
  Looks looks{beyond_it * std::max(width_before, width_after), narrower / in_chain};
  double max_turn = 0;
  for (std::size_t i = std::max<std::size_t>(piece, 1) - 1; i < std::min(piece + 3, at_.size()); ++i)
    if (is_chained_[i] != 0) max_turn = std::max(max_turn, turn_[i]);
  if (max_turn > 0) looks.step = std::min(looks.step, std::sqrt(unseen * tolerance * narrower / max_turn));
  const auto near = std::lower_bound(marks_.begin(), marks_.end(), from - reach_, [&](std::size_t k, double s) { return at_[k] < s; });
  for (auto mark = near; mark != marks_.end() && at_[*mark] < to + reach_; ++mark) {
    const double w = is_chained_[*mark] == 0 ? width_[*mark] : 0;
    if (!(w > 0) || at_[*mark] + w <= from || at_[*mark] - w >= to) continue;
    looks.felt = std::max(looks.felt, beyond_it * w);
    looks.step = std::min(looks.step, w / alone);
  }
  looks.step = std::max(looks.step, std::min(length_[piece], 2 * looks.felt) / max_places);
  return looks;
}

/// Calls `look` at the positions of a piece just outside the rounding of a corner. The tolerance of this corner no longer applies at these
/// positions.
template <class Look>
void SmoothPath::look_at_edges(std::size_t piece, const Look& look) const {
  constexpr double just = 1e-6;  // distance of the sampled positions from the end of the rounding, mm
  // Number of iterations. A few are sufficient, because the width of the roundings in a chain changes by at most 0.15 mm per mm of the
  // path.
  constexpr int rounds = 4;
  const double from = at_[piece], length = length_[piece];
  const double greatest = slow_.greatest(squeezed_[piece], squeezed_[piece + 1]) + 2 * just;
  corners_near(from, piece, widest + length, [&](std::size_t i) {
    if (is_chained_[i] != 0 && (at_[i] + greatest < from || at_[i] - greatest > from + length))
      return;  // its rounding ends before the piece
    for (const double side : {-1.0, 1.0}) {
      double felt = is_chained_[i] != 0 ? slow_.at(squeezed_[i]).w : width_[i];
      for (int round = 0; is_chained_[i] != 0 && round < rounds; ++round) {
        const double s = std::clamp(at_[i] + side * felt, from, from + length), before = felt;
        felt = width_at(s, piece).w;
        if (felt == before) break;
      }
      const double along = at_[i] + side * (felt + just) - from;
      if (along > 0 && along < length) look(along);
    }
  });
}

/// Returns the greatest displacement of a piece by the roundings, as a fraction of the tolerance.
double SmoothPath::farthest(std::size_t piece) {
  const double tolerance = std::max(tolerance_[piece], tolerance_[piece + 1]), length = length_[piece];
  if (tolerance == 0) return 0;
  double most = 0;
  const auto look = [&](double along) {
    const double s = at_[piece] + along, allowed = has_one_tolerance_ ? tolerance : tolerance_at(s, piece);
    if (allowed > 0) most = std::max(most, square_moved(s, piece, width_at(s, piece).w) / (allowed * allowed));
  };
  const Looks looks = this->looks(piece, tolerance);
  if (length < 2 * looks.felt) {
    const auto parts = std::max(2.0, std::ceil(length / looks.step));
    for (double k = 0; k < parts; ++k) look(length * k / parts);
  } else {  // A long piece is sampled near its ends only, because no rounding moves its middle.
    for (double along = 0; along <= looks.felt; along += looks.step) look(along), look(length - along);
  }
  if (!has_one_tolerance_) look_at_edges(piece, look);
  return std::sqrt(most);
}

/// Narrows the unsettled roundings that move a piece too far. Later calls (`first_round` false) check only the pieces that the roundings
/// narrowed in the previous call can affect.
///   returns  false if no rounding was narrowed
bool SmoothPath::narrow(double known, bool first_round) {
  // Relative tolerance for numerical errors. It is needed where a single corner uses exactly its tolerance.
  constexpr double rounding = 1e-9;
  // Fraction of the tolerance that a chain of corners may use. The rest is a reserve for the positions between the samples.
  constexpr double in_chain = 0.997;
  const double felt = SlowWidth::felt() + 2 * widest;
  std::vector<std::size_t> last;
  last.swap(narrowed_);
  auto near = last.begin();
  for (std::size_t i = piece_at(settled_, 0); i < pieces() && at_[i + 1] <= known; ++i) {
    while (near != last.end() && squeezed_[*near + 1] + felt < squeezed_[i]) ++near;
    if (!first_round && (near == last.end() || squeezed_[*near] - felt > squeezed_[i + 1])) continue;
    const double share = farthest(i);
    if (share <= (is_chained_[i] != 0 || is_chained_[i + 1] != 0 ? in_chain : 1 + rounding)) continue;
    narrowed_.push_back(i);
    narrow_at(i, share);
  }
  return !narrowed_.empty();
}

void SmoothPath::narrow_at(std::size_t piece, double over) {
  constexpr double narrowest = 1e-3;  // least width of a rounding, mm
  const double less = std::max(0.7, 0.99 / std::sqrt(over));
  const double s = at_[piece] + length_[piece] / 2;
  for (std::size_t i = std::max<std::size_t>(piece, 2) - 1; i < std::min(piece + 3, at_.size() - 1); ++i)
    in_chain_[i] = std::max(narrowest, less * std::min(in_chain_[i] > 0 ? in_chain_[i] : widest, slow_.at(squeezed_[i]).w));
  corners_near(s, piece, reach_ + length_[piece], [&](std::size_t i) {
    if (i < done_ || is_chained_[i] != 0 || std::fabs(s - at_[i]) > width_[i] + length_[piece]) return;
    width_[i] = std::max(std::min(width_[i], narrowest), less * width_[i]);
    roundings_[i].inverse = 1 / width_[i];
  });
}

}  // namespace kadr
