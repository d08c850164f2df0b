// The material that blocks remove: closed forms of slots and walls, blocks shorter than a cell, lines in air, distances in calls.

#include "session/cutting/block_load.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "motion/time/estimate.h"
#include "session/a_session.h"
#include "session/cutting/air_lines.h"
#include "session/cutting/cutting.h"

namespace kadr::block_load_test {
namespace {

using test::ASession;

constexpr double diameter = 10, teeth = 2;

ToolGeometry end_mill() {
  ToolGeometry tool;
  tool.number = 1;
  tool.diameter = diameter;
  tool.flutes = 20;
  tool.length = 50;
  tool.teeth = int(teeth);
  return tool;
}

struct CutLoads {
  std::vector<BlockLoad> rows;
  CutResult result;
};

/// Cuts the program out of the block X, Y 0 to 60, Z -30 to 0.
CutLoads cut(const std::string& program, double cell) {
  ASession session("mach3", "T1 M6\nS1000 M3\n" + program + "M30\n");
  CutLoads loads;
  EXPECT_TRUE(session.opened());
  const AxisRoles roles = AxisRoles::of(session->control().axes(), session->control().rotary());
  CutJob job;
  job.blank = box_blank({{0, 0, -30}, {60, 60, 0}});
  job.tools.tools = {end_mill()};
  job.cell = cell;
  job.starts_known = true;
  job.keeps_rates = true;
  Cutting cutting(job, roles);
  cutting.on_block = [&](const BlockLoad& load) { loads.rows.push_back(load); };
  TimeEstimate clock(roles, rates_of(test::generic_machine(), {}, session->control().axes()));
  session->outlets().clock = &clock;
  session->outlets().step = [&](const Step& step) { EXPECT_TRUE(cutting.consume(step, {step.begins, step.time.seconds})); };
  EXPECT_EQ(session->run(), Session::State::ended);
  cutting.finish();
  loads.result = cutting.result(0, 0);
  for (const float rate : cutting.rates()) EXPECT_TRUE(rate >= 0);
  return loads;
}

const BlockLoad& row_of(const CutLoads& loads, std::uint32_t line) {
  const auto found = std::find_if(loads.rows.begin(), loads.rows.end(), [&](const BlockLoad& r) { return r.origin.line == line; });
  EXPECT_NE(found, loads.rows.end()) << line;
  return found == loads.rows.end() ? loads.rows.front() : *found;
}

double volume_of(const std::vector<BlockLoad>& rows) {
  return std::accumulate(rows.begin(), rows.end(), 0.0, [](double sum, const BlockLoad& r) { return sum + r.volume; });
}

double degrees_engaged(double width) { return std::acos(1 - 2 * width / diameter) / rad_per_deg; }

TEST(block_load, a_slot_in_the_full) {
  for (const double cell : {1.0, 0.5, 0.25}) {
    const CutLoads loads = cut("G0 X10 Y30 Z5\nG1 Z-3 F100\nG1 X50 F300\n", cell);
    const BlockLoad& slot = row_of(loads, 5);
    const double bound = 2 * cell / 40;  // one lattice line more or less at each end of the path
    EXPECT_NEAR(slot.seconds, 8, 1e-9);
    EXPECT_NEAR(slot.length, 40, 1e-9);
    EXPECT_NEAR(slot.volume, 1200, 1200 * bound);
    EXPECT_NEAR(slot.rate.value(), 150, 150 * bound);
    EXPECT_NEAR(slot.feed_per_tooth.value(), 300 / (1000 * teeth), 1e-9);
    EXPECT_NEAR(slot.depth.value(), 3, 1e-4);
    EXPECT_NEAR(slot.width.value(), diameter, diameter * bound);
    EXPECT_GT(slot.angle.value(), degrees_engaged(diameter * (1 - bound)));
    EXPECT_LE(slot.angle.value(), 180);
    EXPECT_NEAR(slot.at.x, 30, 1e-9);
    EXPECT_NEAR(slot.at.z, -3, 1e-9);
  }
}

TEST(block_load, a_wall) {
  // The tool's centre moves 2 mm outside the wall Y0, so the tool reaches 3 mm into the block.
  const CutLoads loads = cut("G0 X-20 Y-2 Z-4\nG1 X10 F300\nG1 X50\nG1 X80\n", 0.25);
  const BlockLoad& wall = row_of(loads, 5);
  EXPECT_NEAR(wall.depth.value(), 4, 1e-4);
  EXPECT_NEAR(wall.width.value(), 3, 0.05);
  EXPECT_NEAR(wall.angle.value(), degrees_engaged(3), 1);
  EXPECT_NEAR(wall.rate.value(), 3 * 4 * 5, 1);
}

TEST(block_load, a_second_level_is_as_deep_as_what_it_takes) {
  const CutLoads loads = cut("G0 X10 Y30 Z5\nG1 Z-3 F100\nG1 X50 F300\nG1 Z-5\nG1 X10\n", 0.25);
  EXPECT_NEAR(row_of(loads, 7).depth.value(), 2, 1e-4);
  EXPECT_NEAR(row_of(loads, 7).width.value(), diameter, 0.2);
}

TEST(block_load, a_flat_ramp_has_a_depth_and_a_steep_one_none) {
  // 4 mm down over 40 mm: at its end the block is 4 mm deep.
  const CutLoads loads = cut("G0 X10 Y30 Z0\nG1 X50 Z-4 F300\nG0 Z1\nG0 X10 Y50 Z0\nG1 X12 Z-4\n", 0.25);
  EXPECT_NEAR(row_of(loads, 4).depth.value(), 4, 0.05);
  EXPECT_FALSE(row_of(loads, 7).depth.has_value());
  EXPECT_FALSE(row_of(loads, 7).angle.has_value());
  EXPECT_TRUE(row_of(loads, 7).rate.has_value());
}

TEST(block_load, a_long_climb_is_as_deep_as_the_layer_that_it_takes) {
  // The same climb twice, the second time 0.5 mm lower.
  const CutLoads loads = cut("G0 X-20 Y30 Z-10\nG1 X80 Z0 F300\nG0 Z5\nG0 X-20\nG0 Z-10.5\nG1 X80 Z-0.5\n", 0.25);
  EXPECT_NEAR(row_of(loads, 8).depth.value(), 0.5, 0.02);
}

TEST(block_load, blocks_shorter_than_a_cell_share) {
  for (const double cell : {1.0, 0.5}) {
    std::string chords = "G0 X10 Y30 Z5\nG1 Z-3 F100\nF300\n";
    for (int i = 1; i <= 400; ++i) chords += "G1 X" + std::to_string(10 + 0.1 * i) + "\n";
    const CutLoads loads = cut(chords, cell);
    double volume = 0;
    for (const BlockLoad& r : loads.rows)
      if (r.origin.line > 5) {
        ASSERT_TRUE(r.rate.has_value());
        EXPECT_NEAR(*r.rate, 150, 150 * 0.25) << r.origin.line;
        EXPECT_NEAR(r.length, 0.1, 1e-9);
        volume += r.volume;
      }
    EXPECT_NEAR(volume, 1200, 1200 * 2 * cell / 40);
    EXPECT_NEAR(volume_of(loads.rows), loads.result.tools[0].removed, 1e-6);
  }
}

TEST(block_load, what_is_not_known_is_not_told) {
  const CutLoads loads = cut("G0 X10 Y30 Z5\nG1 Z-3 F100\nM5\nG1 X50 F300\n", 0.5);
  EXPECT_TRUE(row_of(loads, 4).feed_per_tooth.has_value());
  EXPECT_FALSE(row_of(loads, 6).feed_per_tooth.has_value());
  EXPECT_FALSE(row_of(loads, 4).depth.has_value());  // a plunge has no depth
}

TEST(air_lines, seconds_are_exact) {
  // 5 mm/s: 30 mm above the blank, forward and back, three times in a subprogram; then a slot.
  const CutLoads loads = cut("G0 X10 Y30 Z5\nM98 P7 L3\nG1 Z-3 F300\nG1 X50\nM30\nO7\nG1 X40 F300\nG1 X10\nM99\n", 0.5);
  ASSERT_EQ(loads.result.emptiest.size(), 2U);
  EXPECT_EQ(loads.result.emptiest[0].origin.line, 9U);
  EXPECT_NEAR(loads.result.emptiest[0].seconds, 18, 1e-9);
  EXPECT_EQ(loads.result.emptiest[1].origin.line, 10U);
  EXPECT_NEAR(loads.result.emptiest[1].seconds, 18, 1e-9);
}

TEST(air_lines, a_thin_layer_is_no_air) {
  // 0.05 mm of a wall, a tenth of a cell: the cut meets no vertical lattice line, but horizontal ones.
  const CutLoads loads = cut("G0 X-20 Y-4 Z-5\nG1 X80 F300\nG0 X-20 Y-3.95\nG1 X80\n", 0.5);
  EXPECT_TRUE(loads.result.emptiest.empty());
  const CutLoads again = cut("G0 X-20 Y-4 Z-5\nG1 X80 F300\nG0 X-20\nG1 X80\n", 0.5);
  ASSERT_EQ(again.result.emptiest.size(), 1U);
  EXPECT_NEAR(again.result.emptiest[0].seconds, 20, 1e-9);
}

TEST(air_lines, those_with_most_seconds_are_kept) {
  AirLines lines(0.1, 8);
  for (std::uint32_t line = 1; line <= 1000; ++line) {
    Origin origin;
    origin.line = origin.number = line;
    lines.add({origin, 1, line % 100 == 0 ? 50.0 + line : 0.001, 1, false});
  }
  const std::vector<AirCut> emptiest = lines.emptiest();
  ASSERT_GE(emptiest.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(emptiest[i].origin.line, 1000 - 100 * i);
  EXPECT_GT(lines.missing(), 0);
}

std::vector<CutMotion> some_motions() {
  const auto motions = *rc::gen::container<std::vector<std::tuple<int, int, int, bool>>>(
      rc::gen::tuple(rc::gen::inRange(1, 40), rc::gen::inRange(1, 30), rc::gen::inRange(0, 100), rc::gen::arbitrary<bool>()));
  std::vector<CutMotion> all;
  std::uint32_t number = 0;
  for (const auto& [line, length, volume, same_block] : motions) {
    CutMotion m;
    if (!same_block || all.empty()) ++number;
    m.origin = same_block && !all.empty() ? all.back().origin : Origin();
    if (!same_block || all.empty()) m.origin.line = std::uint32_t(line);
    m.origin.number = number;
    m.tool = 1 + number / 50, m.diameter = 10;
    m.begins = double(all.size()), m.seconds = length * 0.01, m.length = m.flat = length * 0.05;
    m.volume = volume, m.depth = 1;
    all.push_back(m);
  }
  return all;
}

RC_GTEST_PROP(block_loads, rows_in_order_with_all_of_the_volume, ()) {
  const std::vector<CutMotion> motions = some_motions();
  std::vector<BlockLoad> rows;
  BlockLoads loads(0.4);
  loads.on_block = [&](const BlockLoad& load) { rows.push_back(load); };
  std::vector<std::uint32_t> numbers;
  double volume = 0, seconds = 0;
  for (const CutMotion& m : motions) {
    loads.add(m);
    volume += m.volume, seconds += m.seconds;
    if (numbers.empty() || numbers.back() != m.origin.number) numbers.push_back(m.origin.number);
  }
  loads.finish();
  RC_ASSERT(rows.size() == numbers.size());
  for (std::size_t i = 0; i < rows.size(); ++i) RC_ASSERT(rows[i].origin.number == numbers[i]);
  RC_ASSERT(std::abs(volume_of(rows) - volume) < 1e-6);
  double sum = 0;
  for (const BlockLoad& r : rows) sum += r.seconds;
  RC_ASSERT(std::abs(sum - seconds) < 1e-9);
}

RC_GTEST_PROP(block_loads, heaviest_are_the_greatest_of_each_line, ()) {
  const std::vector<CutMotion> motions = some_motions();
  BlockLoads loads(0.01);  // short enough to keep each block separate
  std::map<std::uint32_t, double> greatest;
  loads.on_block = [&](const BlockLoad& load) {
    if (load.rate.value() > 0) greatest[load.origin.line] = std::max(greatest[load.origin.line], *load.rate);
  };
  for (const CutMotion& m : motions) loads.add(m);
  loads.finish();
  std::vector<double> want;
  for (const auto& [line, rate] : greatest) want.push_back(rate);
  std::sort(want.rbegin(), want.rend());
  want.resize(std::min(want.size(), max_reported));
  std::vector<double> got;
  for (const BlockLoad& load : loads.heaviest()) got.push_back(*load.rate);
  RC_ASSERT(got == want);
}

TEST(calls_of, the_way_of_calls_long_after) {
  ASession session("mach3",
                   "G0 X0\n"
                   "N20 M98 P100 L2\n"
                   "N30 M98 P200\n"
                   "G0 X9\n"
                   "M30\n"
                   "O100\n"
                   "G0 X1\n"
                   "M98 P200\n"
                   "M99\n"
                   "O200\n"
                   "G0 X2\n"
                   "M99\n");
  ASSERT_TRUE(session.opened());
  session->control().watch_calls();
  std::vector<Origin> origins;
  session->outlets().step = [&](const Step& step) {
    if (step.motion() != nullptr) origins.push_back(step.action.origin);
  };
  ASSERT_EQ(session->run(), Session::State::ended);
  std::vector<std::string> call_chains;
  for (const Origin& origin : origins) {
    std::string call_chain = std::to_string(origin.line) + ":";
    for (const AlarmReport::Call& call : session->control().calls_of(origin))
      call_chain += " " + call.what + "@" + std::to_string(call.line);
    call_chains.push_back(call_chain);
  }
  EXPECT_EQ(call_chains,
            (std::vector<std::string>{"1:", "7: O100@2", "11: O100@2 O200@8", "7: O100@2", "11: O100@2 O200@8", "11: O200@3", "4:"}));
  const AlarmReport report = session->settled_control().report_for(alarm(AlarmId::plunge, {}, 1.0, 1.0, std::string("X0")), origins[2]);
  EXPECT_EQ(report.calls.size(), 2U);
  EXPECT_EQ(report.line_text, "G0 X2");
}

}  // namespace
}  // namespace kadr::block_load_test
