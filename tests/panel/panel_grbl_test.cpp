// A real machine at its panel (panel/grbl_axes, panel/panel_real): the double of a Grbl controller behind a pseudo-terminal, in real time.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "drive/double_terminal.h"
#include "panel/grbl_axes.h"
#include "panel/panel_machine.h"
#include "session/a_session.h"

namespace kadr::test {
namespace {

using drive::test::DoubleTerminal;

/// The double in a thread of its own. `with()` uses it while it stands still.
class LiveDouble {
 public:
  LiveDouble() : thread_([this] { live(); }) {}
  ~LiveDouble() {
    ends_ = true;
    thread_.join();
  }
  std::string name() { return terminal_.name(); }
  template <class Use>
  auto with(Use use) {
    const std::lock_guard hold(lock_);
    return use(terminal_);
  }
  drive::test::Point at() {
    return with([](DoubleTerminal& t) { return t.machine.position; });
  }
  bool moves() {
    return with([](DoubleTerminal& t) { return t.machine.moves(); });
  }
  bool spindle() {
    return with([](DoubleTerminal& t) { return t.machine.spindle; });
  }
  std::size_t lines() {
    return with([](DoubleTerminal& t) { return t.machine.executed.size(); });
  }

 private:
  void live() {
    const auto begin = std::chrono::steady_clock::now();
    while (!ends_) {
      {
        const std::lock_guard hold(lock_);
        const std::chrono::duration<double> now = std::chrono::steady_clock::now() - begin;
        if (terminal_.is_open()) (void)terminal_.serve(now.count());
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  DoubleTerminal terminal_;
  std::mutex lock_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

class RealPanel {
 public:
  explicit RealPanel(const std::string& program, const std::string& control = "linuxcnc") {
    auto machine = drive::GrblMachine::connect({real.name(), 115200, ""});
    EXPECT_TRUE(machine) << machine.error();
    const std::shared_ptr<drive::GrblMachine> shared = std::move(*machine);
    const auto opens = [=](const std::optional<Axes>& start, const StopToken& stop) -> tl::expected<std::unique_ptr<Session>, std::string> {
      Setup setup;
      RunLimits limits;
      limits.stop = stop;
      const char* const names[] = {"X", "Y", "Z"};
      for (std::size_t a = 0; start && a < 3; ++a) setup.start[names[a]] = (*start)[a];
      auto session = Session::open({shared_control(control), generic_machine(), setup, {"main.nc", text_source(program), {}}, limits});
      if (!session) return tl::unexpected(session.error().fault.en);
      return std::move(*session);
    };
    const auto axes = [shared](int, std::vector<std::string> names, const AxisRoles& roles, const Axes&) {
      return std::make_unique<GrblAxes>(shared, std::move(names), roles);
    };
    auto made = PanelMachine::make(opens, {}, Axes{}, {}, axes);
    EXPECT_TRUE(made) << made.error();
    panel_ = std::move(*made);
  }
  PanelMachine* operator->() const { return panel_.get(); }
  bool until(const std::function<bool(const PanelState&)>& is) {
    return wait([&] { return is(panel_->state()); });
  }
  bool stands(PanelMode mode) {
    return until([mode](const PanelState& s) { return s.mode == mode; });
  }
  static bool wait(const std::function<bool()>& is) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!is()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
  }
  void expect_at(double x, double y, double z) {
    const auto at = real.at();
    EXPECT_LT(std::hypot(at[0] - x, at[1] - y, at[2] - z), 0.002) << at[0] << ' ' << at[1] << ' ' << at[2];
  }

  LiveDouble real;

 private:
  std::unique_ptr<PanelMachine> panel_;
};

const char* const square = "G21 G90 G17\nG1 X10 F3000\nY10\nG3 X0 Y0 I0 J-10\nM2\n";

TEST(PanelGrbl, RunsAProgramOfAnyControl) {
  RealPanel panel(square);
  ASSERT_TRUE(panel->state().real);
  EXPECT_EQ(panel->state().real->state, "Idle");
  EXPECT_FALSE(panel.real.moves());
  ASSERT_TRUE(panel->run());
  EXPECT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::running && s.line.number == 3; }));
  EXPECT_TRUE(panel.stands(PanelMode::ended));
  panel.expect_at(0, 0, 0);
  EXPECT_GE(panel.real.lines(), 4U);
}

TEST(PanelGrbl, HoldsAndResumesOnThePath) {
  RealPanel panel("G21 G90\nG1 X60 F3000\nM2\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[0] > 5; }));
  ASSERT_TRUE(panel->hold());
  ASSERT_TRUE(panel.stands(PanelMode::held));
  const auto at = panel.real.at();
  EXPECT_FALSE(panel.real.moves());
  EXPECT_GT(at[0], 5);
  EXPECT_LT(at[0], 59);
  ASSERT_TRUE(panel->run());
  EXPECT_TRUE(panel.stands(PanelMode::ended));
  panel.expect_at(60, 0, 0);
}

TEST(PanelGrbl, ResetAndStopLeaveTheControllerEmpty) {
  RealPanel panel("G21 G90\nM3 S500\nG1 X60 F2000\nX0\nM2\n");
  for (const bool at_once : {false, true}) {
    SCOPED_TRACE(at_once);
    ASSERT_TRUE(panel->run());
    ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[0] > 3; }));
    if (at_once) {
      panel->stop_at_once();
      ASSERT_TRUE(panel.stands(PanelMode::emergency));
      EXPECT_FALSE(panel->run());
    }
    ASSERT_TRUE(panel->reset());
    ASSERT_TRUE(panel.stands(PanelMode::standing));
    EXPECT_FALSE(panel.real.moves());
    EXPECT_FALSE(panel.real.spindle());
    EXPECT_EQ(panel->state().line.number, 1U);
    const auto at = panel.real.at();
    EXPECT_NEAR(panel->state().sample.machine[0], at[0], 0.002);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_EQ(panel.real.at(), at);
    ASSERT_TRUE(panel->enter("G0 X0"));
    ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && std::fabs(s.sample.machine[0]) < 0.01; }));
  }
}

