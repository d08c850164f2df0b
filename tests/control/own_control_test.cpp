// A user's own control: any file that the loader accepts runs in all rooms, whatever the program is. Each function is tried on each of
// the five controls, then random files (fuzz/own_control.h). A crash prints the file and the program that caused it.
#include "../../fuzz/own_control.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <random>

namespace kadr::fuzz::own_control_test {
namespace {

std::string in_hand;  // printed when a crash happens

void show_and_end(int signal) {
  std::fputs(in_hand.c_str(), stderr);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

class OwnControl : public testing::Test {
 protected:
  void SetUp() override {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) std::signal(signal, show_and_end);
  }
  void TearDown() override {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) std::signal(signal, SIG_DFL);
  }

  std::vector<std::uint8_t> bytes(std::size_t count) {
    std::vector<std::uint8_t> all(count);
    for (std::uint8_t& b : all) b = static_cast<std::uint8_t>(random_());
    return all;
  }

  Tried run(Dice& dice, std::string_view base, std::string_view function) {
    const std::string file = control_file(dice, base, function);
    const std::string program = program_of(dice, dice.below(24) + 4);
    in_hand = file + "----\n" + program;
    std::string refusal;
    const Tried tried = try_own(file, program, static_cast<unsigned>(dice.below(16)), &refusal);
    if (tried == Tried::refused) {
      EXPECT_NE(refusal.find(':'), std::string::npos) << refusal;
    }
    return tried;
  }

  std::mt19937 random_{15};
};

TEST_F(OwnControl, EachFunctionOverEachControlIsRefusedOrRuns) {
  std::size_t ran = 0, refused = 0;
  for (std::size_t f = 0; f < static_cast<std::size_t>(Function::count); ++f)
    for (const std::string_view base : bases) {
      const auto all = bytes(400);
      Dice dice(all.data(), all.size());
      ++(run(dice, base, traits_of(static_cast<Function>(f)).name) == Tried::ran ? ran : refused);
    }
  EXPECT_GT(ran, 40U);
  EXPECT_GT(refused, 200U);
}

TEST_F(OwnControl, RandomFilesAreRefusedOrRun) {
  std::size_t ran = 0;
  for (int time = 0; time < 300; ++time) {
    const auto all = bytes(500);
    Dice dice(all.data(), all.size());
    const std::string_view base = dice.of(bases);
    if (run(dice, base, "") == Tried::ran) ++ran;
  }
  EXPECT_GT(ran, 25U);
}

}  // namespace
}  // namespace kadr::fuzz::own_control_test
