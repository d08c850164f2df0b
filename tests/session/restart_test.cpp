// Restart in mid program: the control executes the written blocks, and then everything is in force that must be; the path to the
// restart point goes over the clearance height.

#include "session/restart.h"

#include <cmath>

#include "session/a_session.h"

namespace kadr::restart_test {
namespace {

using test::ASession;
using Kind = InForce::Kind;

const char* const program =
    "G21 G90 G17 G54\n"
    "T5 M6\n"
    "S800 M3\n"
    "G0 X10 Y20\n"
    "G43 H5 Z50\n"
    "M8\n"
    "G0 Z2\n"
    "G1 Z-3 F120\n"
    "#100=7\n"
    "G91 X30\n"
    "Y5\n"
    "G90 G81 X50 Y50 Z-5 R2 F90 L3\n"
    "G80\n"
    "M30\n";

const char* const setup = R"({"start": {"X": 100, "Y": 100, "Z": 200}, "offsets": {"5": {"length": 42}},
                              "work_offsets": {"G54": {"X": -200, "Y": -100, "Z": -50}}})";

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "; ";
  return text;
}

std::optional<InForce> find(const std::vector<InForce>& all, Kind kind, const std::string& name) {
  for (const InForce& one : all)
    if (one.kind == kind && one.name == name) return one;
  return std::nullopt;
}

TEST(restart, what_is_in_force_and_what_differs) {
  const auto stated = parse_setup(setup).value();
  ASession s("nct", program, stated);
  const auto at_start = s->control().in_force();
  Stepping stepping(*s);
  const auto restart = restart_at(*s, stepping, {.line = 11});
  ASSERT_TRUE(restart);
  EXPECT_EQ(restart->at.line, 11U);
  EXPECT_EQ(find(restart->in_force, Kind::tool, "")->value, 5);
  EXPECT_EQ(find(restart->in_force, Kind::spindle, "")->code, "M3");
  EXPECT_EQ(find(restart->in_force, Kind::coolant, "")->code, "M8");
  EXPECT_EQ(find(restart->in_force, Kind::feed, "F")->value, 120);
  EXPECT_EQ(find(restart->in_force, Kind::variable, "#100")->value, 7);
  EXPECT_EQ(find(restart->in_force, Kind::length, "Z")->value, 42);
  EXPECT_EQ(find(restart->in_force, Kind::origin, "X")->value, -200);
  EXPECT_EQ(restart->stand.work[0], 40);
  EXPECT_EQ(restart->stand.machine[0], -160);
  EXPECT_EQ(restart->stand.machine[2], -3 - 50 + 42);
  std::vector<std::string> names;
  for (const Difference& d : differences(restart->in_force, at_start))
    if (d.required && d.required->kind == Kind::code) names.push_back(d.required->code);
  EXPECT_EQ(joined(names), "G1; G91; G43; ");
  EXPECT_TRUE(differences(restart->in_force, restart->in_force).empty());
}

TEST(restart, the_way_goes_over_the_clearance) {
  Restart to;
  to.stand.work = {40, 20, -3};
  to.stand.machine = {-160, -80, -11};
  ToolPosition from;
  from.machine = {100, 100, -30};
  const auto path = path_there(from, to, {.clearance = 50, .above = 2, .feed = 77}, 3);
  ASSERT_EQ(path.size(), 4U);
  EXPECT_TRUE(path[0].rapid && path[0].named == 4 && path[0].machine[2] == 42);  // 50 mm in work coordinates
  EXPECT_TRUE(path[1].rapid && path[1].named == 3 && path[1].machine[0] == -160 && path[1].machine[2] == 42);
  EXPECT_TRUE(path[2].rapid && path[2].named == 4 && path[2].machine[2] == -9);
  EXPECT_TRUE(!path[3].rapid && path[3].named == 4 && path[3].machine[2] == -11 && path[3].feed == 77);
  EXPECT_TRUE(path_there(to.stand, to, {.clearance = 50}, 3).empty());
  from.machine = {-160, -80, 90};  // straight above the point: straight down
  EXPECT_EQ(path_there(from, to, {.clearance = 50}, 3).size(), 2U);
}

