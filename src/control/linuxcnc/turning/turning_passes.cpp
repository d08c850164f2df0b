// Computes the motions of G70 to G72: finishing passes along the profile, and cuts parallel to an axis, with or without pockets. Described
// in turning_passes.h.

#include "control/linuxcnc/turning/turning_passes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kadr::linuxcnc {
namespace {

constexpr std::size_t max_moves = 1'000'000;
// Greatest number of steps of the search for the next cut. For some profiles the search of LinuxCNC never ends.
constexpr std::uint64_t max_polls = 20'000'000;
constexpr double below_all = -1e9;
constexpr double same_end = 1e-3;  // an arc whose end points are closer than this is skipped; in the unit of the program
using Pieces = std::list<Piece>;

class Cutting {
 public:
  Cutting(Profile& profile, std::vector<TurningMove>& moves) : profile_(profile), moves_(moves) {}

  void rapid(Point to) { add(TurningMove::Kind::rapid, to); }
  void line(Point to) { add(TurningMove::Kind::line, to); }
  void arc(bool ccw, Point center, Point to) {
    const bool as_seen = ccw == profile_.keeps_turn();
    add(as_seen ? TurningMove::Kind::arc_ccw : TurningMove::Kind::arc_cw, to, profile_.on_machine(center));
  }
  void along(const Piece& piece) {
    if (piece.is_arc()) arc(piece.ccw, piece.center, piece.end);
    else line(piece.end);
  }
  bool has_room() const { return moves_.size() < max_moves; }

  Turned rough(Pockets pockets, double depth, double retract);

 private:
  void add(TurningMove::Kind kind, Point to, Point center = {}) { moves_.push_back({kind, profile_.on_machine(to), center}); }
  Pieces::iterator end() { return profile_.pieces.end(); }
  bool is_first(Pieces::iterator at) { return at == profile_.pieces.begin(); }
  static tl::unexpected<std::string> endless() { return tl::unexpected(std::string()); }

  enum class Found : std::uint8_t { below, rises };
  tl::expected<Found, std::string> dive(Pieces::iterator at, double x);
  tl::expected<Found, std::string> dive_line(const Piece& piece, double x, bool fast);
  Found dive_arc(const Piece& piece, double x);
  tl::expected<bool, std::string> climb(const Piece& piece);
  void climb_rising(const Piece& piece);
  void cut_to_wall(Pieces::iterator& at, double retract);
  tl::expected<bool, std::string> leave_pocket(Pieces::iterator& at, Pockets pockets);

