// Random figures of G71 and G72, type I and II, in the four quadrants: the passes are executed on a blank whose remaining height is kept
// at many places along the passes. The model reads neither the figure nor the passes' own geometry: it evaluates each line and arc itself.
// KADR_FIGURES: how many figures; KADR_FIRST_FIGURE: the first seed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include "control/fanuc/lathe/rough_passes.h"

namespace kadr::rough_passes_random_test {
namespace {

using fanuc::ContourPiece;
using fanuc::RoughFigure;
using fanuc::RoughPasses;

constexpr double same_column = 1e-7;  // mm: places along the passes closer than this are one place
constexpr double exact = 1e-6;        // mm: permitted error of a depth
constexpr double no_stock = std::numeric_limits<double>::infinity();

/// Numbers and choices of one figure.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double in(double least, double most) { return least + (most - least) * (double(engine_()) / 4294967296.0); }
  bool one_in(int count) { return engine_() % static_cast<std::uint32_t>(count) == 0; }
  template <std::size_t N>
  double of(const double (&all)[N]) {
    return all[engine_() % N];
  }
  /// Returns a length that is often round, so that levels, ridges and ends coincide.
  double length(double most) { return one_in(2) ? std::floor(in(0, 2 * most)) / 2 : in(0, most); }

 private:
  std::mt19937 engine_;
};

/// A line or arc as x along the passes and y as the depth; an arc lies on one side of its centre, `side` ±1, or 0 for a line.
struct Curve {
  Vec2 from, to, center;
  int side = 0;

  double least() const { return std::min(from.x, to.x); }
  double most() const { return std::max(from.x, to.x); }
  /// Returns the depth at x, or for a vertical line at the end asked for.
  double depth(double x, bool deep) const {
    if (most() - least() < same_column) return deep ? std::max(from.y, to.y) : std::min(from.y, to.y);
    x = std::clamp(x, least(), most());
    if (x == from.x) return from.y;
    if (x == to.x) return to.y;
    if (side == 0) return from.y + (to.y - from.y) * (x - from.x) / (to.x - from.x);
    const double radius = std::hypot(from.x - center.x, from.y - center.y);
    return center.y + side * std::sqrt(std::max(0.0, (radius - (x - center.x)) * (radius + (x - center.x))));
  }
  double top() const { return side < 0 && least() < center.x && center.x < most() ? depth(center.x, false) : std::min(from.y, to.y); }
};

/// A random cycle in coordinates from S+δ on, along the passes and into the blank.
struct Job {
  std::vector<Curve> figure;  // from A' on
  RoughPasses::Plan plan;
  Vec2 allowance, start;  // δ along the passes and into the blank; S in the plane
  bool facing = false, pockets = false;
  double along = 1, into = 1;  // directions of these coordinates along the axes of the plane

