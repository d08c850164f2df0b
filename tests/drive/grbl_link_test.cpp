// The conversation with a Grbl controller, against the double: a job, a stop, a hold, an error, and random faults.

#include "drive/grbl/grbl_link.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "drive/link_rig.h"

namespace kadr::drive::grbl_link_test {

using test::GrblDouble;
using test::Injected;
using test::LinkRig;
using test::random_job;

constexpr double line_bytes = 11520;  // that 115,200 bit/s carry in a second

std::vector<std::string> texts_of(const std::vector<JobLine>& job) {
  std::vector<std::string> texts;
  for (const JobLine& line : job)
    if (line.kind != LineKind::stop) texts.push_back(line.text);
  return texts;
}

/// Returns the lines of the job among the lines that were sent.
std::vector<std::string> job_lines(const LinkRig& rig) {
  std::vector<std::string> lines;
  for (const std::string& line : rig.sent_lines)
    if (line.front() != '$') lines.push_back(line);
  return lines;
}

bool is_beginning_of(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return a.size() <= b.size() && std::equal(a.begin(), a.end(), b.begin());
}

TEST(GrblLink, ReadsTheSettingsAndRunsAJob) {
  LinkRig rig;
  ASSERT_TRUE(rig.connect());
  EXPECT_EQ(rig.link.settings().value(130, 0), 300);
  EXPECT_EQ(rig.link.settings().planner_blocks, 15);
  std::mt19937 random(1);
  const auto job = random_job(random, 200);
  const LinkEvent* const end = rig.work(job, 200);
  ASSERT_NE(end, nullptr);
  EXPECT_EQ(end->kind, LinkEventKind::finished) << name_of(end->fault) << ' ' << end->text << ' ' << end->value;
  EXPECT_EQ(rig.machine.executed, texts_of(job));
  EXPECT_EQ(rig.machine.dropped, 0U);
  EXPECT_EQ(rig.link.view().executed, job.size());
  EXPECT_EQ(rig.link.view().phase, LinkPhase::ready);
}

/// Streams 4,000 lines to a controller that needs no time for a line. Returns the share of the line's time that they needed.
double share_of_the_line(double line_rate) {
  LinkOptions options;
  options.line_rate = line_rate;
  LinkRig rig(options);
  rig.machine.line_seconds = 0;
  EXPECT_TRUE(rig.connect());
  std::vector<JobLine> job;
  for (std::uint32_t n = 1; n <= 4000; ++n) job.push_back({fmt::format("S{}", 10000 + n), n, LineKind::plain, 0, {}});
  const double begin = rig.machine.now;
  const LinkEvent* const end = rig.work(job, 60);
  EXPECT_TRUE(end != nullptr && end->kind == LinkEventKind::finished);
  return 4000 * 7 / line_bytes / (rig.machine.now - begin);
}

TEST(GrblLink, FillsTheBufferAndKeepsTheLineBusy) {
  for (const double rate : {0.0, line_bytes}) {
    const double share = share_of_the_line(rate);
    EXPECT_LT(share, 1.0);
    EXPECT_GT(share, 0.98) << rate;  // what is left is the answer to the last line and one report
  }
}

TEST(GrblLink, AnErrorEndsTheJobAndNoByteFollows) {
  LinkRig rig;
  ASSERT_TRUE(rig.connect());
  std::vector<JobLine> job;
  job.push_back({"G91G1F600", 1, LineKind::plain, 0, {}});
  for (std::uint32_t n = 2; n < 9; ++n) job.push_back({n == 3 ? "Q1" : "X2", n, LineKind::plain, 0.2, {}});
  const LinkEvent* const end = rig.work(job, 20);
  ASSERT_NE(end, nullptr);
  EXPECT_EQ(end->fault, LinkFault::line_refused);
  EXPECT_EQ(end->number, 20);
  EXPECT_EQ(end->line, 3U);
  const std::size_t sent = rig.sent_lines.size();
  rig.run(3);
  EXPECT_EQ(rig.sent_lines.size(), sent);
  EXPECT_EQ(rig.machine.state_text(), "Hold:0");
  const double stood = rig.machine.moved_at;
  rig.link.stop();
  ASSERT_NE(rig.until(LinkEventKind::stopped, 5), nullptr);
  rig.run(5);
  EXPECT_EQ(rig.machine.moved_at, stood) << "the lines in the buffer were not executed after the reset";
  EXPECT_EQ(rig.machine.state_text(), "Idle");
}

TEST(GrblLink, HoldActsWithin20MillisecondsAndStopEndsTheMotion) {
  LinkRig rig;
  ASSERT_TRUE(rig.connect());
  std::vector<JobLine> job = {{"G1F600X50", 1, LineKind::plain, 5, {{0, 0, 0}, {50, 0, 0}}}};
  ASSERT_TRUE(rig.link.begin_job());
  rig.link.offer(job[0]);
  rig.link.end_of_job();
  rig.run(1);
  ASSERT_EQ(rig.machine.state_text(), "Run");
  rig.link.hold();
  const double pressed = rig.machine.now;
  while (rig.machine.state_text() == "Run") rig.tick();
  EXPECT_LE(rig.machine.now - pressed, 0.020);
  ASSERT_NE(rig.until(LinkEventKind::held, 1), nullptr);
  const test::Point held_at = rig.machine.position;
  rig.run(2);
  EXPECT_EQ(rig.machine.position, held_at);
  rig.link.resume();
  rig.run(1);
  EXPECT_EQ(rig.machine.state_text(), "Run");
  rig.link.stop();
  ASSERT_NE(rig.until(LinkEventKind::stopped, 3), nullptr);
  EXPECT_EQ(rig.machine.state_text(), "Idle") << "a reset at standstill keeps the position";
  EXPECT_EQ(rig.link.view().phase, LinkPhase::ready);
}

/// The operator presses hold while the line is full of short lines. What lies in the driver cannot be overtaken.
TEST(GrblLink, HoldOvertakesTheLinesThatAreSent) {
  LinkOptions options;
  options.line_rate = line_bytes;
  double worst = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    LinkRig rig(options);
    rig.machine.line_seconds = 0;
    rig.machine.receive_size = 1024;  // as grblHAL's: 89 ms of the line
    ASSERT_TRUE(rig.connect());
    std::vector<JobLine> job = {{"G91G1F3000", 1, LineKind::plain, 0, {}}};
    for (std::uint32_t n = 2; n < 4000; ++n) {
      const double from = (n - 2) * 0.5;
      job.push_back({fmt::format("N{}X0.5Y0.000Z0.000F3000", n), n, LineKind::plain, 0.01, {{from, 0, 0}, {from + 0.5, 0, 0}}});
    }
    std::mt19937 random(seed);
    const double press = rig.machine.now + 0.02 + static_cast<double>(random() % 100) / 1000;
    double pressed = -1, held = -1;
    (void)rig.work(job, press + 0.5 - rig.machine.now, [&] {
      if (pressed < 0 && rig.machine.now >= press) {
        rig.link.hold();
        pressed = rig.machine.now;
      }
      if (pressed >= 0 && held < 0 && rig.machine.state_text() != "Run") held = rig.machine.now;
    });
    ASSERT_GE(held, pressed);
    worst = std::max(worst, held - pressed);
  }
  EXPECT_LE(worst, 0.016);  // kadr drive adds at most 4 ms before it sends
}

