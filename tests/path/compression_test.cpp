// path/smooth/compression: joins short motions. NCT 4.7, N3103.

#include "path/smooth/compression.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "actions.h"

namespace kadr::compression_test {
namespace {

using test::action;
using test::straight;
using enum MotionKind;

constexpr double accuracy = 0.01;

Action short_motion(Vec3 to, std::uint32_t line, MotionKind kind = feed) {
  Motion m = straight(kind, to, 500);
  m.join = accuracy;
  m.named = 1;
  return action(m, line);
}

/// Returns the actions after compression in batches of this size; with the last batch the compression learns that nothing follows.
std::vector<Action> compressed(const std::vector<Action>& actions, std::size_t batch_size, const Axes& start = {}) {
  Compression compression;
  ActionBatch batch;
  std::vector<Action> out;
  Axes at = start;
  for (std::size_t first = 0; first < actions.size(); first += batch_size) {
    batch.clear();
    const std::size_t end = std::min(actions.size(), first + batch_size);
    for (std::size_t i = first; i < end; ++i) batch.add() = actions[i];
    (void)compression.take(batch, at, end == actions.size());
    for (const Action& a : batch) {
      out.push_back(a);
      if (const auto* const m = std::get_if<Motion>(&a.what)) at = m->to;
      if (const auto* const f = std::get_if<FrameChange>(&a.what)) at = f->work;
    }
  }
  return out;
}

std::vector<std::uint32_t> lines(const std::vector<Action>& actions) {
  std::vector<std::uint32_t> all;
  for (const Action& a : actions) all.push_back(a.origin.line);
  return all;
}

const std::vector<Action> manual = {  // 4.7, golden 04-42
    short_motion({25.432, 47.847, 0}, 2500), short_motion({25.434, 47.843, 0}, 2510), short_motion({25.437, 47.839, 0}, 2520),
    short_motion({25.439, 47.835, 0}, 2530), short_motion({25.440, 47.831, 0}, 2540), short_motion({25.442, 47.827, 0}, 2550)};
const Axes manual_start{25.42, 47.87, 0};

TEST(compression, the_manuals_example) {
  for (const std::size_t size : {1U, 2U, 3U, 6U})
    EXPECT_EQ(lines(compressed(manual, size, manual_start)), (std::vector<std::uint32_t>{2500, 2530, 2550})) << size;
}

TEST(compression, something_else_lets_the_rest_out) {
  std::vector<Action> all(manual.begin(), manual.begin() + 3);
  all.push_back(action(straight(rapid, {0, 0, 0}), 7));
  for (const std::size_t size : {1U, 2U, 4U}) {
    const auto out = compressed(all, size, manual_start);
    EXPECT_EQ(lines(out), (std::vector<std::uint32_t>{2500, 2520, 7})) << size;
    EXPECT_EQ(std::get<Motion>(out[1].what).to[0], 25.437);
  }
  Action dwell{};
  dwell.what = Dwell{1};
  all[3] = dwell;
  EXPECT_EQ(lines(compressed(all, 1, manual_start)), (std::vector<std::uint32_t>{2500, 2520, 0}));
}

TEST(compression, equal_to_the_accuracy_is_not_beyond) {
  const auto out = compressed({short_motion({0.01, 0, 0}, 1), short_motion({0.0101, 0, 0}, 2)}, 1);
  EXPECT_EQ(lines(out), (std::vector<std::uint32_t>{2}));
}

TEST(compression, there_and_back_is_no_motion) {
  const auto out = compressed({short_motion({0.005, 0, 0}, 1), short_motion({0, 0, 0}, 2), short_motion({1, 0, 0}, 3)}, 1);
  EXPECT_EQ(lines(out), (std::vector<std::uint32_t>{3}));
  EXPECT_TRUE(compressed({short_motion({0.005, 0, 0}, 1), short_motion({0, 0, 0}, 2)}, 1).empty());
}

TEST(compression, exact_stop_ends_where_it_should) {
  Action stop = short_motion({0.004, 0, 0}, 2);
  std::get<Motion>(stop.what).exact = true;
  const auto out = compressed({short_motion({0.002, 0, 0}, 1), stop, short_motion({0.006, 0, 0}, 3)}, 1);
  EXPECT_EQ(lines(out), (std::vector<std::uint32_t>{2, 3}));
}

TEST(compression, named_axes_add_up) {
  Action y = short_motion({0.002, 0.05, 0}, 2);
  std::get<Motion>(y.what).named = 2;
  const auto out = compressed({short_motion({0.002, 0, 0}, 1), y}, 1);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(std::get<Motion>(out[0].what).named, 3U);
}

TEST(compression, threads_surfaces_and_arcs_are_left_alone) {
  Action with_detail = short_motion({0.001, 0, 0}, 1);
  std::get<Motion>(with_detail.what).detail = std::make_shared<MotionDetail>();
  const auto out = compressed({with_detail, short_motion({0.002, 0, 0}, 2, arc_cw), short_motion({0.003, 0, 0}, 3, thread)}, 1);
  EXPECT_EQ(lines(out), (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST(compression, single_block_stops_behind_the_joined_motion) {  // 4.7
  Action stop{};
  stop.what = Stop{false, StopReason::single_block};
  std::vector<Action> all;
  for (const Action& a : manual) {
    all.push_back(a);
    stop.origin.line = a.origin.line + 1;
    all.push_back(stop);
  }
  for (const std::size_t size : {1U, 2U, 3U, 12U})
    EXPECT_EQ(lines(compressed(all, size, manual_start)), (std::vector<std::uint32_t>{2500, 2501, 2530, 2531, 2550, 2551})) << size;
}

TEST(compression, counts_what_belongs_to_batches_before) {
  Compression compression;
  ActionBatch batch;
  batch.add() = short_motion({0.005, 0, 0}, 1);
  EXPECT_EQ(compression.take(batch, {}, false), 0U);
  EXPECT_TRUE(batch.empty());
  batch.add() = action(straight(rapid, {5, 0, 0}), 2);
  EXPECT_EQ(compression.take(batch, {}, false), 1U);
  EXPECT_EQ(batch.size(), 2U);
  batch.clear();
  batch.add() = short_motion({5.005, 0, 0}, 3);
  batch.add() = action(straight(rapid, {6, 0, 0}), 3);
  EXPECT_EQ(compression.take(batch, {5}, false), 0U);
}

TEST(compression, what_was_taken_back_is_not_let_out) {
  Compression compression;
  ActionBatch batch;
  batch.add() = short_motion({0.005, 0, 0}, 1);
  (void)compression.take(batch, {}, false);
  compression.drop();
  batch.clear();
  EXPECT_EQ(compression.take(batch, {}, true), 0U);
  EXPECT_TRUE(batch.empty());
}

/// The rule of NCT 4.7 applied to one motion after the other: returns the lines whose ends are output.
std::vector<std::uint32_t> slow_twin(const std::vector<Action>& actions) {
  std::vector<std::uint32_t> out;
  Axes at{};
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const Axes& to = std::get<Motion>(actions[i].what).to;
    const bool beyond = std::fabs(to[0] - at[0]) > accuracy || std::fabs(to[1] - at[1]) > accuracy || std::fabs(to[2] - at[2]) > accuracy;
    const bool rest = i + 1 == actions.size() && to != at;
    if (!beyond && !rest) continue;
    out.push_back(actions[i].origin.line);
    at = to;
  }
  return out;
}

RC_GTEST_PROP(compression, does_what_the_slow_twin_does_in_any_batches, ()) {
  std::vector<Action> all;
  Vec3 at;
  const int count = *rc::gen::inRange(1, 60);
  for (int i = 0; i < count; ++i) {
    const auto step = [] { return *rc::gen::inRange(-15, 16) / 1000.0; };
    at = at + Vec3{step(), step(), step()};
    all.push_back(short_motion(at, static_cast<std::uint32_t>(i + 1)));
  }
  RC_ASSERT(lines(compressed(all, static_cast<std::size_t>(*rc::gen::inRange(1, 20)))) == slow_twin(all));
}

RC_GTEST_PROP(compression, without_join_nothing_changes, ()) {
  std::vector<Action> all;
  for (int i = 0; i < 20; ++i) {
    Action a = short_motion({*rc::gen::inRange(-5, 5) / 1000.0, 0, 0}, static_cast<std::uint32_t>(i));
    std::get<Motion>(a.what).join = 0;
    all.push_back(a);
  }
  RC_ASSERT(lines(compressed(all, 3)) == lines(all));
}

}  // namespace
}  // namespace kadr::compression_test
