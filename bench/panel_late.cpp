// Measures the greatest lateness of the servo clock of a machine that a web page operates, compared with two idle loops of the same
// period in the same process. Both loops do the same, so the difference between them shows how reliable the measurement is on this
// computer.
//
//     build/bench/bench/panel_late [SECONDS=60]
//
// The machine follows circles of short segments; another thread requests its state 60 times a second, as the web page does. Prints the
// greatest lateness of the clock and of each loop in ms, every ten seconds and at the end. Exit status 1: the clock is later than both
// idle loops, by more than 1 ms.

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

#include "config/control/control_file.h"
#include "panel/panel_machine.h"

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

/// Returns a program of circles of 400 segments each, which does not end before the measurement does.
std::string rounds() {
  std::string text = "G21 G90 G94 G17\nG0 X30 Y0 Z0\nM98 P7 L100000\nM30\nO7\n";
  for (int i = 1; i <= 400; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 400;
    text += fmt::format("G1 X{:.4f} Y{:.4f} F3000\n", 30 * std::cos(angle), 30 * std::sin(angle));
  }
  return text + "M99\n";
}

/// A loop that only sleeps until its next instant, and records its greatest lateness, s.
class IdleLoop {
 public:
  ~IdleLoop() {
    ends_ = true;
    thread_.join();
  }
  double late() const { return late_; }

 private:
  void run() {
    constexpr auto period = std::chrono::milliseconds(1);
    for (auto next = Clock::now(); !ends_;) {
      next += period;
      std::this_thread::sleep_until(next);
      if (const double late = since(next); late > late_) late_ = late;
    }
  }
  std::atomic<bool> ends_{false};
  std::atomic<double> late_{0};
  std::thread thread_{[this] { run(); }};
};

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60;
  const auto def = std::make_shared<const kadr::ControlDef>(kadr::load_control("mach3").value());
  const kadr::MachineProfile machine = kadr::load_machine("generic").value();
  const auto opens = [&](const std::optional<kadr::Axes>&,
                         const kadr::StopToken& stop) -> tl::expected<std::unique_ptr<kadr::Session>, std::string> {
    kadr::RunLimits limits;
    limits.stop = stop;
    auto session = kadr::Session::open({def, machine, {}, {"main.nc", kadr::text_source(rounds()), {}}, limits});
    if (!session) return tl::unexpected(session.error().fault.en);
    return std::move(*session);
  };
  auto made = kadr::PanelMachine::make(opens);
  if (!made || !(*made)->run()) {
    fmt::print("the machine does not run\n");
    return 2;
  }
  const auto begun = Clock::now();
  const IdleLoop idle, other;
  double reported = 10;
  std::uint64_t first = 0;
  while (since(begun) < seconds) {
    const kadr::PanelState state = (*made)->state();
    if (first == 0) first = state.sample.instant;
    if (state.mode != kadr::PanelMode::running) {
      fmt::print("the machine stands\n");
      return 2;
    }
    if (since(begun) > reported) {
      fmt::print("{:.0f} s: servo clock {:.3f} ms, idle loops {:.3f} ms, {:.3f} ms\n", reported, 1000 * state.sample.late,
                 1000 * idle.late(), 1000 * other.late());
      reported += 10;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  const kadr::ServoSample last = (*made)->state().sample;
  fmt::print("{:.0f} s, {} instants: greatest lateness of the servo clock {:.3f} ms, of the idle loops {:.3f} ms, {:.3f} ms\n",
             since(begun), last.instant - first, 1000 * last.late, 1000 * idle.late(), 1000 * other.late());
  return last.late > std::max(idle.late(), other.late()) + 1e-3 ? 1 : 0;
}