TEST(GrblLink, NoticesAHoldAndAStartThatSomebodyElseCommands) {
  LinkRig rig;
  ASSERT_TRUE(rig.connect());
  ASSERT_TRUE(rig.link.begin_job());
  rig.link.offer({"G1F600X50", 1, LineKind::plain, 5, {{0, 0, 0}, {50, 0, 0}}});
  rig.link.end_of_job();
  rig.run(1);
  rig.machine.open_door();
  ASSERT_NE(rig.until(LinkEventKind::held, 1), nullptr);
  EXPECT_EQ(rig.link.view().phase, LinkPhase::held);
  rig.run(0.2);
  rig.machine.receive('~');
  ASSERT_NE(rig.until(LinkEventKind::resumed, 2), nullptr);
  ASSERT_NE(rig.until(LinkEventKind::finished, 10), nullptr);
}

TEST(GrblLink, ACommandIsAnswered) {
  LinkRig rig;
  rig.machine.settings[22] = 1;
  ASSERT_TRUE(rig.connect());
  ASSERT_TRUE(rig.link.command("$H", 60));
  const LinkEvent* const homed = rig.until(LinkEventKind::answered, 10);
  ASSERT_NE(homed, nullptr);
  EXPECT_EQ(homed->number, 0);
  ASSERT_TRUE(rig.link.command("$J=G91X1F100000Q", 5));
  const LinkEvent* const refused = rig.until(LinkEventKind::answered, 5);
  ASSERT_NE(refused, nullptr);
  EXPECT_NE(refused->number, 0);
}

