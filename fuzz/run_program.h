#pragma once
// A complete run of a program as a fuzz target; the observer of fuzz/looks checks it. A hash of the text selects how the program is run:
// block by block, with the planner, stopped and continued from snapshots in the same or a new session, single-stepped, or searched from
// checkpoints; also on a machine with several channels. The first byte of the input contains the switches below, the rest is the program.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "config/control/control_file.h"
#include "config/machine/machine_profile.h"
#include "control/control.h"
#include "out/text/alarm_print.h"
#include "require.h"

namespace kadr::fuzz {

inline const RunLimits few_passes{2000, 5};

/// Switches in the first byte; '@' has none of them.
enum : unsigned { mirror_x = 1, mirror_y = 2, skip_blocks = 4, narrow_limits = 8, as_cp1251 = 16, machine_logic = 32 };

Setup some_setup(unsigned switches);

/// Data that all runs on one control share.
struct Shop {
  ControlDef def;
  AlarmTexts texts;
  MachineProfile profile;
  std::FILE* nowhere;
  std::string file = "fuzz.nc";
  RunLimits limits = few_passes;
  std::function<Setup(unsigned switches)> setup = some_setup;
  bool plain_frames = true;  // machine coordinates = work coordinates + origin + tool length in every motion
  std::function<void(Control&, const Origin&, bool at_end)>
      logic{};                   // machine logic, called around each block (nct) if the switch `machine_logic` is set
  std::string second_channel{};  // program of the second channel, if the machine has several

  static Shop open(const char* control) {
    auto def = load_control(control);
    require(def.has_value(), "the control's file is good");
    auto texts = AlarmTexts::load(&*def);
    require(texts.has_value(), "the alarm texts are good");
    return {.def = std::move(*def),
            .texts = std::move(*texts),
            .profile = std::move(*load_machine("generic")),
            .nowhere = std::fopen("/dev/null", "wb")};
  }
};

/// Runs the program and checks every result. `then` is called while the session still exists.
void run_text(const Shop& shop, const std::string& text, unsigned switches, const std::function<void()>& then = {});

inline int run_program(const Shop& shop, const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  run_text(shop, std::string(reinterpret_cast<const char*>(data) + 1, size - 1), data[0]);
  return 0;
}

}  // namespace kadr::fuzz