TEST(PanelGrbl, SingleBlockAndM0) {
  RealPanel panel("G21 G90\nG1 X5 F3000\nM0\nX10\nM2\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.why == "M0"; }));
  panel.expect_at(5, 0, 0);
  ASSERT_TRUE(panel->jog("Y", 2, 1000));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && std::fabs(s.sample.machine[1] - 2) < 0.01; }));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  panel.expect_at(10, 2, 0);
}

TEST(PanelGrbl, AToolChangeIsAStopWithTheSpindleOff) {
  RealPanel panel("G21 G90\nM3 S500\nG1 X5 F3000\nT2 M6\nG1 X10\nM30\n", "mach3");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.why == "M6"; }));
  EXPECT_NE(panel->state().message.find("T2"), std::string::npos);
  EXPECT_FALSE(panel.real.spindle());
  ASSERT_TRUE(panel->jog("Z", 3, 1000));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && std::fabs(s.sample.machine[2] - 3) < 0.01; }));
  EXPECT_FALSE(panel.real.spindle()) << "a jog does not start it";
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([&](const PanelState& s) { return s.sample.machine[0] > 6; }));
  EXPECT_TRUE(panel.real.spindle());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
}

/// The axis stops when the key is released, and also if nobody says that it is still held.
TEST(PanelGrbl, AHeldKeyMovesAnAxis) {
  RealPanel panel(square);
  for (const bool released : {true, false}) {
    SCOPED_TRACE(released);
    const double from = panel.real.at()[0];
    ASSERT_TRUE(panel->jog_while_held("X", 1, 1200));
    for (int i = 0; i < 6; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      EXPECT_TRUE(panel->keep_jogging(true));
    }
    if (released) panel->keep_jogging(false);
    ASSERT_TRUE(panel.stands(PanelMode::standing));
    EXPECT_FALSE(panel.real.moves());
    const double to = panel.real.at()[0];
    EXPECT_GT(to - from, 3);   // 20 mm/s
    EXPECT_LT(to - from, 60);  // a busy machine is no fault, an endless motion is
    EXPECT_NEAR(panel->state().block.work_of(panel->state().sample.machine)[0], to, 0.01);
  }
  EXPECT_FALSE(panel->undo()) << "a real machine cannot go back";
}

/// The axis ends where the probe has touched, and the control knows it.
TEST(PanelGrbl, AProbeTouches) {
  RealPanel panel(square);
  panel.real.with([](DoubleTerminal& t) { t.machine.probe_part = 0.25; });
  EXPECT_FALSE(panel->probe("Z", 0, 100));
  EXPECT_FALSE(panel->probe("Q", -1, 100));
  ASSERT_TRUE(panel->probe("Z", -8, 600));
  ASSERT_TRUE(
      panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.message.find("-2.000") != std::string::npos; }));
  panel.expect_at(0, 0, -2);
  ASSERT_TRUE(panel->enter("G91 G0 Z5"));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && std::fabs(s.sample.machine[2] - 3) < 0.01; }));
  panel.real.with([](DoubleTerminal& t) { t.machine.probe_touches = false; });
  ASSERT_TRUE(panel->probe("Z", -2, 600));
  ASSERT_TRUE(panel.stands(PanelMode::alarm));
  EXPECT_EQ(panel->state().message, "ALARM:5");
}

TEST(PanelGrbl, APulledCableIsAnAlarmAndNothingGoesOnByItself) {
  RealPanel panel("G21 G90\nG1 X100 F1500\nM2\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[0] > 3; }));
  panel.real.with([](DoubleTerminal& t) { t.unplug(); });
  ASSERT_TRUE(panel.stands(PanelMode::alarm));
  EXPECT_TRUE(panel->state().real->is_lost);
  EXPECT_FALSE(panel->state().message.empty());
  EXPECT_FALSE(panel->run());
}

TEST(PanelGrbl, ALimitSwitchIsAnAlarmUntilUnlocked) {
  RealPanel panel("G21 G90\nG1 X100 F1500\nM2\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[0] > 3; }));
  panel.real.with([](DoubleTerminal& t) { t.machine.hard_limit(); });
  ASSERT_TRUE(panel.stands(PanelMode::alarm));
  EXPECT_EQ(panel->state().message, "ALARM:1");
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.real->is_locked; }));
  EXPECT_FALSE(panel->run());
  ASSERT_TRUE(panel->unlock());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return !s.real->is_locked; }));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::running; }));
}

/// A page that slept or died holds the machine; a page that comes back continues it.
TEST(PanelGrbl, APageThatIsNotAliveHoldsTheMachine) {
  RealPanel panel("G21 G90\nG1 X200 F1500\nM2\n");
  panel->keep_alive();
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::held));
  EXPECT_FALSE(panel->state().message.empty());
  EXPECT_LT(panel.real.at()[0], 150);
  panel->keep_alive();
  ASSERT_TRUE(panel->run());
  EXPECT_TRUE(panel.stands(PanelMode::running));
}

TEST(PanelGrbl, WhatTheMachineDoesNotHaveIsAnAlarmBeforeItMoves) {
  RealPanel panel("G21 G90\nG1 X5 F3000\nG1 A90\nM2\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::alarm));
  EXPECT_NE(panel->state().message.find("X, Y"), std::string::npos) << panel->state().message;
}

}  // namespace
}  // namespace kadr::test
