// Fuzz target for a user's own control: random control files (own_control.h) and programs that use their codes. Every file that the
// loader accepts must run any program, with or without alarms. An input that consists of a control file and a program as text, separated
// by a line `----`, is used unchanged, so that a finding can be saved in readable form.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "own_control.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kadr::fuzz;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  constexpr std::string_view border = "\n----\n";
  if (const std::size_t at = text.find(border); at != std::string_view::npos) {
    try_own(std::string(text.substr(0, at + 1)), std::string(text.substr(at + border.size())), 0);
    return 0;
  }
  Dice dice(data, size);
  const unsigned switches = static_cast<unsigned>(dice.below(64)) & ~static_cast<unsigned>(as_cp1251);
  const std::string_view base = dice.of(bases);
  const std::string_view function = dice.one_in(3) ? std::string_view() : some_function(dice);
  const std::string file = control_file(dice, base, function);
  try_own(file, program_of(dice, dice.below(24) + 4), switches);
  return 0;
}
