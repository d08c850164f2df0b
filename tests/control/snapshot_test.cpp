// Control::snapshot() and restore(): a run that is stopped between two blocks and goes on in a fresh control gives what the run gives that
// was never stopped: the same trace, alarms, warnings and tables, byte for byte.

#include "control/state/snapshot.h"

#include <cstdio>
#include <cstdlib>
#include <random>

#include "case_files.h"
#include "control/run_program.h"
#include "control/snapshot_content.h"
#include "machine/plc.h"
#include "motion/time/steps.h"
#include "out/trace/trace.h"
#include "session/plc_commands.h"

namespace kadr {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_steps = 4000;  // calls of run()
constexpr std::size_t most_alarms = 50;

/// A program in a folder of its own, as the referee lays it out.
struct Work {
  std::string id, where, program, main_file;
  Setup setup;
  bool each_block = false;
};

/// A control, the logic of its machine, and all that they have given.
class Runner {
 public:
  explicit Runner(const Work& work)
      : control_(test::control(work.id), work.setup, Program{work.main_file, text_source(work.program), {}}, RunLimits{20'000, 5}),
        plc_(work.setup.events),
        start_(control_.ending()) {
    listen();
    if (work.each_block || !plc_.idle()) control_.hand_over_each_block();
    control_.set_waiting(Control::Waiting::pass);
  }
  /// Goes on from a snapshot of `other`: what that has given so far counts as given.
  Runner(const Work& work, const Runner& other, const Snapshot& from) : Runner(work) {
    plc_ = other.plc_;
    actions_ = other.actions_;
    told_ = other.told_;
    alarms_ = other.alarms_;
    over_ = other.over_;
    restored_ = control_.restore(from).has_value();
  }
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// One call of run(); false: it is over.
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
      tell("alarm", control_.report());
      if (++alarms_ > most_alarms) over_ = true;
      control_.go_on();
    }
    over_ = over_ || state == Control::State::ended;
    return !over_;
  }
  std::size_t finish(std::size_t steps = 0) {
    while (steps < most_steps && step()) ++steps;
    return steps;
  }
  std::optional<Snapshot> snapshot() const { return control_.snapshot(); }
  bool restored() const { return restored_; }

  /// Everything, as text.
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
    return all + told_ + std::to_string(control_.blocks()) + " " + std::to_string(control_.use().all().size());
  }

 private:
  void listen() {
    control_.on_warning = [this](const AlarmReport& warning) { tell("warning", warning); };
    if (!plc_.idle()) control_.on_block = [this](const Origin& origin, bool at_end) { apply(plc_.block(origin, at_end), control_, all_); };
  }
  void tell(const char* kind, const AlarmReport& report) {
    told_ += kind + std::string(" ") + std::string(name_of(report.alarm.id)) + " " + std::to_string(report.origin.line) + " " +
             std::to_string(report.alarm.where.begin) + " " + report.file + " after " + std::to_string(actions_.size()) + "\n";
  }

  Control control_;
  Plc plc_;
  Ending start_;
  std::array<Control*, 1> all_ = {&control_};
  ActionBatch batch_;
  std::vector<Action> actions_;
  std::string told_;
  std::size_t alarms_ = 0;
  bool over_ = false, restored_ = false;
};

/// The first line in which two texts differ.
std::string difference(const std::string& a, const std::string& b) {
  std::istringstream left(a), right(b);
  std::string one, other;
  while (true) {
    const bool more = static_cast<bool>(std::getline(left, one)), more_there = static_cast<bool>(std::getline(right, other));
    if (!more && !more_there) return "";
    if (!more) one = "(nothing)";
    if (!more_there) other = "(nothing)";
    if (one != other) return "never stopped: " + one.substr(0, 400) + "\n  restored:      " + other.substr(0, 400);
  }
}

struct Tally {
  std::size_t programs = 0, restored = 0, shown = 0;
};

