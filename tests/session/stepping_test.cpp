// Stepping: where a session is held, lines entered by the operator, and that a stepped program does the same as an uninterrupted run.

#include "session/stepping.h"

#include "session/a_session.h"

namespace kadr::stepping_test {
namespace {

using How = Stepping::How;
using State = Session::State;
using test::ASession;

const char* const calls =
    "N10 G21 G90\n"
    "N20 #100=1\n"
    "N30 M98 P200\n"
    "N40 G0 X10\n"
    "\n"
    "N50 #100=#100+1\n"
    "N60 IF[#100LT4]GOTO30\n"
    "N70 M30\n"
    "O200\n"
    "G1 X20 F200\n"
    "Y20\n"
    "M99\n";

/// Returns the lines before which the session is held until it is over.
std::vector<std::uint32_t> lines(Stepping& stepping, How how, std::size_t most = 1000) {
  std::vector<std::uint32_t> held;
  while (held.size() < most && stepping.go(how) == State::held) held.push_back(stepping.next()->line);
  return held;
}

TEST(stepping, holds_before_each_block_that_holds_anything) {
  ASession s("nct", calls);
  Stepping stepping(*s);
  EXPECT_EQ(lines(stepping, How::block, 12), (std::vector<std::uint32_t>{1, 2, 3, 9, 10, 11, 12, 4, 6, 7, 3, 9}));
}

TEST(stepping, single_block_does_not_stop_at_comments) {
  ASession s("linuxcnc", "(PLATE)\n; BY HAND\nG21 G90\n(SLOT)\nN20 (IN)\nG0 X1 (FAST)\n(MSG, turn)\n(END)\nM2\n");
  Stepping stepping(*s);
  EXPECT_EQ(stepping.go(How::block), State::held) << "the machine is loaded";
  EXPECT_EQ(stepping.next()->line, 1U);
  EXPECT_EQ(lines(stepping, How::single, 2), (std::vector<std::uint32_t>{6, 7})) << "the first press executes G21 G90";
}

TEST(stepping, single_block_at_the_last_block) {
  ASession s("mach3", "G21 G90\n(END)\nG0 X1\n(OFF)\nM30\n(REST)\n");
  Stepping stepping(*s);
  EXPECT_EQ(lines(stepping, How::single), (std::vector<std::uint32_t>{1, 3, 5}));
}

TEST(stepping, over_stays_out_of_calls) {
  ASession s("nct", calls);
  Stepping stepping(*s);
  EXPECT_EQ(lines(stepping, How::over), (std::vector<std::uint32_t>{1, 2, 3, 4, 6, 7, 3, 4, 6, 7, 3, 4, 6, 7, 8}));
}

TEST(stepping, out_leaves_the_innermost_call) {
  ASession s("nct", calls);
  Stepping stepping(*s);
  StopPoint inside;
  inside.line = 11;
  ASSERT_EQ(stepping.go_to(inside), State::held);
  ASSERT_EQ(s->control().calls().size(), 1U);
  EXPECT_EQ(s->control().calls()[0].what, "O200");
  EXPECT_EQ(s->control().calls()[0].line, 3U);
  ASSERT_EQ(stepping.go(How::out), State::held);
  EXPECT_EQ(stepping.next()->line, 4U);
  EXPECT_TRUE(s->control().calls().empty());
}

TEST(stepping, to_a_pass_of_a_line) {
  ASession s("nct", calls);
  Stepping stepping(*s);
  StopPoint third;
  third.line = 10;
  third.pass = 3;
  ASSERT_EQ(stepping.go_to(third), State::held);
  EXPECT_EQ(stepping.value("#100").value(), 3);
  third.pass = 4;
  EXPECT_EQ(stepping.go_to(third), State::ended);
  EXPECT_EQ(stepping.passes(10), 3U);
}

TEST(stepping, stop_points_by_line_condition_and_call) {
  ASession s("nct", calls);
  Stepping stepping(*s);
  StopPoint condition, call;
  condition.line = 4;
  condition.condition = "#100 >= 2";
  call.call = "O200";
  const std::size_t first = stepping.add(condition), second = stepping.add(call);
  ASSERT_EQ(stepping.go(How::free), State::held);
  EXPECT_EQ(stepping.next()->line, 9U);
  EXPECT_EQ(stepping.hit(), second);
  ASSERT_TRUE(stepping.remove(second));
  EXPECT_FALSE(stepping.remove(second));
  ASSERT_EQ(stepping.go(How::free), State::held);
  EXPECT_EQ(stepping.next()->line, 4U);
  EXPECT_EQ(stepping.hit(), first);
  EXPECT_EQ(stepping.value("#100").value(), 2);
  StopPoint anywhere;
  anywhere.condition = "#100 EQ 4";
  ASSERT_TRUE(stepping.remove(first));
  (void)stepping.add(anywhere);
  ASSERT_EQ(stepping.go(How::free), State::held);
  EXPECT_EQ(stepping.next()->line, 7U);  // the condition became true one block before
}

TEST(stepping, past_a_line_with_the_calls_it_makes) {
  ASession s("nct", calls);
  Stepping stepping(*s);
  ASSERT_EQ(stepping.go_past(3), State::held);
  EXPECT_EQ(stepping.next()->line, 4U);
  EXPECT_EQ(s->stop_here(), State::ended);
  EXPECT_NE(s.trace().find(R"("to":{"X":20,"Y":20)"), std::string::npos);
  EXPECT_EQ(s.trace().find(R"("do":"rapid")"), std::string::npos);
}

TEST(stepping, values_are_written_as_the_control_writes_them) {
  const struct {
    const char *control, *program, *expression;
    double value;
  } rows[] = {{"nct", "#100=7\nX1\n", "#100*2+SIN[30]", 14.5},
              {"mach3", "#100=7\nX1\n", "#100*2+1", 15},
              {"s2c42", "%\nN10 R2 5\nN20 X1\n", "R2", 5}};
  for (const auto& row : rows) {
    ASession s(row.control, row.program);
    Stepping stepping(*s);
    while (stepping.go(How::block) == State::held && stepping.line().text.find('X') == std::string::npos) {
    }
    const auto value = stepping.value(row.expression);
    ASSERT_TRUE(value) << row.control;
    EXPECT_EQ(*value, row.value) << row.control;
    EXPECT_FALSE(stepping.value("")) << row.control;
    EXPECT_FALSE(stepping.value("]")) << row.control;
    EXPECT_FALSE(stepping.value("1 2")) << row.control;
  }
}

TEST(stepping, a_line_of_the_operator_leaves_the_program_where_it_was) {
  ASession s("nct", calls);
  Stepping stepping(*s);
  StopPoint inside;
  inside.line = 11;
  inside.pass = 2;
  ASSERT_EQ(stepping.go_to(inside), State::held);
  EXPECT_EQ(stepping.enter("G91 G0 Z7 #101=9"), State::stopped);  // an assignment must be alone in its block
  EXPECT_EQ(s.reported().back(), "statement_not_alone 1");
  EXPECT_EQ(stepping.next()->line, 11U);
  EXPECT_EQ(stepping.enter("G91 G0 Z7"), State::held);
  EXPECT_EQ(stepping.next()->line, 11U);
  EXPECT_EQ(s->control().tool_position().work[2], 7);
  EXPECT_EQ(stepping.enter("G90 M98 P200"), State::held);  // a call is executed as a whole
  EXPECT_EQ(s->control().tool_position().work[1], 20);
  EXPECT_EQ(stepping.next()->line, 11U);
  ASSERT_EQ(stepping.go(How::block), State::held);
  EXPECT_EQ(stepping.next()->line, 12U);
  EXPECT_EQ(stepping.go(How::free), State::ended);
  EXPECT_EQ(stepping.value("#100").value(), 4);
  EXPECT_EQ(stepping.enter("G0 X-5"), State::ended);  // also after the end of the program
  EXPECT_EQ(s->control().tool_position().work[0], -5);
}

TEST(stepping, back_to_where_it_was_held) {
  ASession s("mach3", "G0 X1\nG1 X2 F100\nG81 X3 Z-1 R1 L3\nX9\nM30\n");
  Stepping stepping(*s);
  ASSERT_EQ(stepping.go(How::block), State::held);
  ASSERT_EQ(stepping.go(How::block), State::held);
  const auto before = stepping.snapshot();
  ASSERT_TRUE(before);
  EXPECT_EQ(stepping.go(How::free), State::ended);
  const std::string whole = s.trace();
  ASSERT_TRUE(stepping.restore(*before));
  EXPECT_EQ(stepping.next()->line, 2U);
  EXPECT_EQ(stepping.go(How::free), State::ended);
  const std::string again = s.trace().substr(whole.size());
  EXPECT_FALSE(again.empty());
  EXPECT_TRUE(whole.ends_with(again));
}

/// The output of a program does not depend on whether it is stepped through.
TEST(stepping, block_by_block_as_in_one_go) {
  std::size_t programs = 0, shown = 0;
  test::for_each_program([&](const test::Work& work) {
    ASession whole(work.id, work.program, work.setup, work.main_file), stepped(work.id, work.program, work.setup, work.main_file);
    if (!whole.opened() || whole->channels().size() > 1) return;
    const State end = whole->run();
    Stepping stepping(*stepped);
    State state = State::held;
    for (std::size_t i = 0; i < 100'000 && state == State::held; ++i) state = stepping.go(How::block);
    ++programs;
    if ((whole.trace() != stepped.trace() || whole.reported() != stepped.reported() || end != state) && ++shown <= 10)
      ADD_FAILURE() << work.where << "\n" << test::difference(whole.trace(), stepped.trace()) << "\n" << work.program.substr(0, 1000);
  });
  EXPECT_GT(programs, 1700U);
}

}  // namespace
}  // namespace kadr::stepping_test
