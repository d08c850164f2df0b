#pragma once
// The settings of custom macros, derived from the parameters of the control (spec/nct/23, its parameter tables) in the form that the
// interpreter uses. A write to a parameter derives them again.

#include <array>
#include <functional>
#include <vector>

#include "control/macro_b/variables/parameters.h"

namespace kadr::macro_b {

/// A series of G or M codes bound to programs: for k = 0 … count − 1, code number start + k·step calls program number program + k.
struct CodeRun {
  double start = 0;
  double step = 1;
  int program = 0;
  int count = 0;
  bool modal = false;  // the call by the code is modal, because the parameter that gives the first code is negative (23.3.4)
};

struct Settings {
  bool common_cleared = false;            // parameter 6001#6 is 0: M2 and M30 make #100 to #199 vacant (spec/fanuc 2.5)
  int protect_low = 0, protect_high = 0;  // N1702, N1703: first and last write-protected variable
  int shared_100 = 0, shared_500 = 0;     // N1700, N1701: number of variables from #100 and from #500 on that the channels share
  std::vector<CodeRun> g_macros, m_macros, m_programs;
  bool binds_codes = false;                     // a program is bound to at least one G code, M code or letter
  std::array<bool, 5> letters_call{};           // N1746: for each of the words A, B, C, S, T, whether it calls a subprogram
  std::array<char, 4> ascii{};                  // N1747 …: up to four further letters whose words call a subprogram; 0: no letter
  std::array<int, 4> ascii_programs{};          // N1751 …: number of the program that each further letter calls
  bool modal_each_block = false;                // N1755 #0 MEQ
  bool calls_inside_calls = false;              // N1755 #1 ENC
  bool lists_8000 = false, lists_9000 = false;  // N1756
  bool print_bare = false;                      // N1757 #0 PNT
  bool interrupts = false, interrupt_keeps_locals = false, interrupt_at_end = false, interrupt_edge = false;  // N1758 #0–#3
  bool interrupt_own_codes = false, interrupt_in_system = false;                                              // #4, #5
  int interrupt_on = 96, interrupt_off = 97;  // N1759, N1760: M codes that enable and disable the interrupt macro
};

/// Functions that read parameters. `index`: number of the axis, spindle or channel, from 1; 0 means the channel of the store, or the only
/// value of a global parameter.
struct ParameterSource {
  std::function<bool(const char* meaning)> has;  // true if the control has a parameter that Kadr knows by this name
  std::function<double(const char* name, int index)> value;
  std::function<bool(const char* name, const char* bit, int index)> bit;
  std::function<char(const char* name, int index)> letter;  // value of a text parameter of one letter; 0 if the parameter is empty
};

/// Returns a source that reads a ParameterStore. The source finds a row by the name of the parameter, or by Kadr's name for the parameter,
/// which the tables of other controls give in the key `as`.
ParameterSource source_of(const ParameterStore& store);

/// Converts a parameter value to an int; returns 0 if the value is out of range.
int whole_parameter(double value);

Settings read_settings(const ParameterSource& source);

}  // namespace kadr::macro_b