TEST(GrblLink, AProbeMotionReportsWhereItTouched) {
  LinkRig rig;
  ASSERT_TRUE(rig.connect());
  ASSERT_TRUE(rig.link.begin_job());
  rig.link.offer({"G38.2F60Z-1", 1, LineKind::alone, 1, {{0, 0, 0}, {0, 0, -1}}});
  rig.link.end_of_job();
  const LinkEvent* const probed = rig.until(LinkEventKind::probed, 10);
  ASSERT_NE(probed, nullptr);
  ASSERT_TRUE(probed->point);
  EXPECT_EQ((*probed->point)[2], -1);
}

TEST(GrblLink, TheExecutedLineIsRightAndNeverEarly) {
  LinkRig rig;
  ASSERT_TRUE(rig.connect());
  std::mt19937 random(7);
  std::vector<JobLine> job = {{"G21G90G1F3000", 1, LineKind::plain, 0, {}}};
  for (std::uint32_t n = 2; n < 300; ++n) {  // a wavy line that never crosses itself
    const GrblPoint from = {(n - 2) * 0.4, std::round(std::sin((n - 2) * 0.2) * 3000) / 1000, 0};
    const GrblPoint to = {(n - 1) * 0.4, std::round(std::sin((n - 1) * 0.2) * 3000) / 1000, 0};
    job.push_back({fmt::format("X{:.3f}Y{:.3f}", to[0], to[1]), n, LineKind::plain, 0.02, {from, to}});
  }
  std::size_t compared = 0;
  double last = -1;
  const LinkEvent* const end = rig.work(job, 100, [&] {
    const LinkView& view = rig.link.view();
    if (!view.line || !view.machine || view.reported_at == last || view.state != GrblState::run) return;
    last = view.reported_at;
    const double x = (*view.machine)[0];
    const auto wanted = static_cast<std::uint32_t>(std::ceil((x - 1e-9) / 0.4)) + 1;
    EXPECT_LE(*view.line, std::max(wanted, 2U)) << x;
    EXPECT_GE(*view.line + 1, wanted) << x;
    ++compared;
  });
  ASSERT_NE(end, nullptr);
  EXPECT_EQ(end->kind, LinkEventKind::finished) << name_of(end->fault);
  EXPECT_GT(compared, 10U);
}

/// Injects one fault of a kind at a random time.
struct Injection {
  Injected kind;
  double at;
  int byte = -1;  // counts down the bytes until the fault
  bool eats = false;
  bool acted = false;
  double until = -1;  // when the fault ends, s

  bool is_from() const {
    return kind == Injected::lost_from || kind == Injected::changed_from || kind == Injected::doubled_from || kind == Injected::lost_answer;
  }
  bool is_to() const { return kind == Injected::lost_to || kind == Injected::changed_to; }
  /// The line to the machine carries nothing: a hold does not arrive.
  bool cuts() const { return kind == Injected::cut; }

