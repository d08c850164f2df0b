// Derives the settings of macros from the parameters. Used by control/macro_b/macro_b, control/fanuc/state/settings.

#include "control/macro_b/variables/settings.h"

#include <cmath>
#include <string>

namespace kadr::macro_b {

int whole_parameter(double value) { return std::fabs(value) < 1e9 ? static_cast<int>(std::lround(value)) : 0; }

ParameterSource source_of(const ParameterStore& store) {
  return {[&store](const char* name) { return store.meaning(name).row != ParameterId::none; },
          [&store](const char* name, int index) {
            const ParameterStore::Meaning meant = store.meaning(name);
            if (meant.bit >= 0) return store.bit(meant.row, meant.bit, index) ? 1.0 : 0.0;
            return store.value(meant.row != ParameterId::none ? meant.row : store.named(name), index);
          },
          [&store](const char* name, const char* bit, int index) {
            const ParameterStore::Meaning meant = store.meaning(std::string(name) + '#' + bit);
            if (meant.row != ParameterId::none)
              return meant.bit < 0 ? store.value(meant.row, index) != 0 : store.bit(meant.row, meant.bit, index);
            const ParameterId id = store.named(name);
            const bool digit = bit[0] >= '0' && bit[0] <= '9' && bit[1] == '\0';
            const int number = digit ? bit[0] - '0' : store.bit_named(id, bit);
            return number >= 0 && store.bit(id, number, index);
          },
          [&store](const char* name, int index) {
            const std::string text = store.text(store.named(name), index);
            return text.size() == 1 && text[0] >= 'A' && text[0] <= 'Z' ? text[0] : '\0';
          }};
}

namespace {

/// Adds codes that parameters bind to programs one by one: for k = 0 … count − 1, the value of parameter `from` + k is the code that calls
/// program `program` + k. The value 0 means that no code calls the program; 1000 means G0 (23.3.4).
void single_codes(std::vector<CodeRun>& runs, const ParameterSource& p, int from, int count, int program) {
  for (int k = 0; k < count; ++k) {
    const double value = p.value(std::to_string(from + k).c_str(), 0);
    if (value == 0) continue;
    const double code = std::fabs(value) == 1000 ? 0 : std::fabs(value);
    runs.push_back({code, 1, program + k, 1, value < 0});
  }
}

void code_block(std::vector<CodeRun>& runs, const ParameterSource& p, int from, double step) {
  const double start = p.value(std::to_string(from).c_str(), 0);
  const int count = whole_parameter(p.value(std::to_string(from + 2).c_str(), 0));
  if (count > 0) runs.push_back({std::fabs(start), step, whole_parameter(p.value(std::to_string(from + 1).c_str(), 0)), count, start < 0});
}

void read_macros(Settings& s, const ParameterSource& p) {
  s.common_cleared = p.has("common_kept") && p.value("common_kept", 0) == 0;
  s.shared_100 = whole_parameter(p.value("1700", 0));
  s.shared_500 = whole_parameter(p.value("1701", 0));
  s.protect_low = whole_parameter(p.value("1702", 0));
  s.protect_high = whole_parameter(p.value("1703", 0));
  single_codes(s.g_macros, p, 1704, 10, 9010);
  code_block(s.g_macros, p, 1714, 1);
  code_block(s.g_macros, p, 1717, 0.1);
  single_codes(s.m_programs, p, 1720, 10, 9000);
  code_block(s.m_programs, p, 1730, 1);
  single_codes(s.m_macros, p, 1733, 10, 9020);
  code_block(s.m_macros, p, 1743, 1);
  for (std::size_t i = 0; i < 5; ++i) s.letters_call[i] = p.bit("1746", std::to_string(i).c_str(), 0);
  s.binds_codes = !s.g_macros.empty() || !s.m_macros.empty() || !s.m_programs.empty();
  for (const bool calls : s.letters_call) s.binds_codes = s.binds_codes || calls;
  for (std::size_t i = 0; i < 4; ++i) {
    s.ascii[i] = p.letter(std::to_string(1747 + i).c_str(), 0);
    s.ascii_programs[i] = whole_parameter(p.value(std::to_string(1751 + i).c_str(), 0));
    s.binds_codes = s.binds_codes || s.ascii[i] != 0;
  }
  s.modal_each_block = p.bit("1755", "0", 0);
  s.calls_inside_calls = p.bit("1755", "1", 0);
  s.lists_8000 = p.bit("1756", "0", 0);
  s.lists_9000 = p.bit("1756", "1", 0);
  s.print_bare = p.bit("1757", "0", 0);
  s.interrupts = p.bit("1758", "0", 0);
  s.interrupt_keeps_locals = p.bit("1758", "1", 0);
  s.interrupt_at_end = p.bit("1758", "2", 0);
  s.interrupt_edge = p.bit("1758", "3", 0);
  s.interrupt_own_codes = p.bit("1758", "4", 0);
  s.interrupt_in_system = p.bit("1758", "5", 0);
  if (s.interrupt_own_codes) {
    s.interrupt_on = whole_parameter(p.value("1759", 0));
    s.interrupt_off = whole_parameter(p.value("1760", 0));
  }
}

}  // namespace

Settings read_settings(const ParameterSource& source) {
  Settings s;
  read_macros(s, source);
  return s;
}

}  // namespace kadr::macro_b
