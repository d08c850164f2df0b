// Player: the servo clock gets the same positions as the written samples; a feed hold between any two positions keeps the path; after a
// snapshot, a fresh session continues in the same way.

#include "session/player.h"

#include <fmt/format.h>

#include <random>

#include "session/a_session.h"

namespace kadr::player_test {
namespace {

using test::ASession, test::Work;

constexpr double rate = 250;     // Hz
constexpr std::size_t axes = 6;  // of mach3

std::string text_of(const std::vector<double>& rows, std::size_t width) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); i += width) {
    text += fmt::format("{:.6f}", static_cast<double>(i / width) / rate);
    for (std::size_t a = 0; a < width; ++a) text += fmt::format(",{:.9f}", rows[i + a]);
    text += "\n";
  }
  return text;
}

/// Returns the written samples without their heading.
std::string samples(const Work& work, std::vector<OverrideChange> changes) {
  ASession session(work.id, work.program, work.setup, work.main_file);
  test::Written written;
  SampleOptions options;
  options.rate = rate;
  options.changes = std::move(changes);
  Planned& planned = session->plan(session->own());
  planned.write_samples(written.file(), options);
  (void)session->run();
  (void)planned.finish();
  const std::string text = written.text();
  return text.substr(text.find('\n') + 1);
}

/// Returns all positions; the operator changes the override at the given instants.
std::vector<double> played(Player& player, std::size_t width, const std::vector<OverrideChange>& changes, std::size_t at_a_time) {
  std::vector<double> rows, some(width * at_a_time);
  std::size_t changed = 0;
  for (std::size_t instant = 0;; instant = rows.size() / width) {
    for (; changed < changes.size() && changes[changed].seconds <= static_cast<double>(instant) * (1 / rate); ++changed)
      player.override_to(changes[changed].share);
    const std::size_t count = player.next(some.data(), at_a_time);
    rows.insert(rows.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count * width));
    if (count < at_a_time) return rows;
  }
}

const char* const square =
    "G21 G90 G94 G17\nG0 X10 Y0 Z5\nG1 Z0 F600\nX50 F1500\nG3 X60 Y10 I0 J10\nG1 Y40\nG4 P300\nX10\nY0\nG0 Z20\nM30\n";

TEST(player, keeps_the_feed) {
  ASession session("mach3", "G21 G90 G94\nG1 X10 F600\nM30\n");
  Player player(*session, rate);
  constexpr double at_feed = 1;  // s; the ramps take additional time
  const double seconds = static_cast<double>(played(player, axes, {}, 1).size() / axes) / rate;
  EXPECT_GE(seconds, at_feed);
  EXPECT_LE(seconds, 1.5 * at_feed);
}

TEST(player, plays_what_is_written_as_samples) {
  std::size_t played_programs = 0;
  test::for_each_example([&](const Work& work) {
    ASession session(work.id, work.program, work.setup, work.main_file);
    if (!session.opened() || session->channels().size() > 1) return;
    const std::string expected = samples(work, {});
    if (expected.size() > 3'000'000) return;
    Player player(*session, rate);
    const std::size_t count = session->control().axes().size();
    EXPECT_EQ(text_of(played(player, count, {}, played_programs % 2 == 0 ? 1 : 7), count) == expected, true) << work.where;
    EXPECT_TRUE(expected.empty() || player.done());
    ++played_programs;
  });
  EXPECT_GT(played_programs, 10U);
}

TEST(player, holds_between_any_two_positions) {
  const Work work{"mach3", "square", square, "main.nc", {}};
  std::mt19937 choose(4);
  for (int i = 0; i < 20; ++i) {
    const double from = std::uniform_int_distribution<int>(0, 1500)(choose) / rate;
    const std::vector<OverrideChange> changes{{from, 0}, {from + 2, 0.5}, {from + 3, 1}};
    ASession session(work.id, work.program);
    Player player(*session, rate);
    EXPECT_EQ(text_of(played(player, axes, changes, 1), axes) == samples(work, changes), true) << from;
  }
  ASession session(work.id, work.program);
  Player player(*session, rate);
  std::vector<double> row(axes), held(axes);
  for (int i = 0; i < 300; ++i) ASSERT_EQ(player.next(row.data(), 1), 1U);
  EXPECT_EQ(player.at().line, 4U);
  player.hold();
  int braked = 0;
  while (!player.is_held()) ASSERT_TRUE(player.next(held.data(), 1) == 1 && ++braked < 200);
  EXPECT_GT(braked, 5);
  EXPECT_NE(held[0], row[0]);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(player.next(row.data(), 1) == 1 && row == held);
  player.override_to(1);
  while (player.next(row.data(), 1) == 1) {
  }
  EXPECT_EQ(row, (std::vector<double>{10, 0, 20, 0, 0, 0}));
  EXPECT_EQ(player.state(), Session::State::ended);
}

TEST(player, goes_on_the_same_in_a_fresh_session) {
  std::mt19937 choose(5);
  for (int i = 0; i < 10; ++i) {
    const int before = std::uniform_int_distribution<int>(0, 900)(choose);
    const std::vector<OverrideChange> changes{{0, 0.7}, {3, 0}, {4, 1}};
    ASession first("mach3", square), second("mach3", square);
    Player player(*first, rate), fresh(*second, rate);
    std::vector<double> row(axes);
    player.override_to(0.7);
    for (int n = 0; n < before; ++n) ASSERT_EQ(player.next(row.data(), 1), 1U);
    const auto memory = player.snapshot();
    ASSERT_TRUE(memory);
    ASSERT_TRUE(fresh.restore(*memory));
    const auto rest = played(player, axes, changes, 1);
    EXPECT_GT(rest.size(), 100U);
    EXPECT_EQ(rest, played(fresh, axes, changes, 1)) << before;
  }
}

TEST(player, an_alarm_ends_the_motion_where_it_came) {
  ASession session("mach3", "G21 G90\nG1 X10 F600\nG1 X20 Q\nG1 X30\nM30\n");
  Player player(*session, rate);
  std::vector<double> row(axes);
  while (player.next(row.data(), 1) == 1) {
  }
  EXPECT_EQ(player.state(), Session::State::stopped);
  EXPECT_NEAR(row[0], 10, 1e-9);
}

}  // namespace
}  // namespace kadr::player_test
