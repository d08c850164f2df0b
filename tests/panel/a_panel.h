#pragma once
// A machine with its panel. Its axes are fast, so that no test waits long.

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "panel/panel_machine.h"
#include "session/a_session.h"

namespace kadr::test {

class APanel {
 public:
  explicit APanel(const std::string& program, const std::string& control = "mach3", const Setup& its_setup = {},
                  PanelRecorder keeper = {}) {
    setup->now = its_setup;
    if (!keeper.tables)
      keeper.tables = [setup = setup](const Setup&, const Setup& after) {
        const std::lock_guard hold(setup->lock);
        setup->now.offsets = after.offsets, setup->now.work_offsets = after.work_offsets, setup->now.parameters = after.parameters;
        return std::string();
      };
    MachineProfile machine = generic_machine();
    for (const char* const axis : {"X", "Y", "Z"}) {
      machine.axes[axis].rapid = 60'000, machine.axes[axis].acceleration = 5'000, machine.axes[axis].jerk = 1e6;
      machine.axes[axis].least = -500, machine.axes[axis].most = 500;
    }
    machine.tool_change_s = 0;
    machine.planner = PlannerMode::optimal;
    auto made = PanelMachine::make(
        [=, setup = setup](const std::optional<Axes>& start, const StopToken& stop) -> tl::expected<std::unique_ptr<Session>, std::string> {
          Setup with = setup->copy();
          RunLimits limits;
          limits.stop = stop;
          const char* const names[] = {"X", "Y", "Z"};
          for (std::size_t a = 0; start && a < 3; ++a) with.start[names[a]] = (*start)[a];
          auto session = Session::open({shared_control(control), machine, with, {"main.nc", text_source(program), {}}, limits});
          if (!session) return tl::unexpected(session.error().fault.en);
          return std::move(*session);
        },
        std::move(keeper));
    EXPECT_TRUE(made) << made.error();
    machine_ = std::move(*made);
  }
  /// Changes the set-up of the next session.
  void edit(const std::function<void(Setup&)>& change) const {
    const std::lock_guard hold(setup->lock);
    change(setup->now);
  }
  PanelMachine* operator->() const { return machine_.get(); }

  /// Waits until `is` returns true. The limit is generous, because the test machine may be busy.
  bool until(const std::function<bool(const PanelState&)>& is) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!is(machine_->state())) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  bool stands(PanelMode mode) const {
    return until([mode](const PanelState& s) { return s.mode == mode; });
  }
  Vec3 at() const {
    const Axes& a = machine_->state().sample.machine;
    return {a[0], a[1], a[2]};
  }
  std::uint32_t line() const { return machine_->state().line.number; }

 private:
  /// Threads of the machine open sessions, so the tables have a lock.
  struct Tables {
    std::mutex lock;
    Setup now;
    Setup copy() {
      const std::lock_guard hold(lock);
      return now;
    }
  };
  std::shared_ptr<Tables> setup = std::make_shared<Tables>();
  std::unique_ptr<PanelMachine> machine_;
};

inline void expect_at(const APanel& panel, Vec3 wanted) {
  const Vec3 at = panel.at();
  EXPECT_LT(length(at - wanted), 1e-9) << at.x << ' ' << at.y << ' ' << at.z;
}

}  // namespace kadr::test
