// Session::snapshot() and restore(): at any moment, a fresh session that continues from a snapshot gives the output of an uninterrupted
// run: the same trace, alarms and samples, byte for byte.

#include <deque>
#include <random>

#include "session/a_session.h"

namespace kadr::snapshot_test {
namespace {

using test::Folder, test::Work, test::Written;

constexpr std::size_t max_calls = 3000;  // calls of go_on()
constexpr std::size_t max_alarms = 30;

/// What is compared, and how the session runs.
struct Look {
  bool past_alarms = false;  // continues after alarms, as `kadr check` does
  bool planned = false;      // with planned samples
  bool limits = false;       // checks the machine's limits: each block is passed on separately
};

/// A session and all its output.
class Run {
 public:
  Run(const Work& work, Look look) {
    Setup setup = work.setup;
    if (look.limits && setup.machine.empty()) setup.machine["*"].limits = {-2000, 2000};
    auto opened = Session::open(
        {test::shared_control(work.id), test::generic_machine(), setup, {work.main_file, text_source(work.program), {}}, {20'000, 5}});
    if (!opened) return;
    session_ = std::move(*opened);
    if (session_->channels().size() == 1) session_->control().set_waiting(Control::Waiting::pass);
    (void)session_->look_ahead();
    for (std::size_t i = 0; i < session_->channels().size(); ++i) look_at(i, look);
    session_->together().in_order = [this](std::size_t i, const Step& step) { write(i, step); };
    session_->together().stop_together = !look.past_alarms;
    if (look.planned) {
      SampleOptions options;
      options.rate = 50;
      options.max_time = 60;
      session_->plan(session_->own()).write_samples(samples_.file(), options);
    }
  }

  bool opened() const { return session_ != nullptr; }
  Session& session() { return *session_; }
  /// Returns false if the run is over.
  bool go_on() { return calls_++ < max_calls && session_->go_on() == Session::State::running; }
  void finish(std::size_t calls) {
    calls_ = calls;
    while (go_on()) {
    }
    last_lines();
    if (Planned* const planned = session_->planned(session_->own())) (void)planned->finish();
  }
  /// All output so far.
  struct Given {
    std::string trace, reports, samples;
  };
  Given given() const { return {written_.text(), reports_, samples_.text()}; }
  /// The observers of the session continue too.
  void go_on_from(const Run& other) {
    alarms_ = other.alarms_;
    for (std::size_t i = 0; i < traces_.size(); ++i) traces_[i]->continue_after_probe(other.traces_[i]->after_probe());
  }

 private:
  void look_at(std::size_t i, Look look) {
    const Control& control = *session_->channels()[i].control;
    traces_.push_back(std::make_unique<TraceWriter>(written_.file(), control.axes(), control.rotary()));
    if (session_->channels().size() > 1) traces_.back()->set_channel(session_->channels()[i].number);
    Outlets& outlets = session_->outlets(i);
    const bool alone = session_->channels().size() == 1;
    outlets.clock = &clocks_.emplace_back(AxisRoles::of(control.axes(), control.rotary()),
                                          rates_of(session_->machine(), session_->channels()[i].setup, control.axes()));
    outlets.works_long = true;
    outlets.step = [this, alone, i](const Step& step) {
      if (!alone) session_->show(i, step);
    };
    outlets.timed = [this, alone, i](const Step& step, double) {
      if (alone) write(i, step);
    };
    outlets.warning = [this](const AlarmReport& report) { note_report(report); };
    outlets.alarm = [this, look](const AlarmReport& report) {
      note_report(report);
      return look.past_alarms && ++alarms_ < max_alarms;
    };
  }
  void write(std::size_t i, const Step& step) {
    traces_[i]->write(step);
    traces_[i]->flush();
  }
  void note_report(const AlarmReport& report) {
    reports_ += std::string(name_of(report.alarm.id)) + " " + std::to_string(report.origin.line) + " " +
                std::to_string(report.alarm.where.begin) + " " + report.file + " " + report.line_text + "\n";
  }
  void last_lines() {
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      FinalState ending = session_->channels()[i].control->ending();
      if (const auto& stood = session_->stopped(i).machine_stood) ending.position = stood->work, ending.machine_position = stood->machine;
      traces_[i]->finish(ending);
      reports_ += std::to_string(session_->channels()[i].control->blocks()) + "\n";
    }
  }

  Written written_, samples_;
  std::string reports_;
  std::deque<TimeEstimate> clocks_;
  std::vector<std::unique_ptr<TraceWriter>> traces_;
  std::unique_ptr<Session> session_;
  std::size_t calls_ = 0, alarms_ = 0;
};

/// Returns the first difference of two texts as a message.
std::string difference(const std::string& name, const std::string& expected, const std::string& found) {
  if (expected == found) return {};
  std::size_t i = 0;
  while (i < std::min(expected.size(), found.size()) && expected[i] == found[i]) ++i;
  const std::size_t from = i < 200 ? 0 : i - 200;
  return name + " never stopped: " + expected.substr(from, 500) + "\n  restored:      " + found.substr(from, 500) + "\n";
}
std::string difference(const Run::Given& expected, const Run::Given& found) {
  return difference("trace", expected.trace, found.trace) + difference("told", expected.reports, found.reports) +
         difference("samples", expected.samples, found.samples);
}

struct Tally {
  std::size_t programs = 0, restored = 0, planned = 0, shown = 0;
};

void check(const Work& work, Look look, std::mt19937& choose, Tally& tally) {
  Run whole(work, look);
  if (!whole.opened()) return;
  std::size_t calls = 0;
  while (whole.go_on()) ++calls;
  whole.finish(calls + 1);
  ++tally.programs;
  const std::size_t at = std::uniform_int_distribution<std::size_t>(0, calls)(choose);
  Run stopped(work, look);
  std::size_t done = 0;
  while (done < at && stopped.go_on()) ++done;
  const auto snapshot = stopped.session().snapshot();
  if (!snapshot) return;
  const Run::Given before = stopped.given();
  Run fresh(work, look);
  ASSERT_TRUE(fresh.session().restore(*snapshot)) << work.where;
  fresh.go_on_from(stopped);
  stopped.finish(done);
  fresh.finish(done);
  const Run::Given expected = whole.given(), undisturbed = stopped.given(), rest = fresh.given();
  const std::string by_itself = difference(expected, undisturbed);
  const std::string same = difference(expected, {before.trace + rest.trace, before.reports + rest.reports, before.samples + rest.samples});
  if (!(by_itself + same).empty() && ++tally.shown <= 10)
    ADD_FAILURE() << work.where << (look.past_alarms ? ", past alarms" : "") << (look.planned ? ", planned" : "")
                  << (look.limits ? ", with limits" : "") << ", stopped after " << at << " of " << calls << " calls\n"
                  << (by_itself.empty() ? "" : "(by the snapshot itself) " + by_itself) << same << work.program.substr(0, 1500);
  ++tally.restored;
  tally.planned += look.planned && !expected.samples.empty();
}

TEST(session_snapshot, golden_and_own_cases_go_on_the_same) {
  std::mt19937 choose(7);
  Tally tally;
  test::for_each_program([&](const Work& work) {
    const std::size_t n = tally.programs;
    check(work, {n % 2 == 0, n % 10 == 3, n % 4 == 2}, choose, tally);
  });
  EXPECT_GT(tally.programs, 1800U);
  EXPECT_GT(tally.restored, tally.programs * 9 / 10);
  EXPECT_GT(tally.planned, 100U);
}

TEST(session_snapshot, examples_go_on_the_same) {
  std::mt19937 choose(8);
  Tally tally;
  test::for_each_example([&](const Work& work) {
    for (const bool planned : {false, true}) check(work, {false, planned, false}, choose, tally);
  });
  EXPECT_GE(tally.restored, 50U);
}

class SessionSnapshotOfRandomPrograms : public testing::TestWithParam<const char*> {};

TEST_P(SessionSnapshotOfRandomPrograms, goes_on_the_same) {
  Folder folder;
  folder.put({{"O9100.nct", "G91 G0 X#1 Y#2\n#101=#101+1\nG90\nM99\n"}, {"O9101.nct", "IF[#1EQ#0]THEN#1=0\n#1=#1+1\nG1 Z#1 F100\nM99\n"}});
  std::mt19937 choose(9);
  Tally tally;
  const auto setup = parse_setup(R"({"start": {"Z": 100}, "offsets": {"1": {"length": 10, "radius": 2}}, "skip": [1]})").value();
  for (int i = 0; i < 400; ++i)
    check({GetParam(), "random " + std::to_string(i), test::random_program(GetParam(), choose), "main.nct", setup},
          {i % 3 != 0, i % 20 == 3, i % 4 == 2}, choose, tally);
  EXPECT_GT(tally.restored, 300U);
}

INSTANTIATE_TEST_SUITE_P(session_snapshot, SessionSnapshotOfRandomPrograms, testing::Values("nct", "mach3", "gost", "correctors", "s2c42"),
                         [](const auto& control) { return std::string(control.param); });

/// Chapter 25 on each type of machine, with narrow and wide axis travel, and with FOS and BSE in both states.
TEST(session_snapshot, random_five_axis_programs_go_on_the_same) {
  const std::vector<std::string> machines = {
      R"("kinematics": {"type": "table-table", "axes": "AC", "reversed": "AC", "T1": [300, -200, -450], "T2": [0, 4, -60]})",
      R"("kinematics": {"type": "head-head", "axes": "CA", "E": [5, -3, 200], "D": [20, 8, 50]})",
      R"("kinematics": {"type": "head-table", "axes": "AC", "reversed": "C", "T1": [400, -250, -500], "E": [2, -1, 180]})"};
  const std::string rest = R"("axes": ["X", "Y", "Z", "A", "C"], "start": {"Z": 100}, "offsets": {"1": {"length": 60, "radius": 4}},
      "work_offsets": {"G54": {"X": 30, "C": 20}, "G55": {"Z": -25, "G17": 30}})";
  Folder folder;
  std::mt19937 choose(10);
  Tally tally;
  for (std::size_t i = 0; i < 400; ++i) {
    const std::string bits =
        std::string(R"("parameters": {"N3212#4": )") + (i % 4 < 2 ? "0" : "1") + R"(, "N3212#7": )" + (i % 2 == 0 ? "0}" : "1}");
    const auto setup = parse_setup("{" + machines[i % 3] + ", " + bits + ", " + rest + "}");
    ASSERT_TRUE(setup) << i;
    check({"nct", "random five-axis " + std::to_string(i), test::random_program("nct", choose, test::five_axis_blocks), "main.nct", *setup},
          {i % 5 != 0, i % 20 == 3, i % 7 == 2}, choose, tally);
  }
  EXPECT_GT(tally.restored, 300U);
}

}  // namespace
}  // namespace kadr::snapshot_test
