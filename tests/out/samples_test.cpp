// The CSV of positions at the servo rate.

#include "out/trace/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace kadr::samples_test {
namespace {

constexpr double speed = 100;  // mm/s

/// Returns motion along X at a constant speed in `count` cells of equal duration.
TimedCells even(std::size_t count, double seconds) {
  TimedCells cells;
  cells.axes = 1;
  for (std::size_t k = 0; k < count; ++k) {
    const double travel = speed * seconds;
    cells.laws.push_back({seconds, travel, true, speed, 0, 0});
    cells.sources.emplace_back();
    cells.path.insert(cells.path.end(), {static_cast<double>(k) * travel, 1, 0, 0, 0, 0});
  }
  return cells;
}

std::string samples_of(const TimedCells& cells, const SampleOptions& options, SampleEnd end = SampleEnd::none) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  SampleWriter writer(file.get(), {"X"}, {{200}, {1000}, {20000}}, options);
  writer.take(cells);
  writer.finish();
  EXPECT_TRUE(writer.ok());
  EXPECT_EQ(writer.ended(), end);
  std::rewind(file.get());
  std::string text(1 << 20, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  return text;
}

TEST(samples, a_row_an_instant_and_the_end) {
  EXPECT_EQ(samples_of(even(1, 0.0025), {}),
            "t,X\n0.000000,0.000000000\n0.001000,0.100000000\n0.002000,0.200000000\n0.003000,0.250000000\n");
}

TEST(samples, the_spindle_is_the_last_column) {
  TimedCells cells = even(1, 0.001);
  cells.spindle.push_back({90, 360, 0});
  EXPECT_EQ(samples_of(cells, {1000, {}, true}), "t,X,spindle\n0.000000,0.000000000,90.000000000\n0.001000,0.100000000,90.360000000\n");
}

// More cells at once than are kept; together they are shorter than the required look-ahead.
TEST(samples, of_many_tiny_cells) {
  const std::string text = samples_of(even(40000, 1e-5), {});
  EXPECT_NEAR(static_cast<double>(std::count(text.begin(), text.end(), '\n')), 1 + 401, 1);  // the sum of 40,000 durations is rounded
  EXPECT_TRUE(text.ends_with(",40.000000000\n")) << text.substr(text.size() - 60);
}

// The hold never ends: the samples go to the last position that was reached.
TEST(samples, a_hold_without_end) {
  const std::string text = samples_of(even(40000, 1e-5), {1000, {{0.1, 0}}});
  const auto rows = std::count(text.begin(), text.end(), '\n');
  EXPECT_GT(rows, 150);
  EXPECT_LT(rows, 400);
}

/// Returns a cell in which the axes do not move, as in a dwell.
TimedCells standing(double seconds) {
  TimedCells cells;
  cells.axes = 1;
  cells.laws.push_back({seconds, 0, true, 0, 0, 0});
  cells.sources.push_back({7});
  cells.path = {5, 0, 0, 0, 0, 0};
  return cells;
}

TEST(samples, end_where_they_must_not_be_longer) {
  EXPECT_EQ(samples_of(even(1, 0.01), {1000, {}, false, 0.0025}, SampleEnd::max_time),
            "t,X\n0.000000,0.000000000\n0.001000,0.100000000\n0.002000,0.200000000\n");
}

TEST(samples, just_within_what_is_allowed_they_are_whole) {
  EXPECT_EQ(samples_of(even(1, 0.0025), {1000, {}, false, 0.0035}), samples_of(even(1, 0.0025), {}));
}

// G4 P99999999 lasts three years.
TEST(samples, of_a_dwell_without_end_last_as_long_as_is_allowed) {
  const std::string text = samples_of(standing(99999999), {1000, {}, false, 2.0005}, SampleEnd::max_time);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 2001);
}

// Held before its end: nothing more will happen.
TEST(samples, a_hold_without_end_is_no_motion_that_goes_on) { samples_of(even(40000, 1e-5), {1000, {{0.1, 0}}, false, 0.39}); }

TEST(samples, stop_as_soon_as_they_are_asked_to) {
  std::atomic<bool> flag{true};
  SampleOptions options;
  options.stop = StopToken(flag);
  EXPECT_EQ(samples_of(even(1, 0.01), options, SampleEnd::stopped), "t,X\n");
}

TEST(samples, of_a_long_dwell_stop_within_an_instant) {
  using namespace std::chrono_literals;
  std::atomic<bool> flag{false};
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen("/dev/null", "w"), &std::fclose);
  SampleOptions options;
  options.stop = StopToken(flag);
  options.max_time = 1e9;
  SampleWriter writer(file.get(), {"X"}, {{200}, {1000}, {20000}}, options);
  std::chrono::steady_clock::time_point asked;
  std::thread operates([&] {
    std::this_thread::sleep_for(20ms);
    asked = std::chrono::steady_clock::now();
    flag = true;
  });
  writer.take(standing(99999999));
  const auto ended = std::chrono::steady_clock::now();
  operates.join();
  EXPECT_EQ(writer.ended(), SampleEnd::stopped);
  EXPECT_LT(ended - asked, 100ms);
  EXPECT_EQ(writer.tag(), 7U);
}

}  // namespace
}  // namespace kadr::samples_test