  void tick(LinkRig& rig, std::mt19937& random) {
    if (!acted && rig.machine.now >= at) {
      acted = true;
      act(rig, random);
    }
    if (until < 0 || rig.machine.now < until) return;
    until = -1;
    if (kind == Injected::mute_a_while) rig.is_deaf = false;
    if (kind == Injected::hold_button) rig.machine.receive('~');
    if (kind == Injected::operator_hold) rig.link.resume();
  }
  void act(LinkRig& rig, std::mt19937& random) {
    until = rig.machine.now + 0.05 + static_cast<double>(random() % 3000) / 1000;
    switch (kind) {
      case Injected::nothing: break;
      case Injected::cut: rig.is_cut = true; break;
      case Injected::deaf: rig.is_deaf = true; break;
      case Injected::mute_a_while: rig.is_deaf = true; break;
      case Injected::reset: rig.machine.power_cycle(); break;
      case Injected::limit: rig.machine.hard_limit(); break;
      case Injected::door: rig.machine.open_door(); break;
      case Injected::no_probe: rig.machine.probe_touches = false; break;
      case Injected::hold_button: rig.machine.receive('!'); break;
      case Injected::operator_hold: rig.link.hold(); break;
      case Injected::operator_stop: rig.link.stop(); break;
      case Injected::garbage: {
        std::string noise;
        for (int i = 0; i < 40; ++i) noise += static_cast<char>(1 + random() % 255);
        rig.from_machine.send(noise + "\n", rig.machine.now);
        break;
      }
      default: byte = static_cast<int>(random() % 60);
    }
  }
  char from(char given, LinkRig& rig, std::mt19937& random) {
    if (eats) eats = given != '\n';
    if (eats) return 0;
    if (byte < 0) return given;
    if (kind == Injected::lost_answer) {  // from the next line on, until its end
      if (byte > 0) --byte;
      if (byte == 0 && given == '\n') byte = -1, eats = true;
      return given;
    }
    if (--byte >= 0) return given;
    if (kind == Injected::lost_from) return 0;
    if (kind == Injected::doubled_from) rig.link.receive(std::string(1, given), rig.machine.now);
    if (kind == Injected::changed_from) return static_cast<char>(given ^ static_cast<char>(1 + random() % 127));
    return given;
  }
  char to(char given, std::mt19937& random) {
    if (byte < 0 || --byte >= 0) return given;
    if (kind == Injected::lost_to) return 0;
    return static_cast<char>(given ^ static_cast<char>(1 + random() % 127));
  }
};

/// Checks that the shown state is one that the controller reported lately.
void check_state(const LinkRig& rig, unsigned seed) {
  if (rig.link.view().state == GrblState::unknown) return;  // a stop was commanded, and no report has come since
  const auto& states = rig.machine.states;
  const std::string_view shown = name_of(rig.link.view().state);
  const std::size_t from = states.size() > 3 ? states.size() - 3 : 0;
  const bool was_so =
      rig.machine.state_text().starts_with(shown) ||
      std::any_of(states.begin() + std::ptrdiff_t(from), states.end(), [&](const std::string& state) { return state.starts_with(shown); });
  ASSERT_TRUE(was_so) << seed << ": shows " << shown << ", the controller was " << states.back();
}

