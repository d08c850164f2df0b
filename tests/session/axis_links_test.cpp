// Axes of one channel that follow those of another (nct 20.2): the machine's
// positions equal those of a machine with all axes in one channel.

#include <random>

#include "session/a_session.h"

namespace kadr::axis_links_test {
namespace {

using test::ASession;

constexpr int programs = 100;

/// Returns motions of Y and Z with codes for the machine's logic between them: M41 and M40 for V, M51 and M50 for W.
std::string any_program(std::mt19937& random) {
  const auto below = [&](unsigned most) { return random() % most; };
  std::string text = "G90 F500\n";
  for (int blocks = 0; blocks < 20; ++blocks) {
    const std::string y = std::to_string(int(below(200)) - 100), z = std::to_string(int(below(200)) - 100);
    switch (below(8)) {
      case 0: text += "M41\n"; break;
      case 1: text += "M40\n"; break;
      case 2: text += "M51\n"; break;
      case 3: text += "M50\n"; break;
      case 4: text += "G91 G0 Z" + z + "\nG90\n"; break;
      case 5: text += "G19 G2 Y" + y + " Z" + z + " R500\n"; break;
      case 6: text += "G55 G0 Y" + y + "\nG54\n"; break;
      default: text += "G1 Y" + y + " Z" + z + "\n"; break;
    }
  }
  return text;
}

std::string set_up(const std::string& axes, const std::string& more) {
  return R"({"axes": [)" + axes + R"(], "work_offsets": {"G55": {"Y": 13}}, "parameters": {"N2101.V": 1, "N2101.W": 2, "N2102.W#0": 1},
    "events": [{"when": {"code": "M41"}, "do": "synchronise", "axes": ["V"]}, {"when": {"code": "M40"}, "do": "release", "axes": ["V"]},
               {"when": {"code": "M51"}, "do": "synchronise", "axes": ["W"]}, {"when": {"code": "M50"}, "do": "release", "axes": ["W"]}])" +
         more + "}";
}

Axes stand_of(const std::string& program, const std::string& setup, std::size_t channel) {
  ASession session("nct", program, parse_setup(setup).value());
  EXPECT_EQ(session->run(), Session::State::ended) << program;
  EXPECT_EQ(session->control().axes().size(), channel == 0 ? 4U : 2U);
  const Control& control = *session->channels()[channel].control;
  const Axes machine = session->stand(channel).machine;
  EXPECT_EQ(machine, control.tool_position().machine) << program;
  return machine;
}

TEST(axis_links, followers_of_another_channel_stand_as_those_of_the_same) {
  std::mt19937 random(20);
  for (int i = 0; i < programs; ++i) {
    const std::string program = any_program(random);
    const Axes alone = stand_of(program, set_up(R"("Y", "Z", "V", "W")", ""), 0);
    const Axes in_parallel =
        stand_of(program, set_up(R"("Y", "Z")", R"(, "channels": {"2": {"axes": ["V", "W"], "program": "G4 P1\n"}})"), 1);
    EXPECT_NEAR(in_parallel[0], alone[2], 1e-9) << program;
    EXPECT_NEAR(in_parallel[1], alone[3], 1e-9) << program;
  }
}

}  // namespace
}  // namespace kadr::axis_links_test
