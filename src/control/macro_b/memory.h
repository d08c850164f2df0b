#pragma once
// The state that a control with custom macros keeps between blocks: settings from parameters, modal calls, modal words, the state of
// statements. All are plain values, so that a snapshot can copy the state, and an alarm can restore a copy.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "control/macro_b/programs/programs.h"
#include "control/macro_b/statements/endless.h"
#include "control/macro_b/variables/changes.h"
#include "control/macro_b/variables/settings.h"
#include "control/state/control_state.h"
#include "control/variables/macro_variables.h"

namespace kadr::macro_b {

/// A modal macro call that has been programmed (23.3.2, 23.3.3).
struct ModalCall {
  std::uint16_t reader = 0;
  Position start;
  std::uint32_t times = 1;
  std::uint32_t name = 0;
  bool each_block = false;  // true: G66.1 calls the macro for each block; false: G66 calls it after each movement
  char called_by = 'G';
  std::int32_t called_code = -1;
  Locals arguments;
};

/// The values of the system variables from #4101 on: the words that were programmed last, and related data (23.1.14).
struct ModalWords {
  std::array<double, 3> aux{};
  double d = 0, e = 0, f = 0, h = 0, m = 0, n = 0, o = 0, s = 0, t = 0;
  double extended_zero = 0;
};

enum class DataMode : std::uint8_t { none, parameters, tools };

/// The macro state that a block can change, in addition to ControlState. An alarm restores it as one value.
struct UndoableState {
  ModalWords words;
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;  // number of entries of modal_calls that are in force
  DataMode data_mode = DataMode::none;
  std::optional<ProgramLocation> interrupt_program;  // the program that M96 has enabled as interrupt macro
  double parts_done = 0;
};

inline constexpr std::string_view interrupt_signal = "CP_MINT";
inline constexpr std::size_t basic_systems = 6;  // number of basic work offsets: G54 … G59

/// A call of a subprogram that a word has requested for the end of its block. The word is T, S, A, B, C, M or a letter bound by a parameter
/// (23.3.6–23.3.8).
struct PendingCall {
  int program = 0;
  char letter = 0;
  std::int32_t code = -1;
  Span where;
};

/// The state that the end of an interrupt macro restores (23.4): the modal state and the modal calls of G66.
struct Interrupted {
  bool active = false;
  Modal modal;
  ModalWords words;
  Transform transform;
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;
};

/// All macro state that is a plain value, so that a snapshot can copy it.
struct Memory {
  Settings settings;
  UndoableState state;
  Programs programs;
  std::vector<std::pair<std::size_t, Locals>> repeated_arguments;  // {call depth, arguments} of each open call that is repeated (L > 1)
  Interrupted interrupted;
  bool signal_rose = false;               // the signal CP_MINT has changed from 0 to 1 since it was last read
  std::map<std::string, double> signals;  // signals set by the machine logic (PLC), by name
  bool single_block = false;              // the operator's single-block switch is on
  std::uint8_t stop_group = 0;            // index of the modal group of G61 … G64
  std::int16_t inhibiting = -1;           // table row of G63, which suppresses single-block stops
  // ---- flags of the block being executed
  bool was_hidden = false;     // the block is in a program 8000 … 9999, which runs as one block (23.3.9)
  bool moved = false;          // the block commanded a movement
  bool stops_reading = false;  // the block empties the look-ahead buffer
  std::vector<PendingCall> pending;
  // ---- values that the program reads by system variables
  std::array<double, 32> plc_in{}, plc_out{};
  std::array<double, 4> plc_in_word{}, plc_out_word{};
  // values of #3003 and #3004, by which a program suppresses single-block stops, feed hold, override and exact stop
  std::uint32_t control_1 = 0, control_2 = 0;
  double answer = 0;  // the operator's answer to the question of #3107
  double parts_required = 0;
  double cutting_ms = 0, clock_offset_ms = 0;
  double now_ms = 0;                        // virtual time in ms since power-on
  std::string clock;                        // date and time of the set-up, such as "2014-05-18T15:32:41"
  std::map<double, double> variable_names;  // names given by SETVN: internal number of the name → number of the variable (spec/fanuc 5.1)
  Changes changes;                          // values that have changed and must be saved to the state file
  Endless endless;
  std::uint64_t parameters_seen = 0;  // 1 + the version of the parameters from which `settings` was derived last
};

}  // namespace kadr::macro_b
