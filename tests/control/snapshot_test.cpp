// Control::snapshot() and restore(): a run is stopped between two blocks and continues in a fresh control. It gives what an
// uninterrupted run gives: the same trace, alarms, warnings and tables, byte for byte.

#include "control/state/snapshot.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "control/run_program.h"
#include "control/snapshot_content.h"
#include "machine/plc.h"
#include "motion/time/steps.h"
#include "out/trace/trace.h"
#include "session/plc_commands.h"
#include "some_programs.h"

namespace kadr::snapshot_test {
namespace {

using test::Folder, test::Work;

constexpr std::size_t max_steps = 4000;  // calls of run()
constexpr std::size_t max_alarms = 50;

/// A control, the logic of its machine, and all their output.
class Runner {
 public:
  Runner(const Work& work, bool each_block)
      : control_(test::control(work.id), work.setup, Program{work.main_file, text_source(work.program), {}}, RunLimits{20'000, 5}),
        plc_(work.setup.events),
        start_(control_.ending()) {
    listen();
    if (each_block || !plc_.idle()) control_.return_each_block();
    control_.set_waiting(Control::Waiting::pass);
  }
  /// Continues from a snapshot of `other`, including the output that `other` has produced so far.
  Runner(const Work& work, bool each_block, const Runner& other, const Snapshot& from) : Runner(work, each_block) {
    plc_ = other.plc_;
    actions_ = other.actions_;
    reports_ = other.reports_;
    alarms_ = other.alarms_;
    over_ = other.over_;
    restored_ = control_.restore(from).has_value();
  }
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Calls run() once. Returns false if the run is over.
  bool step() {
    if (over_) return false;
    const Control::State state = control_.run(batch_);
    for (const Action& action : batch_) {
      actions_.push_back(action);
      if (!plc_.idle()) apply(plc_.action(action), control_, all_);
    }
    if (state == Control::State::needs_probe) {
      const auto* const motion = std::get_if<Motion>(&actions_.back().what);
      control_.answer({true, motion != nullptr ? motion->to : Axes{}});
    }
    if (state == Control::State::waiting) control_.release();
    if (control_.is_stopped()) {
      note_report("alarm", control_.report());
      if (++alarms_ > max_alarms) over_ = true;
      control_.go_on();
    }
    over_ = over_ || state == Control::State::ended;
    return !over_;
  }
  std::size_t finish(std::size_t steps = 0) {
    while (steps < max_steps && step()) ++steps;
    return steps;
  }
  std::optional<Snapshot> snapshot() const { return control_.snapshot(); }
  bool restored() const { return restored_; }

  /// Returns all output as text.
  std::string all() const {
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* const file = ::open_memstream(&text, &size);
    {
      const AxisRoles roles = AxisRoles::of(control_.axes(), control_.rotary());
      Steps steps(roles, {start_.position, start_.machine_position});
      TraceWriter trace(file, control_.axes(), control_.rotary());
      for (const Action& action : actions_) steps.give(action, [&](const Step& step) { trace.write(step); });
      const auto state = control_.run_state();
      const std::string json = state ? state_json(*state) : std::string();
      trace.finish(control_.ending(), {.state = json});
      trace.flush();
    }
    std::fclose(file);
    std::string all(text, size);
    std::free(text);  // NOLINT: of open_memstream
    for (const std::string& line : test::exactly(actions_)) all += line + "\n";
    return all + reports_ + std::to_string(control_.blocks()) + " " + std::to_string(control_.use().all().size());
  }

 private:
  void listen() {
    control_.on_warning = [this](const AlarmReport& warning) { note_report("warning", warning); };
    if (!plc_.idle()) control_.on_block = [this](const Origin& origin, bool at_end) { apply(plc_.block(origin, at_end), control_, all_); };
  }
  void note_report(const char* kind, const AlarmReport& report) {
    reports_ += kind + std::string(" ") + std::string(name_of(report.alarm.id)) + " " + std::to_string(report.origin.line) + " " +
                std::to_string(report.alarm.where.begin) + " " + report.file + " after " + std::to_string(actions_.size()) + "\n";
  }

  Control control_;
  Plc plc_;
  FinalState start_;
  std::array<Control*, 1> all_ = {&control_};
  ActionBatch batch_;
  std::vector<Action> actions_;
  std::string reports_;
  std::size_t alarms_ = 0;
  bool over_ = false, restored_ = false;
};

struct Tally {
  std::size_t programs = 0, restored = 0, shown = 0;
};

/// Stops at random moments and continues from there, in the same control and in a fresh one.
void check(const Work& work, bool each_block, std::mt19937& choose, Tally& tally) {
  Runner whole(work, each_block);
  const std::size_t steps = whole.finish();
  const std::string expected = whole.all();
  ++tally.programs;
  for (int stop = 0; stop < 2; ++stop) {
    const std::size_t at = std::uniform_int_distribution<std::size_t>(0, steps)(choose);
    Runner stopped(work, each_block);
    std::size_t done = 0;
    while (done < at && stopped.step()) ++done;
    auto snapshot = stopped.snapshot();
    while (!snapshot && stopped.step()) ++done, snapshot = stopped.snapshot();
    if (!snapshot || done > steps) continue;  // the run ends in the middle of a block
    Runner fresh(work, each_block, stopped, *snapshot);
    ASSERT_TRUE(fresh.restored()) << work.where;
    stopped.finish(done);
    fresh.finish(done);
    const std::string undisturbed = test::difference(expected, stopped.all()), same = test::difference(expected, fresh.all());
    if (!(undisturbed + same).empty() && ++tally.shown <= 20)
      ADD_FAILURE() << work.where << (each_block ? ", each block" : "") << ", stopped after " << done << " of " << steps << " calls\n  "
                    << undisturbed << (undisturbed.empty() ? "" : " (by the snapshot itself)\n  ") << same << "\n"
                    << work.program.substr(0, 1500);
    ++tally.restored;
  }
}

TEST(snapshot, golden_and_own_cases_go_on_the_same) {
  std::mt19937 choose(7);
  Tally tally;
  test::for_each_program([&](const Work& work) { check(work, tally.programs % 2 == 0, choose, tally); });
  EXPECT_GT(tally.programs, 1800U);
  EXPECT_GT(tally.restored, 2 * tally.programs * 9 / 10);
}

TEST(snapshot, examples_go_on_the_same) {
  std::mt19937 choose(8);
  Tally tally;
  test::for_each_example([&](const Work& work) {
    for (const bool each_block : {false, true}) check(work, each_block, choose, tally);
  });
  EXPECT_GT(tally.restored, 50U);
}

class SnapshotOfRandomPrograms : public testing::TestWithParam<const char*> {};

TEST_P(SnapshotOfRandomPrograms, goes_on_the_same) {
  Folder folder;
  folder.put({{"O9100.nct", "G91 G0 X#1 Y#2\n#101=#101+1\nG90\nM99\n"}, {"O9101.nct", "IF[#1EQ#0]THEN#1=0\n#1=#1+1\nG1 Z#1 F100\nM99\n"}});
  std::mt19937 choose(9);
  Tally tally;
  const auto setup = parse_setup(R"({"start": {"Z": 100}, "offsets": {"1": {"length": 10, "radius": 2}}, "skip": [1]})").value();
  for (int i = 0; i < 400; ++i)
    check({GetParam(), "random " + std::to_string(i), test::random_program(GetParam(), choose), "main.nct", setup}, i % 2 == 0, choose,
          tally);
  EXPECT_GT(tally.restored, 300U);
}

INSTANTIATE_TEST_SUITE_P(snapshot, SnapshotOfRandomPrograms, testing::Values("nct", "mach3", "gost", "correctors", "s2c42"),
                         [](const auto& control) { return std::string(control.param); });

// ---- special cases

TEST(snapshot, of_the_middle_of_a_cycle) {
  const std::string program = "G81 X0 Y0 Z-5 R2 F100 L40\nG0 X7\nM30\n";
  Control control(test::control("mach3"), {}, Program{"p", text_source(program), {}}, RunLimits{});
  ActionBatch batch, rest, same;
  ASSERT_EQ(control.run(batch), Control::State::running);
  ASSERT_TRUE(control.in_block());  // holes are pending
  const auto now = control.snapshot();
  ASSERT_TRUE(now);
  (void)control.run(rest);
  Control fresh(test::control("mach3"), {}, Program{"p", text_source(program), {}}, RunLimits{});
  ASSERT_TRUE(fresh.restore(*now));
  EXPECT_TRUE(fresh.in_block());
  (void)fresh.run(same);
  EXPECT_EQ(test::exactly({rest.begin(), rest.end()}), test::exactly({same.begin(), same.end()}));
}

TEST(snapshot, there_is_none_while_a_probe_is_waited_for) {
  Control control(test::control("mach3"), {}, Program{"p", text_source("G31 X10 F100\nM30\n"), {}}, RunLimits{});
  ActionBatch batch;
  ASSERT_EQ(control.run(batch), Control::State::needs_probe);
  EXPECT_FALSE(control.snapshot());
  control.answer({true, {}});
  EXPECT_TRUE(control.snapshot());
}

TEST(snapshot, tables_that_did_not_change_are_shared) {
  Control control(test::control("mach3"), {}, Program{"p", text_source("G1 X1 F100\nX2\nG10 L2 P1 X5\nX3\nM30\n"), {}}, RunLimits{});
  control.return_each_block();
  ActionBatch batch;
  std::vector<Snapshot> all;
  while (control.run(batch) == Control::State::running)
    if (const auto now = control.snapshot()) all.push_back(*now);
  ASSERT_GE(all.size(), 4U);
  EXPECT_EQ(all[0].content().tables, all[1].content().tables);
  EXPECT_EQ(all[0].content().variables, all[1].content().variables);
  EXPECT_EQ(all[1].content().tables, all[3].content().tables);
  EXPECT_NE(all[1].content().variables, all[3].content().variables);  // work offsets are variables there
}

TEST(snapshot, a_called_file_that_is_gone_is_an_alarm) {
  Folder folder;
  folder.put({{"O0007.nct", "G91 G0 X1\nX2\nM99\n"}});
  const Work work{"nct", "", "M98 P7\nM30\n", "main.nct", {}};
  Control control(test::control("nct"), {}, Program{"main.nct", text_source(work.program), {}}, RunLimits{});
  control.return_each_block();
  ActionBatch batch;
  for (int i = 0; i < 3; ++i) (void)control.run(batch);
  const auto now = control.snapshot();
  ASSERT_TRUE(now);
  std::filesystem::remove("O0007.nct");
  Control fresh(test::control("nct"), {}, Program{"main.nct", text_source(work.program), {}}, RunLimits{});
  const auto restored = fresh.restore(*now);
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().id, AlarmId::file_missing);
}

}  // namespace
}  // namespace kadr::snapshot_test
