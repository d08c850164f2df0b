// Programs over a serial line: every profile there and back, a control with a small buffer that stops the sender at any place, faults.

#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <utility>

#include "drive/dnc/dnc_request.h"
#include "drive/dnc/dnc_transfer.h"

namespace kadr::drive::dnc_test {

std::string program(int lines) {
  std::string text = "%\n";
  for (int i = 1; i <= lines; ++i)
    text += "N" + std::to_string(i) + "G1X" + std::to_string(i * 37 % 1000) + "Y-" + std::to_string(i % 100) + "\n";
  return text + "M30\n%\n";
}

/// A control: it takes characters at the rate of the line, works them off slowly, stops the sender by DC3 and accepts only a few
/// characters after it.
struct SlowControl {
  static constexpr std::size_t buffer = 256, stop_at = 192, go_at = 64, most_after_stop = 10;
  std::string got;
  std::size_t waiting = 0, after_stop = 0, most_seen_after_stop = 0, lost = 0;
  bool stopped = false;
  double worked = 0;
  bool has_parity = true;

  std::string code(char c) const { return {has_parity ? static_cast<char>(with_even_parity(static_cast<std::uint8_t>(c))) : c}; }
  std::string take(char byte) {
    if (stopped) most_seen_after_stop = std::max(most_seen_after_stop, ++after_stop);
    if (waiting >= buffer || (stopped && after_stop > most_after_stop)) {
      ++lost;
      return {};
    }
    got += byte;
    if (++waiting < stop_at || stopped) return {};
    stopped = true;
    after_stop = 0;
    return code(dc3);
  }
  std::string work(double seconds, double per_second) {
    worked += seconds * per_second;
    while (worked >= 1 && waiting > 0) {
      --waiting;
      --worked;
    }
    if (waiting == 0) worked = 0;
    if (!stopped || waiting > go_at) return {};
    stopped = false;
    return code(dc1);
  }
};

/// Sends through a line with a baud rate and a delay of the answers. Returns the control.
SlowControl send(const DncProfile& profile, const std::string& bytes, double per_second, double delay, bool begins = true) {
  SlowControl control;
  DncSender sender(profile, bytes, 0);
  std::deque<std::pair<double, char>> line;
  std::deque<std::pair<double, std::string>> answers;
  if (begins) answers.emplace_back(0.1, control.code(dc1));
  const double per_character = 1 / characters_per_second(profile.line);
  double free_at = 0;
  for (double now = 0; now < 2000 && sender.state() != DncSender::State::sent; now += 0.001) {
    while (!answers.empty() && answers.front().first <= now) {
      sender.receive(answers.front().second, now);
      answers.pop_front();
    }
    for (const char byte : sender.take(now)) {
      free_at = std::max(free_at, now) + per_character;
      line.emplace_back(free_at, byte);
    }
    while (!line.empty() && line.front().first <= now) {
      const std::string answer = control.take(line.front().second);
      if (!answer.empty()) answers.emplace_back(now + delay, answer);
      line.pop_front();
    }
    const std::string answer = control.work(0.001, per_second);
    if (!answer.empty()) answers.emplace_back(now + delay, answer);
  }
  for (const auto& [at, byte] : line) (void)control.take(byte);
  return control;
}

TEST(Dnc, EveryProfileReadsWhatItSends) {
  for (const DncProfile& profile : dnc_profiles()) {
    const std::string text = program(200);
    const auto bytes = dnc_bytes(profile, text);
    ASSERT_TRUE(bytes) << profile.id;
    const DncText read = dnc_text(profile, *bytes);
    EXPECT_EQ(read.text, text) << profile.id;
    EXPECT_EQ(read.faults, 0U) << profile.id;
    EXPECT_EQ(dnc_profile_named(profile.id), &profile);
    EXPECT_TRUE(is_baud_rate(profile.line.baud));
  }
}

TEST(Dnc, PercentLinesAreAddedOnce) {
  const DncProfile& haas = *dnc_profile_named("haas-rs232");
  for (const char* const text : {"O1\nM30\n", "O1\nM30", "%\nO1\nM30\n%\n", "%\nO1\nM30\n%", "O1\nM30\n%\n"})
    EXPECT_EQ(*dnc_bytes(haas, text), "%\r\nO1\r\nM30\r\n%\r\n") << text;
  EXPECT_FALSE(dnc_bytes(haas, "(\xD0\x9F)"));
}

TEST(Dnc, ASlowControlLosesNothing) {
  std::mt19937 random(3);
  for (const char* const id : {"fanuc-rs232", "s2c42-tape", "generic", "haas-rs232", "eia"}) {
    const DncProfile& profile = *dnc_profile_named(id);
    const std::string bytes = *dnc_bytes(profile, program(300));
    for (const double per_second : {50.0, 173.0, 400.0}) {
      const SlowControl control = send(profile, bytes, per_second, 0.001 * static_cast<double>(random() % 4));
      EXPECT_EQ(control.lost, 0U) << id;
      EXPECT_TRUE(control.got == bytes) << id;
      EXPECT_LE(control.most_seen_after_stop, SlowControl::most_after_stop) << id;
    }
  }
}

TEST(Dnc, TenThousandLinesArriveWhereverTheControlStops) {
  const DncProfile& fanuc = *dnc_profile_named("fanuc-rs232");
  const std::string bytes = *dnc_bytes(fanuc, program(10'000));
  const SlowControl control = send(fanuc, bytes, 400, 0.002);
  EXPECT_TRUE(control.got == bytes);
  EXPECT_LE(control.most_seen_after_stop, SlowControl::most_after_stop);
}

TEST(Dnc, TheSenderWaitsForDc1AndEndsAtNak) {
  const DncProfile& fanuc = *dnc_profile_named("fanuc-rs232");
  DncSender sender(fanuc, "abc", 0);
  EXPECT_EQ(sender.take(1), "");
  sender.receive(std::string(1, dc3), 1);
  EXPECT_EQ(sender.state(), DncSender::State::waits);
  sender.receive("\x91", 2);  // DC1 with its parity bit
  EXPECT_EQ(sender.take(2), "abc");
  sender.receive("\x15", 3);
  EXPECT_EQ(sender.state(), DncSender::State::refused);
  EXPECT_EQ(sender.take(4), "");
}

TEST(Dnc, TheReceiverEndsAtTheSecondPercentOrAtSilence) {
  for (const DncProfile& profile : dnc_profiles()) {
    const std::string text = program(50);
    const std::string bytes = std::string(20, '\0') + std::string(1, dc2) + *dnc_bytes(profile, text) + std::string(1, dc4);
    DncReceiver receiver(profile, 0, 2);
    double now = 0;
    for (const char byte : bytes) receiver.receive(std::string(1, byte), now += 0.001);
    receiver.tick(now + 1);
    receiver.tick(now + 3);
    EXPECT_EQ(receiver.state(), DncReceiver::State::received) << profile.id;
    EXPECT_EQ(dnc_text(profile, receiver.bytes()).text.substr(0, text.size() - 1), text.substr(0, text.size() - 1)) << profile.id;
  }
}

TEST(Dnc, AChangedByteIsAFault) {
  const DncProfile& fanuc = *dnc_profile_named("fanuc-rs232");
  std::string bytes = *dnc_bytes(fanuc, program(5));
  bytes[7] = static_cast<char>(bytes[7] ^ 1);
  const DncText read = dnc_text(fanuc, bytes);
  EXPECT_EQ(read.faults, 1U);
  EXPECT_EQ(read.first_fault, 8U);
}

TEST(Dnc, ARequestNamesAProgramAndNothingElse) {
  EXPECT_EQ(requested_program("%\nO8000(SEND FLANGE.NC)\nM30\n%\n"), "FLANGE.NC");
  EXPECT_EQ(requested_program("%\nO8000\n(SEND 1234)\n%\n"), "1234");
  for (const char* const text :
       {"%\nO1\nG0X1\n(SEND A)\n%", "%\nO1\n%", "(SEND ../A)", "(SEND .A)", "(SEND )", "(SEND A/B)", "(SEND A)\n(SEND B)", ""})
    EXPECT_FALSE(requested_program(text)) << text;
  EXPECT_EQ(name_of_program("%\nO1234(FLANGE)\nG0X1\n"), "O1234");
  EXPECT_EQ(name_of_program("%\n:12\n"), "O12");
  EXPECT_EQ(name_of_program("G0X1\nO5\n"), "program");
}

}  // namespace kadr::drive::dnc_test
