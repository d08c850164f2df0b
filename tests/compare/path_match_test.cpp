// compare/path_match: its verdict on two paths is compared with the discrete
// Fréchet distance of both, divided into small pieces (Eiter, Mannila 1994).

#include "compare/path_match.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kadr::stretch_test {
namespace {

using Point = std::array<double, 2>;
using Path = std::vector<Point>;  // begins at its first point

Axes axes(const Point& p) {
  Axes at{};
  at[0] = p[0], at[1] = p[1];
  return at;
}

CourseCursor cursor_of(const Path& path, const CourseSpace& space) {
  return {[path, i = std::size_t{0}](ItemRing& to) mutable {
            CourseItem& item = to.add();
            item = {};
            if (++i >= path.size()) return;
            item.kind = CourseItem::Kind::move;
            item.to = axes(path[i]);
          },
          axes(path.front()), space};
}

struct Match {
  bool whole;  // both paths are compared to their ends
  double greatest;
};
Match matched(const Path& a, const Path& b, double tolerance) {
  const CourseSpace space(2);
  CourseCursor lane_a = cursor_of(a, space), lane_b = cursor_of(b, space);
  const PathMatch result = match_paths(lane_a, lane_b, space, tolerance);
  // When one path has ended, the rest of the other must be near that end.
  const auto rest_near = [&](CourseCursor& lane, const CourseCursor& other) {
    for (std::size_t i = 0; lane.item(i).kind == CourseItem::Kind::move; ++i)
      if (space.distance(lane.item(i).to, other.at()) > tolerance) return false;
    return true;
  };
  return {result.together && rest_near(lane_a, lane_b) && rest_near(lane_b, lane_a), result.greatest};
}

Path divided(const Path& path, double step) {
  Path fine{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double dx = path[i][0] - path[i - 1][0], dy = path[i][1] - path[i - 1][1];
    const int n = std::max(1, int(std::ceil(std::hypot(dx, dy) / step)));
    for (int k = 1; k <= n; ++k) fine.push_back({path[i - 1][0] + dx * k / n, path[i - 1][1] + dy * k / n});
  }
  return fine;
}

/// Returns a value that is at least the continuous Fréchet distance, and at most one step more.
double discrete_frechet(const Path& a, const Path& b) {
  std::vector<double> row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    double diagonal = 0;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double d = std::hypot(a[i][0] - b[j][0], a[i][1] - b[j][1]), above = row[j];
      double before = 0;
      if (i > 0 && j > 0) before = std::min({above, row[j - 1], diagonal});
      else if (i > 0) before = above;
      else if (j > 0) before = row[j - 1];
      diagonal = above;
      row[j] = std::max(before, d);
    }
  }
  return row.back();
}

TEST(Stretch, BackAndForthIsNotTheStraightWay) {
  EXPECT_TRUE(matched({{0, 0}, {10, 0}}, {{0, 0}, {3, 0}, {10, 0}}, 0.1).whole);
  EXPECT_FALSE(matched({{0, 0}, {10, 0}}, {{0, 0}, {6, 0}, {3, 0}, {10, 0}}, 0.1).whole);
  EXPECT_TRUE(matched({{0, 0}, {10, 0}}, {{0, 0}, {6, 0}, {3, 0}, {10, 0}}, 1.6).whole);
}

TEST(Stretch, TheGreatestDistanceIsThatOfTheVertices) {
  EXPECT_NEAR(matched({{0, 0}, {10, 0}}, {{0, 0}, {5, 0.07}, {10, 0}}, 0.1).greatest, 0.07, 1e-9);
  EXPECT_NEAR(matched({{0, 0}, {5, 0.07}, {10, 0}}, {{0, 0}, {10, 0}}, 0.1).greatest, 0.07, 1e-9);
}

