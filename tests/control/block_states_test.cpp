// Control::state_of(): returns the state of the block that an action belongs to, although the control has already read far ahead.

#include "control/state/block_states.h"

#include "control/run_program.h"

namespace kadr::block_states_test {
namespace {

ControlState with_feed(double feed) {
  ControlState state;
  state.modal.rows.fill(-1);
  state.modal.feed = feed;
  return state;
}

TEST(block_states, gives_the_state_of_the_last_block_not_after_the_one_asked_for) {
  BlockStates states;
  states.note(3, with_feed(100));
  states.note(4, with_feed(100));
  states.note(7, with_feed(200));
  EXPECT_EQ(states.of(2), nullptr);
  EXPECT_EQ(states.of(3)->modal.feed, 100);
  EXPECT_EQ(states.of(6)->modal.feed, 100);
  EXPECT_EQ(states.of(7)->modal.feed, 200);
  EXPECT_EQ(states.of(1'000'000)->modal.feed, 200);
  EXPECT_EQ(states.of(3), states.of(6));  // the state is stored once
}

TEST(block_states, a_position_is_no_change) {
  BlockStates states;
  ControlState state = with_feed(1);
  states.note(1, state);
  state.position.work[0] = 5;
  states.note(2, state);
  EXPECT_EQ(states.of(1), states.of(2));
}

TEST(block_states, a_block_that_is_refused_is_noted_anew) {
  BlockStates states;
  states.note(1, with_feed(1));
  states.note(2, with_feed(2));
  states.note(2, with_feed(3));
  EXPECT_EQ(states.of(2)->modal.feed, 3);
}

TEST(block_states, forgets_the_oldest_beyond_its_size) {
  BlockStates states;
  for (std::uint32_t i = 0; i <= BlockStates::most; ++i) states.note(i, with_feed(i));
  EXPECT_EQ(states.of(0), nullptr);
  EXPECT_EQ(states.of(1)->modal.feed, 1);
}

TEST(block_states, numbers_may_run_over) {
  BlockStates states;
  std::uint32_t block = 0xFFFF'FFF0u;
  for (int i = 0; i < 40; ++i) states.note(block++, with_feed(i / 20));
  EXPECT_EQ(states.of(0xFFFF'FFF5u)->modal.feed, 0);
  EXPECT_EQ(states.of(5)->modal.feed, 1);
  for (std::uint64_t gone = 0; gone < 5'000'000'000; gone += 1'000'000'000) states.note(block += 1'000'000'000, with_feed(1));
  EXPECT_EQ(states.of(block)->modal.feed, 1);
}

/// Returns the modes after each block, by the block's number. The control returns after each block.
std::map<std::uint32_t, std::vector<std::string>> modes_by_block(const std::string& id, const std::string& program) {
  Control control(test::control(id), {}, Program{"p", text_source(program), {}}, RunLimits{});
  control.return_each_block();
  std::map<std::uint32_t, std::vector<std::string>> modes;
  ActionBatch batch;
  while (control.run(batch) == Control::State::running)
    if (!batch.empty() && control.snapshot()) modes[batch.back().origin.number] = control.ending().modal;
  if (!batch.empty()) modes[batch.back().origin.number] = control.ending().modal;
  return modes;
}

/// Compares the states with those of a second control that is queried after each block.
void same_as_block_by_block(const std::string& id, const std::string& program) {
  const auto expected = modes_by_block(id, program);
  Control control(test::control(id), {}, Program{"p", text_source(program), {}}, RunLimits{});
  control.watch_states();
  ActionBatch batch;
  std::vector<Origin> origins;
  for (Control::State state = Control::State::running; state == Control::State::running;) {
    state = control.run(batch);
    for (const Action& action : batch) origins.push_back(action.origin);
  }
  std::size_t compared = 0;
  for (const Origin& origin : origins) {
    const auto twin = expected.find(origin.number);
    if (twin == expected.end() || origin.number == 0) continue;
    const auto state = control.state_of(origin);
    ASSERT_TRUE(state) << origin.line;
    EXPECT_EQ(state->modal, twin->second) << id << " line " << origin.line;
    ++compared;
  }
  EXPECT_GT(compared, 5U);
}

TEST(state_of, is_that_of_the_action_s_block) {
  same_as_block_by_block("mach3",
                         "G21 G0 X1\nG1 X2 F100\nF200 X3\nM98 P7 L2\nG91 G1 X1\nS500 M3\nG81 X1 Z-1 R1 F50 L30\nG80\nG90 X0\nM30\n"
                         "O7\nG1 Y#1 F300\n#1=[#1+1]\nG0 Y0\nM99\n");
  same_as_block_by_block("nct",
                         "G0 X1\nG1 X2 F100\n#1=0\nWHILE[#1LT200]DO1\n#1=#1+1\nG1 X#1 F[100+#1]\nEND1\nG91 X1\nG17 G2 X1 Y1 R5\nM30\n");
  same_as_block_by_block("gost", "%\nG90 G0 X1\nG1 X2 F100\nX3 F50\nG91 X1\nG0 X5\nS100 M3\nX1\nM2\n");
}

TEST(state_of, tells_tool_and_frames) {
  const auto setup = parse_setup(R"({"offsets": {"2": {"length": 30}}, "work_offsets": {"G55": {"X": 7}}})").value();
  Control control(test::control("nct"), setup, Program{"p", text_source("T5 M6\nG55 G43 H2 G0 Z10\nG0 X1\nM30\n"), {}}, RunLimits{});
  control.watch_states();
  ActionBatch batch;
  (void)control.run(batch);
  const Action* last = nullptr;
  for (const Action& action : batch)
    if (std::holds_alternative<Motion>(action.what)) last = &action;
  ASSERT_NE(last, nullptr);
  const auto state = control.state_of(last->origin);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->origin[0], 7);
  EXPECT_EQ(state->length[2], 30);
  EXPECT_EQ(state->tool, 5U);
}

TEST(state_of, is_nothing_where_nobody_watches) {
  Control control(test::control("mach3"), {}, Program{"p", text_source("G0 X1\nM30\n"), {}}, RunLimits{});
  ActionBatch batch;
  (void)control.run(batch);
  EXPECT_FALSE(control.state_of(batch.back().origin));
}

}  // namespace
}  // namespace kadr::block_states_test
