// Random paths: each is planned within the limits and the tolerance, and smoothing in a
// parallel thread gives the same bits as smoothing in sequence. KADR_PATHS sets the number
// of paths (docs/planner.md has the results of longer runs), KADR_FIRST_PATH the first seed.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#include "looked_cells.h"
#include "motion/least_time/planner.h"
#include "planned_run.h"

namespace kadr::planner_random_paths_test {
namespace {

using test::Piece;
using test::Point;

/// Random numbers that are the same with every library.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  /// Returns a number in from … to − 1.
  int in(int from, int to) { return from + static_cast<int>(engine_() % static_cast<std::uint32_t>(to - from)); }
  bool one_in(int of) { return in(0, of) == 0; }

 private:
  std::mt19937 engine_;
};

/// Returns lines of 0.01 to 40 mm, in one direction or with corners of all sizes.
/// Tolerance and feed are the same for all lines or differ from line to line.
std::vector<Piece> random_path(std::uint32_t seed) {
  constexpr double pi = 3.14159265358979323846;
  constexpr std::array<double, 3> tolerances = {0.005, 0.02, 0.1};
  Random random(seed);
  const int kind = random.in(0, 4), count = random.in(2, 60);
  const bool is_short = kind == 0, is_tiny = kind == 3;
  const double one_tolerance = tolerances[static_cast<std::size_t>(random.in(0, 3))], one_feed = random.in(1, 200);
  const bool mixed = random.one_in(2);
  std::vector<Piece> path;
  Point at{};
  double heading = 0;
  for (int i = 0; i < count; ++i) {
    const double step = is_short ? random.in(10, 500) * 1e-3 : is_tiny ? random.in(1, 50) * 1e-3 : random.in(1, 400) * 0.1;
    heading += is_short || is_tiny ? random.in(-100, 101) * 2e-3 : random.in(0, 361) * pi / 180;
    at[0] += step * std::cos(heading);
    at[1] += step * std::sin(heading);
    if (random.one_in(5)) at[2] += 0.3;
    const double feed = is_tiny ? one_feed : random.in(1, 200);
    path.push_back({at, feed, mixed ? tolerances[static_cast<std::size_t>(random.in(0, 3))] : one_tolerance});
  }
  return path;
}

int paths_asked() {
  const char* const asked = std::getenv("KADR_PATHS");
  return asked != nullptr ? std::atoi(asked) : 600;
}

int first_path() {
  const char* const asked = std::getenv("KADR_FIRST_PATH");
  return asked != nullptr ? std::atoi(asked) : 0;
}

TEST(PlannerRandomPaths, KeepLimitsAndTolerance) {
  const MotionLimits limits = test::three_axes(200, 1000, 20000);
  for (int i = 0; i < paths_asked(); ++i) {
    const auto seed = static_cast<std::uint32_t>(first_path() + i);
    test::Looked looked;
    Planner planner(limits, [&](const TimedCells& cells) { looked.take(cells, limits, [](const Point&) {}); });
    const Point start{};
    planner.begin(start.data());
    for (const Piece& piece : random_path(seed)) planner.line_to(piece.to.data(), piece.feed, piece.tolerance, false, 0);
    planner.stop();
    EXPECT_EQ(planner.failures(), 0U) << "seed " << seed;
    EXPECT_EQ(planner.ended(), PlanEnd::none) << "seed " << seed;
    EXPECT_LE(looked.beyond, 0.01) << "seed " << seed;
    EXPECT_LE(looked.speed, 1.001) << "seed " << seed;
    EXPECT_LE(looked.feed, 1.002) << "seed " << seed;
    EXPECT_LE(looked.acceleration, 1.01) << "seed " << seed;
    EXPECT_LE(looked.jerk, 1.03) << "seed " << seed;
  }
}

/// All numbers of the cells, and the number of input segments after which each window came out.
struct Recorded {
  std::vector<double> numbers;
  std::vector<std::size_t> when;
};

/// Records a wave of short lines with a sharp corner now and then; the axes stop between some lines.
template <class Look>
Recorded recorded(bool in_background, const Look& look) {
  constexpr std::size_t pieces = 9000, to_corner = 97, to_stop = 4300;
  Recorded recorded;
  std::size_t piece = 0;
  Planner planner(test::three_axes(200, 1000, 20000), [&](const TimedCells& cells) {
    for (const TimeLaw& law : cells.laws) recorded.numbers.insert(recorded.numbers.end(), {law.seconds, law.length, law.v, law.a, law.j});
    recorded.numbers.insert(recorded.numbers.end(), cells.path.begin(), cells.path.end());
    recorded.when.push_back(piece);
  });
  if (in_background) planner.work_in_background();
  Point at{};
  planner.begin(at.data());
  while (++piece <= pieces) {
    const auto i = static_cast<double>(piece);
    if (piece % to_corner == 0) at[2] += 0.5;
    else at = {0.1 * i, 2 * std::sin(0.013 * i) + 0.3 * std::cos(0.11 * i), at[2]};
    planner.line_to(at.data(), piece % 1000 < 500 ? 50 : 80, 0.01, false, piece);
    look(planner, piece);
    if (piece % to_stop == 0) planner.stop();
  }
  planner.stop();
  return recorded;
}

TEST(PlannerSideBySide, GivesTheSameBits) {
  const auto nothing = [](Planner&, std::size_t) {};
  const Recorded alone = recorded(false, nothing), background = recorded(true, nothing);
  ASSERT_GE(alone.when.size(), 8U);
  ASSERT_EQ(alone.numbers.size(), background.numbers.size());
  EXPECT_EQ(std::memcmp(alone.numbers.data(), background.numbers.data(), alone.numbers.size() * sizeof(double)), 0);
  EXPECT_EQ(recorded(true, nothing).when, background.when);  // the moment of output does not depend on which thread is faster
}

TEST(PlannerSideBySide, GoesOnFromWhatItRemembers) {
  const Recorded straight = recorded(true, [](Planner&, std::size_t) {});
  const Recorded shaken = recorded(true, [](Planner& planner, std::size_t piece) {
    if (piece % 701 != 0) return;
    planner.settle();
    planner.resume_from(Planner::Memory(planner.memory()));
  });
  ASSERT_EQ(straight.numbers.size(), shaken.numbers.size());
  EXPECT_EQ(std::memcmp(straight.numbers.data(), shaken.numbers.data(), straight.numbers.size() * sizeof(double)), 0);
}

TEST(PlannerSideBySide, IsLeftInTheMiddle) {  // the parallel thread ends before the objects that it uses
  const MotionLimits limits = test::three_axes(200, 1000, 20000);
  for (int pieces = 1020; pieces < 1040; ++pieces) {
    Planner planner(limits, [](const TimedCells&) {});
    planner.work_in_background();
    const Point start{};
    planner.begin(start.data());
    for (int i = 1; i <= pieces; ++i) {
      const Point to = {0.1 * i, std::sin(0.1 * i), 0};
      planner.line_to(to.data(), 50, 0.01, false, 0);
    }
  }
}

}  // namespace
}  // namespace kadr::planner_random_paths_test