/// One or two faults of random kinds, during a random job.
void try_one(unsigned seed) {
  std::mt19937 random(seed);
  LinkRig rig;
  ASSERT_TRUE(rig.connect()) << seed;
  const auto job = random_job(random, 20 + random() % 60);
  const auto texts = texts_of(job);
  std::vector<Injection> faults;
  const std::size_t count = random() % 3 == 0 ? 2 : 1;
  while (faults.size() < count)
    faults.push_back({static_cast<Injected>(random() % static_cast<unsigned>(Injected::count)),
                      rig.machine.now + 0.05 + static_cast<double>(random() % 3000) / 1000});
  const auto any = [&](auto is) { return std::any_of(faults.begin(), faults.end(), is); };
  const bool to_it = any([](const Injection& f) { return f.is_to(); });
  if (any([](const Injection& f) { return f.is_from(); }))
    rig.change_from = [&](char byte) {
      for (Injection& fault : faults)
        if (fault.is_from() && byte != 0) byte = fault.from(byte, rig, random);
      return byte;
    };
  if (to_it)
    rig.change_to = [&](char byte) {
      for (Injection& fault : faults)
        if (fault.is_to() && byte != 0) byte = fault.to(byte, random);
      return byte;
    };
  const std::string what = fmt::format("seed {}, faults {} {}", seed, static_cast<int>(faults.front().kind),
                                       faults.size() > 1 ? static_cast<int>(faults.back().kind) : 0);
  double last_report = 0;
  const LinkEvent* const end = rig.work(job, 120, [&] {
    for (Injection& fault : faults) fault.tick(rig, random);
    if (rig.link.view().phase == LinkPhase::held && random() % 200 == 0) rig.link.resume();
    if (rig.link.view().reported_at == last_report || rig.machine.states.empty()) return;
    last_report = rig.link.view().reported_at;
    check_state(rig, seed);
  });
  const auto sent = job_lines(rig);
  ASSERT_TRUE(is_beginning_of(sent, texts)) << what << ": a line was sent twice, or left out";
  if (end == nullptr) {
    FAIL() << what << ": the job neither ended nor failed; phase " << name_of(rig.link.view().phase) << ", machine "
           << rig.machine.state_text();
  }
  if (end->kind == LinkEventKind::finished) {
    ASSERT_EQ(sent, texts) << what;
    if (!to_it) {
      ASSERT_EQ(rig.machine.executed, texts) << what;
    }
    const bool just_broken = any([&](const Injection& f) { return f.acted && rig.machine.now - f.at < 0.5; });  // after the last report
    ASSERT_TRUE(rig.machine.is_idle() || just_broken) << what << ": finished, but the controller is " << rig.machine.state_text();
  }
  if (!any([](const Injection& f) { return f.kind != Injected::nothing; })) {
    ASSERT_EQ(end->kind, LinkEventKind::finished) << what << ' ' << end->line << ' ' << name_of(end->fault) << ' ' << end->text;
  }
  // After the end nothing moves any more, as soon as the hold has arrived and the axes have stopped. A cut line carries no hold, and a
  // byte on the way to the controller may be the hold: the link repeats it.
  if (any([](const Injection& f) { return f.cuts(); })) return;
  rig.run(1.5);
  const double stood = rig.machine.moved_at;
  rig.run(2);
  ASSERT_EQ(rig.machine.moved_at, stood) << what << ": the axes move after the end of the job";
  rig.is_deaf = false;
  rig.link.stop();
  rig.run(3);
  ASSERT_EQ(rig.machine.moved_at, stood) << what << ": the axes move after stop()";
  ASSERT_EQ(job_lines(rig), sent) << what << ": a line was sent after the end of the job";
}

/// KADR_DRIVE_JOBS sets how many random jobs with faults are tried, KADR_DRIVE_SEED the first of their seeds.
TEST(GrblLink, KeepsItsPromisesUnderRandomFaults) {
  const char* const jobs = std::getenv("KADR_DRIVE_JOBS");
  const char* const first = std::getenv("KADR_DRIVE_SEED");
  const unsigned begin = first != nullptr ? static_cast<unsigned>(std::atoi(first)) : 1;
  const unsigned count = jobs != nullptr ? static_cast<unsigned>(std::atoi(jobs)) : 500;
  for (unsigned seed = begin; seed < begin + count && !testing::Test::HasFatalFailure(); ++seed) try_one(seed);
}

}  // namespace kadr::drive::grbl_link_test
