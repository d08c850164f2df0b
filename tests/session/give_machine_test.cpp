// session/give_machine: passes to a control what the machine file contains and the set-up does not.

#include "session/give_machine.h"

#include "config/machine/machine_axes.h"
#include "kinematics/machine_tree.h"
#include "session/a_session.h"

namespace kadr::give_machine_test {
namespace {

double given(const Setup& setup, const char* number, const char* bit = "") {
  const auto found = setup.parameters.find(ParameterKey{number, "", bit});
  return found == setup.parameters.end() ? -1 : std::get<double>(found->second);
}

TEST(give_machine, a_trunnion_in_the_parameters_of_the_nct) {
  kadr::Setup setup;
  give_machine(setup, load_machine("table-table").value(), *test::shared_control("nct"));
  EXPECT_EQ(setup.axes, (std::vector<std::string>{"X", "Y", "Z", "A", "C"}));
  EXPECT_EQ(given(setup, "3200"), 2);
  EXPECT_EQ(given(setup, "3201"), 3);
  EXPECT_EQ(given(setup, "3204"), 4);
  EXPECT_EQ(given(setup, "3205"), 1);
  EXPECT_EQ(given(setup, "3208"), 5);
  EXPECT_EQ(given(setup, "3209"), 3);
  EXPECT_EQ(given(setup, "3212", "RD1"), 1);
  EXPECT_EQ(given(setup, "3213"), -400);
  EXPECT_EQ(given(setup, "3218"), -30);
  EXPECT_EQ(setup.axis_limits.at("A"), (std::pair{-120., 30.}));
}

TEST(give_machine, the_setup_goes_before) {
  const MachineProfile machine = load_machine("head-head").value();
  kadr::Setup setup;
  setup.parameters[ParameterKey{"3200", "", ""}] = 0.;
  give_machine(setup, machine, *test::shared_control("nct"));
  EXPECT_EQ(setup.parameters.size(), 1U);
  EXPECT_TRUE(setup.axes.empty());

  kadr::Setup with_axes;
  with_axes.axes = {"X", "Y", "Z", "C", "A"};
  give_machine(with_axes, machine, *test::shared_control("nct"));
  EXPECT_EQ(given(with_axes, "3204"), 4) << "the first is C, the fourth axis of this channel";

  kadr::Setup without_rotary;
  without_rotary.axes = {"X", "Y", "Z"};
  give_machine(without_rotary, machine, *test::shared_control("nct"));
  EXPECT_TRUE(without_rotary.parameters.empty());

  kadr::Setup of_another;
  give_machine(of_another, machine, *test::shared_control("mach3"));
  EXPECT_TRUE(of_another.parameters.empty());
  EXPECT_TRUE(of_another.axes.empty());
}

const CodeRow* m_row(const ControlDef& def, std::int32_t number) {
  const std::int32_t index = def.row_of('M', 10 * number);
  return index < 0 ? nullptr : &def.codes[static_cast<std::size_t>(index)];
}

// The M codes that the machine's file names: known on a Haas, which refuses all others, and named on a Fanuc.
TEST(give_machine, m_codes_of_the_machine) {
  MachineProfile machine = load_machine("lathe").value();
  machine.m_codes = {{3, {"not a spindle", ""}}, {10, {"collet", "цанга"}}, {55, {"steady rest", "люнет"}}};
  for (const char* id : {"haas-st", "fanuc-t"}) {
    kadr::Setup setup;
    give_machine(setup, machine, *test::shared_control(id));
    ControlDef def = *test::shared_control(id);
    const CodeRow* const before = m_row(def, 55);
    EXPECT_EQ(before != nullptr, id == std::string("fanuc-t"));
    EXPECT_EQ(fit_to_machine(def, setup), "") << id;
    ASSERT_NE(m_row(def, 55), nullptr) << id;
    EXPECT_EQ(m_row(def, 55)->text.en, "steady rest") << id;
    EXPECT_EQ(m_row(def, 55)->function, Function::machine_function) << id;
    EXPECT_EQ(m_row(def, 10)->text.ru, "цанга") << id;
    EXPECT_EQ(m_row(def, 3)->function, Function::spindle_code) << id;
    EXPECT_NE(m_row(def, 3)->text.en, "not a spindle") << id;
    if (id == std::string("haas-st")) EXPECT_EQ(m_row(def, 56), nullptr);
    else EXPECT_NE(m_row(def, 56)->text.en, "steady rest");
  }
}

// The axes of a lathe are those of the machine: X Z, or X Z C Y.
TEST(give_machine, a_lathe_names_its_axes) {
  kadr::Setup setup;
  give_machine(setup, load_machine("lathe").value(), *test::shared_control("fanuc-t"));
  EXPECT_EQ(setup.axes, (std::vector<std::string>{"X", "Z"}));
  EXPECT_EQ(setup.axis_limits.at("X"), (std::pair{-220., 0.}));

  kadr::Setup with_y;
  give_machine(with_y, load_machine("lathe-cy").value(), *test::shared_control("fanuc-t"));
  EXPECT_EQ(with_y.axes, (std::vector<std::string>{"X", "Z", "C", "Y"}));
  EXPECT_EQ(with_y.axis_limits.at("Y"), (std::pair{-50., 50.}));

  kadr::Setup stated;
  stated.axes = {"X", "Z", "C"};
  give_machine(stated, load_machine("lathe-cy").value(), *test::shared_control("fanuc-t"));
  EXPECT_EQ(stated.axes, (std::vector<std::string>{"X", "Z", "C"}));

  kadr::Setup without_chains;
  give_machine(without_chains, load_machine("generic").value(), *test::shared_control("fanuc-t"));
  EXPECT_TRUE(without_chains.axes.empty());

  kadr::Setup of_nct;  // the NCT has one list of axes for mills and lathes
  give_machine(of_nct, load_machine("lathe-cy").value(), *test::shared_control("nct"));
  EXPECT_EQ(of_nct.axes, (std::vector<std::string>{"X", "Y", "Z", "C"}));
}

TEST(give_machine, inclined_axes_and_those_that_roll_over) {
  MachineProfile machine = load_machine("table-table").value();
  machine.axes["A"].joint.direction = unit({0, -1, 1});
  machine.axes["C"].joint.rolls_over = true;
  kadr::Setup setup;
  give_machine(setup, machine, *test::shared_control("nct"));
  EXPECT_EQ(given(setup, "3205"), 5);
  EXPECT_NEAR(given(setup, "3206"), 135, 1e-9);
  EXPECT_EQ(std::get<double>(setup.parameters.at(ParameterKey{"0107", "C", "0"})), 1);
  machine.axes["A"].joint.direction = unit({1, 1, 1});  // the control has no code for this direction
  kadr::Setup none;
  give_machine(none, machine, *test::shared_control("nct"));
  EXPECT_EQ(given(none, "3200"), -1);
}

// The tip that the control leads by these parameters is where the chains of the file put it.
TEST(give_machine, the_control_and_the_file_mean_the_same_place) {
  const std::pair<const char*, const char*> programs[] = {
      {"table-table", "G54 G43.4 H1\nG0 X10 Y-20 Z30\nG1 X30 Y15 Z12 A-40 C75 F1000\nX-5 A-80 C200\nM30\n"},
      {"head-head", "G54 G43.4 H1\nG0 X10 Y-20 Z30\nG1 X30 Y15 Z12 A-40 C75 F1000\nX-5 A-80 C200\nM30\n"},
      {"head-table", "G54 G43.4 H1\nG0 X10 Y-20 Z30\nG1 X30 Y15 Z12 B40 C75 F1000\nX-5 B80 C200\nM30\n"}};
  for (const auto& [name, program] : programs) {
    const std::string id = name;  // a copy, because a lambda cannot capture a structured binding
    const MachineProfile machine = load_machine(id).value();
    kadr::Setup setup;
    setup.offsets[1].length = 90;
    const Vec3 zero = id == "head-head" ? Vec3{900, 700, -600} : Vec3{-250, -250, -300};
    setup.work_offsets["G54"] = {{"X", zero.x}, {"Y", zero.y}, {"Z", zero.z}};
    test::ASession session("nct", program, setup, "main.nc", machine);
    ASSERT_TRUE(session.opened());
    const MachineTree tree(machine, session->control().axes());
    int looked_at = 0;
    session->outlets().step = [&](const Step& step) {
      const auto* const motion = std::get_if<Motion>(&step.action.what);
      if (motion == nullptr || step.from.space == nullptr) return;
      const Pose pose = step.from.space->pose(motion->machine);
      const Pose by_file = tree.forward(motion->machine, 90);
      const Vec3 in_system = by_file.tip - zero;
      EXPECT_LT(length(pose.tip - in_system), 1e-9) << id << ' ' << pose.tip.x << ' ' << pose.tip.y << ' ' << pose.tip.z;
      EXPECT_LT(length(pose.direction - by_file.direction), 1e-12) << id;
      ++looked_at;
    };
    (void)session->run();
    EXPECT_TRUE(session.reported().empty()) << id << ": " << session.reported().front();
    EXPECT_EQ(looked_at, 3) << id;
  }
}

}  // namespace
}  // namespace kadr::give_machine_test
