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

TEST(GrblLink, FillsTheBufferAndKeepsTheLineBusy) {
  LinkRig rig;
  rig.machine.line_seconds = 0;
  ASSERT_TRUE(rig.connect());
  std::vector<JobLine> job;
  for (std::uint32_t n = 1; n <= 4000; ++n) job.push_back({fmt::format("S{}", 10000 + n), n, LineKind::plain, 0, {}});
  const double begin = rig.machine.now;
  const LinkEvent* const end = rig.work(job, 60);
  ASSERT_NE(end, nullptr);
  EXPECT_EQ(end->kind, LinkEventKind::finished);
  const double seconds = rig.machine.now - begin, at_baud_rate = 4000 * 7 / 11520.0;
  EXPECT_LT(at_baud_rate / seconds, 1.0);
  EXPECT_GT(at_baud_rate / seconds, 0.85) << seconds << " s";  // with the wait for the last report
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

  void act(LinkRig& rig, std::mt19937& random) {
    switch (kind) {
      case Injected::cut: rig.is_cut = true; break;
      case Injected::deaf: rig.is_deaf = true; break;
      case Injected::reset: rig.machine.power_cycle(); break;
      case Injected::limit: rig.machine.hard_limit(); break;
      case Injected::door: rig.machine.open_door(); break;
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
    if (byte < 0 || --byte >= 0) return given;
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

void try_one(unsigned seed) {
  std::mt19937 random(seed);
  LinkRig rig;
  ASSERT_TRUE(rig.connect()) << seed;
  const auto job = random_job(random, 20 + random() % 60);
  const auto texts = texts_of(job);
  Injection injection{static_cast<Injected>(random() % static_cast<unsigned>(Injected::count)),
                      rig.machine.now + 0.05 + static_cast<double>(random() % 3000) / 1000};
  const bool to_it = injection.kind == Injected::lost_to || injection.kind == Injected::changed_to;
  const bool from_it =
      injection.kind == Injected::lost_from || injection.kind == Injected::changed_from || injection.kind == Injected::doubled_from;
  if (from_it) rig.change_from = [&](char byte) { return injection.from(byte, rig, random); };
  if (to_it) rig.change_to = [&](char byte) { return injection.to(byte, random); };
  bool acted = injection.kind == Injected::nothing;
  double last_report = 0;
  const LinkEvent* const end = rig.work(job, 120, [&] {
    if (!acted && rig.machine.now >= injection.at) {
      acted = true;
      injection.act(rig, random);
    }
    if (rig.link.view().phase == LinkPhase::held && random() % 200 == 0) rig.link.resume();
    const LinkView& view = rig.link.view();
    if (view.reported_at != last_report && !rig.machine.states.empty()) {
      last_report = view.reported_at;
      const auto& states = rig.machine.states;
      const std::size_t from = states.size() > 3 ? states.size() - 3 : 0;
      const bool was_so = rig.machine.state_text().starts_with(name_of(view.state)) ||
                          std::any_of(states.begin() + std::ptrdiff_t(from), states.end(),
                                      [&](const std::string& state) { return state.starts_with(name_of(view.state)); });
      ASSERT_TRUE(was_so) << seed << ": shows " << name_of(view.state) << ", the controller was " << states.back();
    }
  });
  const auto sent = job_lines(rig);
  ASSERT_TRUE(is_beginning_of(sent, texts)) << seed << ": a line was sent twice, or left out";
  if (end == nullptr) {
    // Only a lost answer to a question may leave the job waiting, and it must not: every job ends.
    FAIL() << seed << ": the job neither ended nor failed; phase " << name_of(rig.link.view().phase) << ", machine "
           << rig.machine.state_text() << ", fault " << static_cast<int>(injection.kind);
  }
  if (end->kind == LinkEventKind::finished) {
    ASSERT_EQ(sent, texts) << seed;
    if (!to_it) {
      ASSERT_EQ(rig.machine.executed, texts) << seed;
    }
    const bool just_broken = acted && rig.machine.now - injection.at < 0.5;  // after the report that ended the job
    ASSERT_TRUE(rig.machine.is_idle() || just_broken)
        << seed << ": finished, but the controller is " << rig.machine.state_text() << ", fault " << static_cast<int>(injection.kind);
  }
  if (injection.kind == Injected::nothing) {
    ASSERT_EQ(end->kind, LinkEventKind::finished) << seed << ' ' << end->line << ' ' << name_of(end->fault) << ' ' << end->text;
  }
  // After the end nothing moves any more, as soon as the hold has arrived and the axes have stopped. A cut line carries no hold.
  if (rig.is_cut) return;
  rig.run(1);
  const double stood = rig.machine.moved_at;
  rig.run(2);
  ASSERT_EQ(rig.machine.moved_at, stood) << seed << ": the axes move after the end of the job";
  rig.is_deaf = false;
  rig.link.stop();
  rig.run(3);
  ASSERT_EQ(rig.machine.moved_at, stood) << seed << ": the axes move after stop()";
  ASSERT_EQ(job_lines(rig), sent) << seed << ": a line was sent after the end of the job";
}

/// KADR_DRIVE_JOBS sets how many random jobs with faults are tried, KADR_DRIVE_SEED the first of their seeds.
TEST(GrblLink, KeepsItsPromisesUnderRandomFaults) {
  const char* const jobs = std::getenv("KADR_DRIVE_JOBS");
  const char* const first = std::getenv("KADR_DRIVE_SEED");
  const unsigned begin = first != nullptr ? static_cast<unsigned>(std::atoi(first)) : 1;
  const unsigned count = jobs != nullptr ? static_cast<unsigned>(std::atoi(jobs)) : 300;
  for (unsigned seed = begin; seed < begin + count && !testing::Test::HasFatalFailure(); ++seed) try_one(seed);
}

}  // namespace kadr::drive::grbl_link_test