  Vec2 direction(Vec2 v) const { return facing ? Vec2{into * v.y, along * v.x} : Vec2{along * v.x, into * v.y}; }
  /// Returns a point of the plane in the coordinates of the job.
  Vec2 local(Vec2 p) const {
    const Vec2 v = p - start - direction(allowance);
    return facing ? Vec2{along * v.y, into * v.x} : Vec2{along * v.x, into * v.y};
  }
  bool mirrored() const { return (along * into < 0) != facing; }
  ContourPiece programmed(const Curve& curve) const {
    ContourPiece piece{MotionKind::feed, start + direction(curve.from), start + direction(curve.to), {}, 0, 0};
    if (curve.side == 0) return piece;
    piece.center = start + direction(curve.center);
    // on the side of greater y an arc towards greater x runs clockwise
    piece.kind = (curve.side > 0) != mirrored() ? MotionKind::arc_cw : MotionKind::arc_ccw;
    const auto angle = [&](Vec2 p) { return std::atan2(p.y - piece.center.y, p.x - piece.center.x) / (2 * pi); };
    const double turn = angle(piece.to) - angle(piece.from);
    piece.turns = std::fmod((piece.kind == MotionKind::arc_ccw ? turn : -turn) + 2, 1);
    return piece;
  }
  std::vector<ContourPiece> contour(MotionKind infeed) const {
    std::vector<ContourPiece> all{{infeed, start, start + direction(figure.front().from), {}, 0, 0}};
    for (const Curve& curve : figure) all.push_back(programmed(curve));
    return all;
  }
  Curve curve(const ContourPiece& piece) const {
    Curve curve{local(piece.from), local(piece.to), {}, 0};
    if (!piece.is_arc()) return curve;
    curve.center = local(piece.center);
    const double turn = (piece.kind == MotionKind::arc_ccw ? 1 : -1) * pi * piece.turns;
    const Vec2 arm = piece.from - piece.center;
    const Vec2 middle =
        piece.center + Vec2{arm.x * std::cos(turn) - arm.y * std::sin(turn), arm.x * std::sin(turn) + arm.y * std::cos(turn)};
    curve.side = local(middle).y > curve.center.y ? 1 : -1;
    return curve;
  }
};

Curve random_line(Random& random, Vec2 from, bool falls) {
  const double rise = random.one_in(2) ? random.length(8) : -random.length(8);
  const double depth = random.one_in(3) ? 0 : falls ? -std::fabs(rise) : rise;
  return {from, {from.x + (random.one_in(3) && depth != 0 ? 0 : random.length(12)), from.y + depth}, {}, 0};
}

/// Returns an arc of at most half a circle that runs along the passes; if `falls`, one that becomes less and less deep.
Curve random_arc(Random& random, Vec2 from, bool falls) {
  const int side = random.one_in(2) ? 1 : -1;
  const double radius = 0.5 + random.length(6);
  const bool whole = random.one_in(3);
  // angles of the ends from the direction −x, towards +x, in half circles
  double first = whole ? 0 : random.in(0, 0.9), last = whole ? 1 : random.in(first + 0.05, 1);
  if (falls)
    (side > 0 ? first : last) = side > 0 ? 0.5 + first / 2 : last / 2, (side > 0 ? last : first) = side > 0 ? 0.5 + last / 2 : first / 2;
  const auto arm = [&](double part) {
    if (part == 0 || part == 1) return Vec2{part == 0 ? -radius : radius, 0};
    if (part == 0.5) return Vec2{0, side * radius};
    return Vec2{-radius * std::cos(pi * part), side * radius * std::sin(pi * part)};
  };
  const Vec2 center = from - arm(first);
  return {from, center + arm(last), center, side};
}

std::vector<Curve> random_figure(Random& random, const Job& job) {
  std::vector<Curve> all;
  Vec2 at{job.pockets && random.one_in(3) ? random.in(-1, 1) : 0, random.one_in(8) ? random.in(0, 1) : random.length(15)};
  const std::size_t count = 1 + static_cast<std::size_t>(random.in(0, 9));
  for (int tried = 0; all.size() < count && tried < 200; ++tried) {
    const Curve next = random.one_in(3) ? random_arc(random, at, !job.pockets) : random_line(random, at, !job.pockets);
    if (next.top() < 0 || std::max(next.from.y, next.to.y) > 25) continue;
    if (std::hypot(next.to.x - at.x, next.to.y - at.y) < 0.01) continue;
    all.push_back(next);
    at = next.to;
  }
  if (!all.empty() && at.y > 0 && random.one_in(2)) all.push_back({at, {at.x, 0}, {}, 0});
  return all;
}

Job random_job(std::uint32_t seed) {
  Random random(seed);
  Job job;
  job.facing = random.one_in(2);
  job.pockets = !random.one_in(3);
  job.along = random.one_in(2) ? -1 : 1;
  job.into = random.one_in(2) ? -1 : 1;
  job.start = {random.in(-50, 50), random.in(0, 100)};
  if (random.one_in(2)) job.allowance = {random.in(-0.3, 0.3), random.in(-0.3, 0.3)};
  job.plan.depth = random.one_in(2) ? random.of({1.0, 2.0, 3.0, 5.0}) : random.in(0.7, 6);
  job.plan.back = random.of({0.0, 0.3, 0.5, 1.0, 4.0});
  job.plan.clearance = random.of({0.0, 0.0, 0.2, 2.0});
  const auto sinks = [](const Curve& curve) { return curve.side > 0 || std::max(curve.from.y, curve.to.y) > 0.1; };
  do job.figure = random_figure(random, job);
  while (std::none_of(job.figure.begin(), job.figure.end(), sinks) || job.figure.back().to.x - job.figure.front().from.x < 0.5);
  return job;
}

/// The blank: for places along the passes, the depth down to which it is cut, and the depths that the figure has there.
class Blank {
 public:
  struct Column {
    double x, cut, least, most;
  };

  Blank(const Job& job, MotionKind infeed, const std::vector<Curve>& motions) : job_(job) {
    // The blank begins just behind A'. It may begin at A' itself if the tool does not come there at rapid.
    const double first = job.figure.front().from.x;
    const double front = infeed == MotionKind::feed && first > 0.05 ? first : first + 0.01;
    surface_ = std::max(0.0, -job.allowance.y);
    const double end = job.figure.back().to.x;
    std::vector<double> places;
    for (int i = 0; i <= 100; ++i) places.push_back(front + (end + 1 - front) * i / 100);
    for (const Curve& motion : motions) places.push_back(motion.to.x);
    std::sort(places.begin(), places.end());
    for (const double x : places)
      if (columns_.empty() || x - columns_.back().x > same_column / 10) columns_.push_back(column(x, front, end));
  }

