#pragma once
// The settings of macros, derived from the parameters in the form the interpreter works with; derived again after a parameter was written
// (spec/nct/23, its parameter tables).

#include <array>
#include <functional>
#include <vector>

#include "control/macro_b/variables/parameters.h"

namespace kadr::macro_b {

/// A series of codes bound to programs: code start + k·step calls program + k.
struct CodeRun {
  double start = 0;
  double step = 1;
  int program = 0;
  int count = 0;
  bool modal = false;  // a negative start (23.3.4)
};

struct Settings {
  bool common_cleared = false;            // spec/fanuc 2.5: 6001#6 is 0: M2, M30 empty #100 to #199
  int protect_low = 0, protect_high = 0;  // N1702, N1703
  int shared_100 = 0, shared_500 = 0;     // N1700, N1701
  std::vector<CodeRun> g_macros, m_macros, m_programs;
  bool binds_codes = false;                     // any of these, or of the letters below
  std::array<bool, 5> letters_call{};           // N1746: A, B, C, S, T
  std::array<char, 4> ascii{};                  // N1747 …
  std::array<int, 4> ascii_programs{};          // N1751 …
  bool modal_each_block = false;                // N1755 #0 MEQ
  bool calls_inside_calls = false;              // N1755 #1 ENC
  bool lists_8000 = false, lists_9000 = false;  // N1756
  bool print_bare = false;                      // N1757 #0 PNT
  bool interrupts = false, interrupt_keeps_locals = false, interrupt_at_end = false, interrupt_edge = false;  // N1758 #0–#3
  bool interrupt_own_codes = false, interrupt_in_system = false;                                              // #4, #5
  int interrupt_on = 96, interrupt_off = 97;                                                                  // N1759, N1760
};

/// Gives access to parameters. `index`: axis, spindle or channel number from 1; 0: the own channel, or none.
struct ParameterSource {
  std::function<bool(const char* meaning)> has;  // the control has a parameter with that name of the engine
  std::function<double(const char* name, int index)> value;
  std::function<bool(const char* name, const char* bit, int index)> bit;
  std::function<char(const char* name, int index)> letter;  // 0: none
};

/// The source that reads a store: it finds rows by their names, or by the engine's name that another control's table gives them (`as`).
ParameterSource source_of(const ParameterStore& store);

/// The value as a whole number; 0 if it is out of range.
int whole_parameter(double value);

Settings read_settings(const ParameterSource& source);

}  // namespace kadr::macro_b
