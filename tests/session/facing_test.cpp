// session/planned: a facing cut at constant surface speed. The spindle follows the diameter, so the feed per revolution makes the tool ever
// faster towards the centre, until the highest spindle speed (fanuc-t 6, nct 11.5).

#include <algorithm>
#include <cmath>

#include "session/a_session.h"
#include "session/planned.h"

namespace kadr::facing_test {
namespace {

using test::ASession;

constexpr double metres = 180, feed = 0.2, most_rpm = 2500;
constexpr double limited_diameter = 1000 * metres / (pi * most_rpm);  // below it the spindle has its highest speed

/// The time, s, from diameter `d1` to `d2`, by the integral of dr / (f n) with n = 1000 v / (π D), at most `most_rpm`.
double seconds(double d1, double d2) {
  const double outer = std::max(d1, limited_diameter), inner = std::max(d2, limited_diameter);
  const double varying = pi * (outer - inner) * (outer + inner) / (4000 * metres * feed);
  const double constant = (std::min(d1, limited_diameter) - std::min(d2, limited_diameter)) / 2 / (feed * most_rpm);
  return 60 * (varying + constant);
}

TEST(facing, the_tool_is_where_the_integral_of_its_feed_says) {
  ASession session("fanuc-t", "G50 S2500\nG96 S180 M3\nG0 X64. Z0\nG1 X0 F0.2\nM30\n");
  ASSERT_TRUE(session.opened());
  Planned& planned = session->plan(session->own());
  // Time and radius at the ends of the cells of the cut. G0 begins at X0, so the cut is what follows the greatest X.
  std::vector<std::pair<double, double>> ends;
  double now = 0;
  planned.on_cells = [&](const TimedCells& cells) {
    for (std::size_t k = 0; k < cells.laws.size(); ++k) {
      Axes at{};
      cells.position(k, cells.laws[k].length, at.data());
      now += cells.laws[k].seconds;
      ends.emplace_back(now, at[0]);
    }
  };
  (void)session->run();
  ASSERT_TRUE(planned.finish());
  ASSERT_TRUE(session.reported().empty()) << session.reported().front();
  const auto outermost = std::max_element(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  ASSERT_NE(outermost, ends.end());
  EXPECT_NEAR(outermost->second, 32, 1e-6);
  constexpr double ramp = 0.1;  // s; the axis speeds up and slows down, and it stands at the end of the rapid
  std::size_t looked_at = 0;
  for (auto end = outermost; end != ends.end(); ++end) {
    if (end->second < 0.1) continue;  // it slows down at the end
    EXPECT_NEAR(end->first - outermost->first, seconds(64, 2 * end->second), ramp) << "at the radius " << end->second;
    ++looked_at;
  }
  EXPECT_GT(looked_at, 20U);
  EXPECT_NEAR(planned.time()->cutting.all, seconds(64, 0), ramp);
  // At a constant speed the first 10 mm of 32 would take 10/32 of the time.
  EXPECT_GT(seconds(64, 44) - seconds(64, 0) * 10 / 32, 2 * ramp) << "the case shows nothing";
}

}  // namespace
}  // namespace kadr::facing_test