  void expect_cut(const Curve& motion) {
    for (Column& column : under(motion)) {
      const double depth = motion.depth(column.x, true);
      EXPECT_LE(depth, column.most + exact) << "into the figure at " << column.x;
      EXPECT_LE(depth, column.cut + job_.plan.depth + exact) << "deeper than a pass at " << column.x;
      column.cut = std::max({column.cut, depth, motion.depth(column.x - same_column, true), motion.depth(column.x + same_column, true)});
    }
  }
  void expect_clear(const Curve& motion) {
    for (const Column& column : under(motion))
      EXPECT_LE(motion.depth(column.x, true), column.cut + exact) << "rapid through stock at " << column.x;
  }
  void expect_figure() const {
    for (const Column& column : columns_) {
      if (column.cut == no_stock) continue;
      EXPECT_GE(column.cut, column.least - exact) << "stock left at " << column.x;
      EXPECT_LE(column.cut, column.most + exact) << "cut too deep at " << column.x;
    }
  }

 private:
  struct Range {
    Column *first, *last;
    Column* begin() const { return first; }
    Column* end() const { return last; }
  };
  Range under(const Curve& motion) {
    const auto less = [](const Column& column, double x) { return column.x < x; };
    Column* const all = columns_.data();
    Column* const first = std::lower_bound(all, all + columns_.size(), motion.least() - same_column, less);
    return {first, std::lower_bound(first, all + columns_.size(), motion.most() + same_column, less)};
  }

  Column column(double x, double front, double end) const {
    if (x < front - same_column / 2) return {x, no_stock, 0, no_stock};
    Column made{x, surface_, no_stock, surface_};
    for (const Curve& curve : job_.figure) {
      if (x < curve.least() - same_column || x > curve.most() + same_column) continue;
      for (const double side : {-same_column, 0.0, same_column}) {
        made.least = std::min(made.least, curve.depth(x + side, false));
        made.most = std::max(made.most, curve.depth(x + side, true));
      }
    }
    if (x > end - same_column) made.least = 0;
    return made;
  }

  const Job& job_;
  double surface_ = 0;
  std::vector<Column> columns_;
};

void expect_sound(const Job& job, MotionKind infeed) {
  const RoughFigure figure(job.contour(infeed), {job.facing, job.pockets, job.direction(job.allowance), {}});
  ASSERT_EQ(static_cast<int>(figure.fault()), 0);
  RoughPasses passes(figure, job.plan);
  std::vector<ContourPiece> pieces;
  while (const auto step = passes.next()) {
    pieces.push_back(step->motion);
    ASSERT_LT(pieces.size(), 100'000U);
  }
  std::vector<Curve> motions;
  for (const ContourPiece& piece : pieces) motions.push_back(job.curve(piece));
  Blank blank(job, infeed, motions);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_LT(length(pieces[i].from - (i == 0 ? job.start : pieces[i - 1].to)), 3e-6) << "the path has a gap";
    pieces[i].kind == MotionKind::rapid ? blank.expect_clear(motions[i]) : blank.expect_cut(motions[i]);
    if (testing::Test::HasFailure()) FAIL() << "motion " << i << " to " << motions[i].to.x << ", " << motions[i].to.y;
  }
  blank.expect_figure();
  EXPECT_EQ(pieces.back().to, job.start);
}

int asked(const char* name, int otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::atoi(text) : otherwise;
}

TEST(rough_passes_random, leave_the_figure_and_never_cut_at_rapid) {
  const int first = asked("KADR_FIRST_FIGURE", 0), count = asked("KADR_FIGURES", 8000);
  for (int seed = first; seed < first + count; ++seed) {
    const Job job = random_job(static_cast<std::uint32_t>(seed));
    expect_sound(job, seed % 4 == 0 ? MotionKind::feed : MotionKind::rapid);
    if (HasFailure()) {
      for (const Curve& curve : job.figure) printf("%s (%.9g, %.9g)", curve.side == 0 ? " line" : " arc", curve.to.x, curve.to.y);
      FAIL() << "figure " << seed << " from (" << job.figure.front().from.x << ", " << job.figure.front().from.y << "), depth "
             << job.plan.depth << ", back " << job.plan.back << ", clearance " << job.plan.clearance << ", type " << (job.pockets ? 2 : 1);
    }
  }
}

}  // namespace
}  // namespace kadr::rough_passes_random_test