  Profile& profile_;
  std::vector<TurningMove>& moves_;
  Point here_;
  std::vector<Point> tops_;  // start points of the pockets that are not finished yet
  double x_ = 0, depth_ = 1;
};

/// Moves down along a piece of the profile to the level `x`, or to the end of the piece. The result is `rises` if X does not decrease along
/// the piece.
tl::expected<Cutting::Found, std::string> Cutting::dive(Pieces::iterator at, double x) {
  if (at->is_arc()) return dive_arc(*at, x);
  return dive_line(*at, x, is_first(at));
}

tl::expected<Cutting::Found, std::string> Cutting::dive_line(const Piece& piece, double x, bool fast) {
  if (piece.start.imag() <= piece.end.imag() + same_point) return Found::rises;
  Point to = piece.end;
  if (!(x < piece.end.imag())) {
    const auto at = piece.crossings(x);
    if (at.empty()) return tl::unexpected(std::string("x too large in straight dive"));
    to = Point(at.front(), x);
  }
  if (fast) rapid(to);
  else line(to);
  here_ = to;
  return Found::below;
}

Cutting::Found Cutting::dive_arc(const Piece& piece, double x) {
  if (std::abs(here_ - piece.end) < same_point || std::real(here_ - piece.end) <= same_point) {
    here_ = piece.end;
    return Found::below;
  }
  auto at = piece.crossings(x);
  if (at.empty()) at = piece.crossings(x - same_point);
  const double middle = piece.center.real();
  Point to = piece.end;
  if (piece.ccw) {
    if (here_.real() - same_point > middle) return Found::rises;
    if (!at.empty() && at.back() <= middle) to = Point(at.back(), x);
  } else {
    if (here_.real() <= middle) return Found::rises;
    // only the half of the arc beyond its middle has this X, so the tool does not move here; the next cut is deeper
    if (!at.empty() && at.front() < middle) return Found::below;
    if (!at.empty()) to = Point(at.front(), x);
  }
  arc(piece.ccw, piece.center, to);
  here_ = to;
  return Found::below;
}

/// Moves up along a piece of the profile. Returns true if X decreases again on the piece, so that a pocket starts at the point reached.
tl::expected<bool, std::string> Cutting::climb(const Piece& piece) {
  if (!piece.is_arc()) {
    if (piece.end.imag() + same_point < piece.start.imag()) return true;
    if (std::abs(here_ - piece.start) > same_point) return tl::unexpected(std::string("How did we get here?"));
    line(piece.end);
    here_ = piece.end;
    return false;
  }
  const double middle = piece.center.real();
  if (piece.ccw ? here_.real() < middle : here_.real() > middle) return true;
  Point to = piece.end;
  if (piece.ccw && piece.end.real() < middle) to = Point(middle, piece.center.imag() + std::abs(piece.start - piece.center));
  if (std::abs(here_ - to) > same_end) arc(piece.ccw, piece.center, to);
  here_ = to;
  return piece.ccw;
}

/// Moves up along the part of a piece that is above the present X. Pockets in this part are skipped.
void Cutting::climb_rising(const Piece& piece) {
  if (!piece.is_arc() && piece.end.imag() < piece.start.imag()) return;
  const auto at = piece.crossings(here_.imag());
  if (at.empty()) return;
  if (!piece.is_arc()) {
    line(Point(at.front(), here_.imag()));
    line(piece.end);
    here_ = piece.end;
    return;
  }
  const double middle = piece.center.real();
  if (piece.ccw ? at.front() < middle : at.back() > middle) return;
  here_.real(at.back());
  if (piece.ccw) here_.real(at.front());
  line(here_);
  Point to = piece.end;
  if (piece.ccw && piece.end.real() < middle) to = Point(middle, piece.center.imag() + std::abs(piece.start - piece.center));
  if (std::abs(here_ - to) > same_end) arc(piece.ccw, piece.center, to);
  here_ = to;
}

/// Makes one cut at the present X, up to the first piece that the cut meets, and returns to the start of the cut.
void Cutting::cut_to_wall(Pieces::iterator& at, double retract) {
  const Point away = retract * Point(1, 1);
  for (auto wall = at; wall != end(); ++wall) {
    const auto crossings = wall->crossings(here_.imag());
    if (crossings.empty()) continue;
    const double z = wall != at ? crossings.front() : crossings.back();
    const double distance = std::abs(z - here_.real());
    // this piece of the profile is on the side from which the cut comes, so it does not end the cut
    if (z - same_point > here_.real()) continue;
    if (distance < same_point) {
      if (wall == at) continue;
      if (std::abs(here_ - wall->start) < same_point) at = wall;
      else x_ -= depth_;
      return;
    }
    const Point begin = here_;
    Point to(z, here_.imag());
    line(to);
    const double part = std::min(1.0, distance / 2 / away.real());  // the retract goes back over at most half the cut
    to += part * away;
    rapid(to);
    rapid(begin - std::conj(part * away));
    if (is_first(at)) rapid(begin);
    else line(begin);
    x_ -= depth_;
    return;
  }
}

/// Moves up along the profile after the lowest cut of a pocket, to the next pocket. Returns false if there is no further pocket.
tl::expected<bool, std::string> Cutting::leave_pocket(Pieces::iterator& at, Pockets pockets) {
  for (; at != end(); ++at) {
    if (pockets == Pockets::none) {
      climb_rising(*at);
      continue;
    }
    const auto falls = climb(*at);
    if (!falls) return tl::unexpected(falls.error());
    if (!*falls) continue;
    if (pockets == Pockets::only) {
      if (here_.imag() > tops_.back().imag() && tops_.size() > 1) tops_.pop_back();
      if (tops_.size() == 1) tops_.push_back(here_);
    }
    return true;
  }
  return false;
}

Turned Cutting::rough(Pockets pockets, double depth, double retract) {
  depth_ = depth;
  here_ = profile_.pieces.front().start;
  tops_.assign(1, here_);
  auto at = profile_.pieces.begin();
  if (pockets == Pockets::only) {  // G71.1 has cut the first pocket, so the descent into it is skipped
    for (; at != end(); ++at) {
      const auto found = dive(at, below_all);
      if (!found) return tl::unexpected(found.error());
      if (*found == Found::rises) break;
    }
  }
  x_ = tops_.back().imag();
  for (std::uint64_t looks = 0; at != end(); ++looks) {
    if (looks > max_polls || !has_room() || (x_ - here_.imag()) / depth_ > static_cast<double>(max_polls)) return endless();
    while (x_ - same_point > here_.imag()) x_ -= depth_;
    const auto found = dive(at, x_);
    if (!found) return tl::unexpected(found.error());
    if (*found == Found::rises) {
      const auto follows = leave_pocket(at, pockets);
      if (!follows) return tl::unexpected(follows.error());
      if (!*follows) return {};
      x_ = tops_.back().imag();
    } else if (std::abs(here_.imag() - x_) > same_point || at->end == here_) {
      ++at;  // X is beyond this piece, or the piece is finished, so the next piece follows (LinuxCNC 2.9.4)
    } else {
      cut_to_wall(at, retract);
    }
  }
  return {};
}

/// Mirrors the profile so that Z decreases along it. If only X is monotonic along the profile, the profile is rotated by 90° first.
Turned face(Profile& profile, Point start) {
  profile.pieces.front().start = start;
  Profile without_lead_in = profile;
  without_lead_in.pieces.pop_front();
  without_lead_in.face_down();
  const auto& all = without_lead_in.pieces;
  if (!std::all_of(all.begin(), all.end(), [](const Piece& piece) { return piece.falls(); })) {
    without_lead_in.quarter_turn();
    without_lead_in.face_down();
  }
  if (const Turned falls = without_lead_in.check_falls(); !falls) return falls;
  if ((without_lead_in.turned & 4U) != 0) profile.quarter_turn();
  profile.face_down();
  if (const Turned placed = profile.place_corners(); !placed) return placed;
  return profile.check_falls();
}

}  // namespace