/// Stops at random places and goes on from there: in the control itself, and in a fresh one.
void check(const Work& work, std::mt19937& choose, Tally& tally) {
  Runner whole(work);
  const std::size_t steps = whole.finish();
  const std::string expected = whole.all();
  ++tally.programs;
  for (int stop = 0; stop < 2; ++stop) {
    const std::size_t at = std::uniform_int_distribution<std::size_t>(0, steps)(choose);
    Runner stopped(work);
    std::size_t done = 0;
    while (done < at && stopped.step()) ++done;
    auto snapshot = stopped.snapshot();
    while (!snapshot && stopped.step()) ++done, snapshot = stopped.snapshot();
    if (!snapshot || done > steps) continue;  // it ends in the middle of a block
    Runner fresh(work, stopped, *snapshot);
    ASSERT_TRUE(fresh.restored()) << work.where;
    stopped.finish(done);
    fresh.finish(done);
    const std::string undisturbed = difference(expected, stopped.all()), same = difference(expected, fresh.all());
    if (!(undisturbed + same).empty() && ++tally.shown <= 20)
      ADD_FAILURE() << work.where << (work.each_block ? ", each block" : "") << ", stopped after " << done << " of " << steps
                    << " calls\n  " << undisturbed << (undisturbed.empty() ? "" : " (by the snapshot itself)\n  ") << same << "\n"
                    << work.program.substr(0, 1500);
    ++tally.restored;
  }
}