TEST(Stretch, TheLongerOneIsCutWhereTheOtherEnds) {
  const CourseSpace space(2);
  CourseCursor a = cursor_of({{0, 0}, {10, 0}}, space), b = cursor_of({{0, 0}, {4, 0.05}}, space);
  EXPECT_TRUE(match_paths(a, b, space, 0.1).together);
  EXPECT_NEAR(a.at()[0], 4, 1e-9);
  EXPECT_EQ(b.item(0).kind, CourseItem::Kind::end);
  EXPECT_EQ(a.item(0).kind, CourseItem::Kind::move);
}

RC_GTEST_PROP(StretchProperty, as_the_discrete_distance_says, ()) {
  const auto point = rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 60), rc::gen::inRange(0, 60)), [](const std::pair<int, int>& p) {
    return Point{p.first / 10.0, p.second / 10.0};
  });
  const auto points = *rc::gen::suchThat(rc::gen::container<Path>(point), [](const Path& w) { return w.size() < 8; });
  Path a{{0, 0}}, b{{0, 0}};
  for (const Point& p : points) {
    a.push_back(p);
    for (int k = *rc::gen::inRange(0, 3); k > 0; --k)
      b.push_back({p[0] + *rc::gen::inRange(-9, 10) / 10.0, p[1] + *rc::gen::inRange(-9, 10) / 10.0});
    if (*rc::gen::inRange(0, 4) != 0) b.push_back(p);
  }
  b.push_back(a.back());
  const auto moves = [](const Path& w) { return std::any_of(w.begin(), w.end(), [&](const Point& p) { return p != w.front(); }); };
  RC_PRE(moves(a) && moves(b));
  const double step = 0.04, tolerance = *rc::gen::element(0.15, 0.5, 1.0, 2.0);
  const double discrete = discrete_frechet(divided(a, step), divided(b, step));
  const Match result = matched(a, b, tolerance);
  constexpr double rounding = 1e-9;  // a vertex exactly at the tolerance can be judged either way, because the free space compares squares
  if (discrete <= tolerance - rounding) RC_ASSERT(result.whole);
  if (discrete > tolerance + step) RC_ASSERT(!result.whole);
  if (result.whole) RC_ASSERT(result.greatest <= tolerance + 1e-9);
}

Path halved(const Path& path) {
  Path fine{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    fine.push_back({(path[i - 1][0] + path[i][0]) / 2, (path[i - 1][1] + path[i][1]) / 2});
    fine.push_back(path[i]);
  }
  return fine;
}

/// Paths that wind within the tolerance and differ in one place. Equal pieces match without a search. Pieces cut in two do not, so the
/// search must give the same verdict.
RC_GTEST_PROP(StretchProperty, pieces_that_are_the_same_need_no_search, ()) {
  const auto point = rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 7), rc::gen::inRange(0, 4)), [](const std::pair<int, int>& p) {
    return Point{p.first / 2.0, p.second / 2.0};
  });
  Path a{{0, 0}};
  for (const Point& next : *rc::gen::container<Path>(point))
    if (next != a.back()) a.push_back(next);
  RC_PRE(a.size() >= 3);
  Path b = a;
  const auto place = b.begin() + *rc::gen::inRange(1, int(b.size()) - 1);
  const Point other{(*place)[0] + *rc::gen::inRange(-9, 10) / 8.0, (*place)[1] + *rc::gen::inRange(-9, 10) / 8.0};
  switch (*rc::gen::inRange(0, 3)) {
    case 0: *place = other; break;
    case 1: b.insert(place, other); break;
    default: b.erase(place); break;
  }
  const double tolerance = *rc::gen::element(0.171, 0.383, 0.617, 0.929, 1.313);
  const Match result = matched(a, b, tolerance);
  RC_ASSERT(result.whole == matched(a, halved(b), tolerance).whole);
  RC_ASSERT(result.whole == matched(b, a, tolerance).whole);
  if (result.whole) RC_ASSERT(result.greatest <= tolerance + 1e-9);
}

}  // namespace
}  // namespace kadr::stretch_test