Turned finish_profile(const Profile& given, const TurningWords& words, std::vector<TurningMove>& moves) {
  Profile profile = given;
  if (const Turned faced = face(profile, words.start); !faced) return faced;
  for (int pass = static_cast<int>(std::clamp(words.passes, 0.0, 1e6)); pass > 0; --pass) {
    Profile along = profile;
    if (const Turned off = along.offset((pass - 1) * (words.distance - words.last) / words.passes + words.last); !off) return off;
    Cutting cutting(along, moves);
    if (!cutting.has_room()) return tl::unexpected(std::string());
    cutting.rapid(along.pieces.front().start);
    if (!moves.empty()) moves.back().to_start = true;
    cutting.rapid(along.pieces.front().end);
    for (auto at = std::next(along.pieces.begin()); at != along.pieces.end(); ++at) cutting.along(*at);
  }
  return {};
}

/// Closes a profile that leads away from the start of the cycle and whose last piece advances in the direction of the cuts. The added piece
/// is a line to the level of the cycle's start (LinuxCNC 2.9.4).
void close_profile(Profile& profile, Point start, bool across) {
  const Point first = profile.pieces.front().end - profile.pieces.front().start;
  const Piece& back = profile.pieces.back();
  const Point last = back.end - back.start, end = back.end;
  if (across && std::abs(last.imag()) > 0 && first.real() * (start.real() - end.real()) < 0)
    profile.pieces.push_back(Piece::line(end, {start.real(), end.imag()}));
  if (!across && std::abs(last.real()) > 0 && first.imag() * (start.imag() - end.imag()) < 0)
    profile.pieces.push_back(Piece::line(end, {end.real(), start.imag()}));
}

Turned rough_profile(Profile profile, const TurningWords& words, Pockets pockets, bool across, std::vector<TurningMove>& moves) {
  close_profile(profile, words.start, across);
  profile.pieces.front().start = words.start;
  if (across) profile.quarter_turn();
  profile.face_down();
  if (const Turned placed = profile.place_corners(); !placed) return placed;
  if (const Turned falls = profile.check_falls(); !falls) return falls;
  if (const Turned off = profile.offset(words.distance); !off) return off;

  Cutting cutting(profile, moves);
  const Point start = profile.pieces.front().start, last = profile.pieces.back().end;
  cutting.rapid(start);
  if (last.imag() < start.imag()) profile.pieces.push_back(Piece::line(last, {last.real(), start.imag()}));
  return cutting.rough(pockets, std::max(words.depth, 2 * same_point), words.retract);
}

}  // namespace kadr::linuxcnc
