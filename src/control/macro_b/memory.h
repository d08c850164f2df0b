#pragma once
// What a control with custom macros remembers between blocks: settings from parameters, modal calls, modal words, the state of statements.
// All of it is plain values, so that a snapshot and an alarm can copy it.

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
#include "control/state/state.h"
#include "control/variables/macro_variables.h"

namespace kadr::macro_b {

/// A modal macro call that has been programmed (23.3.2, 23.3.3).
struct ModalCall {
  std::uint16_t reader = 0;
  Position start;
  std::uint32_t times = 1;
  std::uint32_t name = 0;
  bool each_block = false;  // G66.1
  char called_by = 'G';
  std::int32_t called_code = -1;
  Locals arguments;
};

/// Values of the words last programmed, and related data, as #4101 … show them (23.1.14).
struct ModalWords {
  std::array<double, 3> aux{};
  double d = 0, e = 0, f = 0, h = 0, m = 0, n = 0, o = 0, s = 0, t = 0;
  double extended_zero = 0;
};

enum class DataMode : std::uint8_t { none, parameters, tools };

/// Macro state besides ControlState. An alarm restores it as one value.
struct Volatile {
  ModalWords words;
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;  // how many of modal_calls act on the blocks being executed
  DataMode data_mode = DataMode::none;
  std::optional<ProgramPlace> interrupt_program;  // M96
  double parts_done = 0;
};

inline constexpr std::string_view interrupt_signal = "CP_MINT";
inline constexpr std::size_t basic_systems = 6;  // number of basic work offsets: G54 … G59

/// A word that calls a subprogram after its block: T, S, A, B, C, M or an ASCII letter (23.3.6–23.3.8).
struct PendingCall {
  int program = 0;
  char letter = 0;
  std::int32_t code = -1;
  Span where;
};

/// What the end of an interrupt macro restores (23.4): the modal state and the modal calls of G66.
struct Interrupted {
  bool active = false;
  Modal modal;
  ModalWords words;
  Transform transform;
  std::vector<ModalCall> modal_calls;
  std::uint8_t active_modal_calls = 0;
};

/// All macro state that is a plain value: a snapshot copies it.
struct Memory {
  Settings settings;
  Volatile state;
  Programs programs;
  std::vector<std::pair<std::size_t, Locals>> repeated_arguments;  // by depth of the call; only calls that repeat
  Interrupted interrupted;
  bool signal_rose = false;               // CP_MINT has risen since it was last read
  std::map<std::string, double> signals;  // set by the machine's logic
  bool single_block = false;              // the operator's switch
  std::uint8_t stop_group = 0;            // modal group of G61 … G64
  std::int16_t inhibiting = -1;           // row of G63, which inhibits single-block stops
  // ---- of the block being executed
  bool was_hidden = false;     // the block is in a program that is not listed (23.3.9)
  bool moved = false;          // the block commanded a movement
  bool stops_reading = false;  // the block empties the look-ahead buffer
  std::vector<PendingCall> pending;
  // ---- what system variables show
  std::array<double, 32> plc_in{}, plc_out{};
  std::array<double, 4> plc_in_word{}, plc_out_word{};
  std::uint32_t control_1 = 0, control_2 = 0;  // #3003, #3004
  double answer = 0;                           // #3107
  double parts_required = 0;
  double cutting_ms = 0, clock_offset_ms = 0;
  double now_ms = 0;                        // virtual time since power-on
  std::string clock;                        // "2014-05-18T15:32:41"
  std::map<double, double> variable_names;  // set by SETVN: number of the name → number of the variable (spec/fanuc 5.1)
  Changes changes;                          // for the state file
  Endless endless;
  std::uint64_t parameters_seen = 0;  // version of the parameters that `settings` was read from, plus 1
};

}  // namespace kadr::macro_b
