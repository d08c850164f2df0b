// Checkpoints: a line reached from a snapshot gives the same state, and the
// same continuation, as the line reached by executing everything before it.

#include "session/checkpoints.h"

#include <random>

#include "session/a_session.h"

namespace kadr::checkpoints_test {
namespace {

using test::ASession;

/// Returns lines in a row, a loop that calls a subprogram at the end of the file, and a loop in the middle.
std::string long_program(std::size_t lines) {
  std::string text = "G21 G90 G17 F500\n#1=0\n";
  for (std::size_t i = 0; i < lines; ++i) {
    if (i % 100 == 50) text += "M98 P200\n";
    else if (i == lines / 2) text += "WHILE[#1LT300]DO1\n#1=#1+1\nG1 X#1\nEND1\n";
    else text += "G1 X" + std::to_string(i % 77) + " Y" + std::to_string(i % 13) + "\n";
  }
  return text + "M30\nO200\n#100=#100+1\nG1 Z#100\nM99\n";
}

struct Place {
  Session::State state;
  std::uint64_t blocks = 0;
  std::vector<InForce> in_force;
  ToolPosition stand;
};

Place place_of(Session& session, Session::State state) {
  return {state, session.control().blocks(), session.control().in_force(), session.stand()};
}

class CheckpointsOf : public testing::TestWithParam<std::size_t> {};  // the greatest number of checkpoints kept

TEST_P(CheckpointsOf, reach_what_is_reached_from_the_beginning) {
  const std::string program = long_program(4000);
  ASession kept("nct", program), checked("nct", program);
  Checkpoints checkpoints(*kept, 200, GetParam());
  ASSERT_EQ(checkpoints.run(), Session::State::ended);
  EXPECT_LE(checkpoints.count(), GetParam());
  EXPECT_GE(checkpoints.count(), std::min<std::size_t>(GetParam() / 2, 10));
  Stepping from_kept(*kept);
  std::mt19937 choose(3);
  std::vector<StopPoint> targets(40);
  for (StopPoint& target : targets) target.line = std::uniform_int_distribution<std::uint32_t>(1, 4007)(choose);
  for (const std::uint32_t pass : {1U, 2U, 150U, 300U, 301U}) targets.push_back({.line = 2004, .pass = pass});  // in the loop
  for (const std::uint32_t pass : {1U, 7U, 40U, 41U}) targets.push_back({.line = 4009, .pass = pass});          // in the subprogram
  targets.push_back({.line = 9999});
  for (const StopPoint& target : targets) {
    ASession plain("nct", program);
    Stepping from_start(*plain);
    const Place expected = place_of(*plain, from_start.go_to(target));
    const auto reached = checkpoints.reach(from_kept, target);
    ASSERT_TRUE(reached);
    const Place found = place_of(*kept, *reached);
    ASSERT_EQ(found.state, expected.state) << target.line << ":" << target.pass;
    if (found.state != Session::State::held) continue;
    EXPECT_EQ(found.blocks, expected.blocks) << target.line << ":" << target.pass;
    EXPECT_EQ(found.in_force, expected.in_force) << target.line << ":" << target.pass;
    EXPECT_EQ(found.stand.work, expected.stand.work) << target.line << ":" << target.pass;
    const std::size_t before = kept.trace().size(), plain_before = plain.trace().size();
    for (int i = 0; i < 20; ++i) (void)from_kept.go(Stepping::How::block), (void)from_start.go(Stepping::How::block);
    EXPECT_EQ(kept.trace().substr(before), plain.trace().substr(plain_before)) << target.line << ":" << target.pass;
  }
}

INSTANTIATE_TEST_SUITE_P(checkpoints, CheckpointsOf, testing::Values(2, 5, 64));

TEST(checkpoints, of_blocks_that_do_nothing_too) {
  ASession s("nct", "#1=0\nWHILE[#1LT5000]DO1\n#1=#1+1\nEND1\nG0 X1\nM30\n");
  Checkpoints checkpoints(*s, 1000);
  ASSERT_EQ(checkpoints.run(), Session::State::ended);
  EXPECT_GE(checkpoints.count(), 10U);
}

}  // namespace
}  // namespace kadr::checkpoints_test