/// A folder with the case's files as the working directory, removed with all in it.
class Folder {
 public:
  Folder() : before_(fs::current_path()) {
    std::string name = (fs::temp_directory_path() / "kadr_snapshot_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
    fs::current_path(path_);
  }
  ~Folder() {
    fs::current_path(before_);
    fs::remove_all(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  void put(const test::Json& files) {
    for (const auto& entry : fs::directory_iterator(path_)) fs::remove_all(entry);
    for (const auto& [name, text] : files.items()) {
      const fs::path file = path_ / name;
      fs::create_directories(file.parent_path());
      std::ofstream(file) << text.get<std::string>();
    }
  }

 private:
  fs::path before_, path_;
};

TEST(snapshot, golden_and_own_cases_go_on_the_same) {
  Folder folder;
  std::mt19937 choose(7);
  Tally tally;
  test::for_each_case([&](const test::Json& given, const std::string& where) {
    const std::string id = given.value("control", "");
    const auto setups = test::setups_of(given);
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const auto setup = parse_setup(setups[i].dump());
      if (!setup || setups[i].contains("search")) continue;
      const test::Json variant = given.contains("variants") ? given["variants"][i] : test::Json::object();
      const std::string program = variant.contains("program") ? variant["program"].get<std::string>() : given["program"].get<std::string>();
      folder.put(setups[i].value("files", test::Json::object()));
      const std::string main = setups[i].value("main_file", id == "nct" ? "main.nct" : "main.nc");
      std::ofstream(main) << program;
      check({id, where, program, main, *setup, tally.programs % 2 == 0}, choose, tally);
    }
  });
  EXPECT_GT(tally.programs, 1800U);
  EXPECT_GT(tally.restored, 2 * tally.programs * 9 / 10);  // the others are over within their first block
}

TEST(snapshot, examples_go_on_the_same) {
  std::mt19937 choose(8);
  Tally tally;
  for (const std::string id : {"s2c42", "mach3", "nct", "correctors", "gost"})
    for (const auto& entry : fs::directory_iterator(KADR_ROOT "/examples/" + id)) {
      const std::string ending = entry.path().extension();
      if (ending == ".json" || ending == ".toml" || ending == ".md" || ending == ".svg") continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string program((std::istreambuf_iterator<char>(stream)), {});
      std::ifstream beside(fs::path(entry.path()).replace_extension(".json"));
      const std::string json((std::istreambuf_iterator<char>(beside)), {});
      const auto setup = json.empty() ? kadr::Setup() : parse_setup(json).value();
      for (const bool each_block : {false, true}) check({id, entry.path(), program, entry.path(), setup, each_block}, choose, tally);
    }
  EXPECT_GT(tally.restored, 50U);
}

// ---- random programs

/// Of each control: what lines are made of. A letter alone gets a number, `@` the number of a line.
const std::map<std::string, std::vector<std::string>> lines_of = {
    {"nct",
     {"G0 X Y",
      "G1 X Y F",
      "G2 X Y R",
      "G3 X Y I J",
      "G90",
      "G91",
      "G17",
      "G18",
      "G41 D1 X Y",
      "G42 D1 X",
      "G40 X Y",
      "G43 H1 Z",
      "G49",
      "G54",
      "G55",
      "G94",
      "G95",
      "S M3",
      "M5",
      "T1 M6",
      "G81 X Y Z R F",
      "X Y",
      "G83 X Z R Q1 F",
      "G80",
      "G68 X Y R",
      "G69",
      "G51.1 X",
      "G50.1",
      "G16",
      "G15",
      "G10 L2 P1 X",
      "G10 L10 P1 R",
      "G52 X",
      "G92 X",
      "G20",
      "G21",
      "G4 P1",
      "G33 Z F1",
      "G28 X",
      "#1=#1+1",
      "#100=#100+X",
      "#500=#5001",
      "IF[#1LT5]GOTO@",
      "IF[#100LT30]THEN#100=#100+1",
      "WHILE[#2LT3]DO1",
      "#2=#2+1",
      "END1",
      "G65 P9100 A B",
      "M98 P9101 L2",
      "G66 P9100 A",
      "G67",
      "G1 X#1 Y#100",
      "G31 X F",
      "G96 S",
      "G97 S",
      "M99",
      "/G1 X Y F",
      "G10 L52",
      "N1339 R0.5",
      "G11",
      "X@",
      "#3000=1(A)",
      "G2 X",
      "DPRNT[X#1[31]]"}},
    {"mach3",
     {"G0 X Y",
      "G1 X Y F",
      "G2 X Y R",
      "G3 X Y I J",
      "G90",
      "G91",
      "G17",
      "G18",
      "G41 P2 X Y",
      "G42 P2 X",
      "G40 X Y",
      "G43 H1",
      "G49",
      "G54",
      "G59 P3",
      "G94",
      "G95",
      "S M3",
      "M5",
      "T1 M6",
      "G81 X Y Z R F",
      "X Y",
      "G83 X Z R Q1 F",
      "G80",
      "G68 A0 B0 R",
      "G69",
      "G51 X2",
      "G50",
      "G15",
      "G16",
      "G10 L2 P1 X",
      "G52 X",
      "G92 X",
      "G92.1",
      "G20",
      "G21",
      "G4 P1",
      "G28 X",
      "#1=[#1+1]",
      "G1 X#1 Y[#2*2]",
      "#2=[SIN[#1]] X#2",
      "M98 P100 L2",
      "M99",
      "/G1 X Y F",
      "G31 X F",
      "G93",
      "G98",
      "G99",
      "G82 X Z R P1 F",
      "X@"}},
    {"gost", {"G0 X Y", "G1 X Y F", "G2 X Y I J", "G90",   "G91", "G17",           "G18", "G40",     "G41 D1 X Y", "G43 H1 Z", "G54", "G94",
              "G95",    "S M3",     "M5",         "T1 M6", "X Y", "G81 X Y Z R F", "G80", "G92 X Y", "G4 X1",      "M8",       "M9",  "Z"}},
    {"correctors",
     {"G0 X Y", "G1 X Y F", "G2 X Y I J", "G90", "G91", "X Y", "L17 X", "G41 L17 X", "L2 15 X Y", "G40", "S M3", "T0101 M6", "F", "Z",
      "G4 F1", "M8", "G1 X L17"}},
    {"s2c42",
     {"N@ G0 X Y", "N@ G1 X Y F", "N@ G2 X Y I J", "N@ G90",      "N@ G91",   "N@ X Y", "N@ G17",   "N@ G54",  "N@ G92 X",
      "N@ S M3",   "N@ T1 M6",    "N@ Z",          "N@ G41 D1 X", "N@ G40 X", "N@ H3",  "N@ X M20", "N@ R1 5", "N@ L81 R2-5 R3-20 R10 R7 1",
      "N@ G43 D1", "N@ M5",       "N@ G4 F1"}}};

std::string random_program(const std::string& id, std::mt19937& choose) {
  const auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(choose); };
  const std::vector<std::string>& all = lines_of.at(id);
  std::string text = id == "correctors" || id == "s2c42" || id == "gost" ? "%\n" : "";
  const std::size_t lines = 5 + below(60);
  for (std::size_t i = 1; i <= lines; ++i) {
    if (id == "nct") text += "N" + std::to_string(i) + " ";
    const std::string& form = all[below(all.size())];
    for (std::size_t c = 0; c < form.size(); ++c) {
      const bool alone = form[c] >= 'A' && form[c] <= 'Z' && (c + 1 == form.size() || form[c + 1] == ' ') && (c == 0 || form[c - 1] == ' ');
      if (form[c] == '@') text += std::to_string(id == "nct" ? 1 + below(lines) : i);
      else text += form[c];
      if (alone) text += std::to_string(static_cast<int>(below(90)) - 30);
    }
    text += "\n";
  }
  if (id == "mach3") text += "M30\nO100\nG91 G1 X1 F50\nG90\nM99\n";
  else if (below(2) == 0) text += id == "nct" ? "M30\n" : "M2\n";
  return text;
}

class SnapshotOfRandomPrograms : public testing::TestWithParam<const char*> {};

TEST_P(SnapshotOfRandomPrograms, goes_on_the_same) {
  Folder folder;
  folder.put({{"O9100.nct", "G91 G0 X#1 Y#2\n#101=#101+1\nG90\nM99\n"}, {"O9101.nct", "IF[#1EQ#0]THEN#1=0\n#1=#1+1\nG1 Z#1 F100\nM99\n"}});
  std::mt19937 choose(9);
  Tally tally;
  const auto setup = parse_setup(R"({"start": {"Z": 100}, "offsets": {"1": {"length": 10, "radius": 2}}, "skip": [1]})").value();
  for (int i = 0; i < 400; ++i)
    check({GetParam(), "random " + std::to_string(i), random_program(GetParam(), choose), "main.nct", setup, i % 2 == 0}, choose, tally);
  EXPECT_GT(tally.restored, 300U);
}

INSTANTIATE_TEST_SUITE_P(snapshot, SnapshotOfRandomPrograms, testing::Values("nct", "mach3", "gost", "correctors", "s2c42"),
                         [](const auto& control) { return std::string(control.param); });

// ---- what is special

TEST(snapshot, there_is_none_in_the_middle_of_a_block) {
  Control control(test::control("mach3"), {}, Program{"p", text_source("G81 X0 Y0 Z-5 R2 F100 L40\nM30\n"), {}}, RunLimits{});
  ActionBatch batch;
  ASSERT_EQ(control.run(batch), Control::State::running);
  EXPECT_FALSE(control.snapshot());  // holes are left
  while (control.run(batch) == Control::State::running) {
  }
  EXPECT_TRUE(control.snapshot());
}

TEST(snapshot, tables_that_did_not_change_are_shared) {
  Control control(test::control("mach3"), {}, Program{"p", text_source("G1 X1 F100\nX2\nG10 L2 P1 X5\nX3\nM30\n"), {}}, RunLimits{});
  control.hand_over_each_block();
  ActionBatch batch;
  std::vector<Snapshot> all;
  while (control.run(batch) == Control::State::running)
    if (const auto now = control.snapshot()) all.push_back(*now);
  ASSERT_GE(all.size(), 4U);
  EXPECT_EQ(all[0].content().tables, all[1].content().tables);
  EXPECT_EQ(all[0].content().variables, all[1].content().variables);
  EXPECT_EQ(all[1].content().tables, all[3].content().tables);
  EXPECT_NE(all[1].content().variables, all[3].content().variables);  // work zeros are variables there
}

TEST(snapshot, a_called_file_that_is_gone_is_an_alarm) {
  Folder folder;
  folder.put({{"O0007.nct", "G91 G0 X1\nX2\nM99\n"}});
  const Work work{"nct", "", "M98 P7\nM30\n", "main.nct", {}, true};
  Control control(test::control("nct"), {}, Program{"main.nct", text_source(work.program), {}}, RunLimits{});
  control.hand_over_each_block();
  ActionBatch batch;
  for (int i = 0; i < 3; ++i) (void)control.run(batch);
  const auto now = control.snapshot();
  ASSERT_TRUE(now);
  fs::remove("O0007.nct");
  Control fresh(test::control("nct"), {}, Program{"main.nct", text_source(work.program), {}}, RunLimits{});
  const auto restored = fresh.restore(*now);
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().id, AlarmId::file_missing);
}

}  // namespace
}  // namespace kadr