/// The n-th hole of a canned cycle that drills several, for each control with such cycles.
TEST(restart, over_a_hole_of_a_cycle) {
  const char* const row = "G21 G17\nG0 X0 Y0 Z10\nG91 G81 X10 Y0 Z-5 R-8 F100 L5\nG80\nM30\n";
  for (const std::string control : {"nct", "mach3"})
    for (const std::uint32_t hole : {1U, 2U, 5U}) {
      ASession s(control, row);
      Stepping stepping(*s);
      const auto restart = restart_at(*s, stepping, {.line = 3}, hole);
      ASSERT_TRUE(restart) << control << " " << hole;
      EXPECT_EQ(restart->stand.work[0], 10 * hole) << control;
      EXPECT_GE(restart->stand.work[2], 2) << control;
      EXPECT_EQ(stepping.go(Stepping::How::free), Session::State::ended);
    }
  ASession s("nct", row);
  Stepping stepping(*s);
  EXPECT_FALSE(restart_at(*s, stepping, {.line = 3}, 6));
}

/// For any line of an example the control accepts the blocks. After them everything is in force except what they leave to the operator.
TEST(restart, blocks_bring_what_must_be_in_force) {
  std::size_t lines = 0, shown = 0, written = 0;
  test::for_each_example([&](const test::Work& work) {
    ASession whole(work.id, work.program, work.setup, work.main_file);
    if (!whole.opened() || whole->channels().size() > 1 || work.main_file.ends_with(".tape")) return;
    Stepping stepping(*whole);
    const ControlDef& def = whole->def();
    for (int i = 0; i < 120 && stepping.go(Stepping::How::block) == Session::State::held; ++i) {
      if (i % 7 != 3 || !whole->control().calls().empty()) continue;
      const auto restart = restart_here(*whole, stepping);
      ASSERT_TRUE(restart);
      const bool in_contour = restart->stand.machine != whole->control().tool_position().machine;  // the position is not the programmed one
      if (in_contour || find(restart->in_force, Kind::rotation, "") || restart->stand.turn) continue;
      ASession fresh(work.id, work.program, work.setup, work.main_file);
      Stepping by_hand(*fresh);
      if (by_hand.go(Stepping::How::block) != Session::State::held) continue;
      ++lines;
      std::vector<InForce> wanted;
      for (const Difference& d : differences(restart->in_force, fresh->control().in_force()))
        if (d.required) wanted.push_back(*d.required);
      const auto technology = restart_blocks(def, wanted, restart->in_force, {});
      ASSERT_TRUE(technology);
      const auto path = path_there(fresh->stand(), *restart, {.clearance = 300, .above = 2, .feed = 100}, whole->control().axes().size());
      const auto blocks = restart_blocks(def, wanted, restart->in_force, in_work_coordinates(path, *restart, def));
      ASSERT_TRUE(blocks);
      for (const std::string& block : blocks->blocks) {
        ++written;
        if (by_hand.enter(block) == Session::State::stopped && ++shown < 10)
          ADD_FAILURE() << work.where << ":" << restart->at.line << ": " << block << ": " << fresh.reported().back() << "\n"
                        << joined(blocks->blocks);
      }
      std::vector<std::string> left;
      for (const Difference& d : differences(restart->in_force, fresh->control().in_force())) {
        if (!d.required) continue;  // there was no feed before
        const auto& one = *d.required;
        const bool rounded = (one.kind == Kind::position || one.kind == Kind::machine || one.kind == Kind::feed) && d.now &&
                             std::fabs(one.value - d.now->value) < 0.0013;  // half the increment of a word, in inches
        const bool of_coolant = one.kind == Kind::code && (one.code == "M8" || one.code == "M9");  // M13 has switched it already
        if (rounded || of_coolant) continue;
        const bool listed = std::any_of(blocks->by_hand.begin(), blocks->by_hand.end(), [&](const InForce& other) {
          const bool by_zero = one.kind == Kind::machine && other.kind == Kind::origin;  // G92: the path is written from another origin
          return (other.kind == one.kind || by_zero) && other.name == one.name;
        });
        if (!listed) left.push_back(one.name + one.code + " kind " + std::to_string(int(one.kind)) + "=" + std::to_string(one.value));
      }
      if (!left.empty() && ++shown < 10)
        ADD_FAILURE() << work.where << ":" << restart->at.line << " left: " << joined(left) << "\n" << joined(blocks->blocks);
    }
  });
  EXPECT_GT(lines, 60U);
  EXPECT_GT(written, 300U);
}

}  // namespace
}  // namespace kadr::restart_test
