#include "machine/machine_parameters.h"

#include <algorithm>
#include <array>
#include <optional>

#include "config/machine_axes.h"

namespace kadr {
namespace {

/// A bit by its number and its name.
struct Bit {
  int number;
  const char* name;
};

/// The ways to write an index, from the most particular on.
using Indices = std::vector<std::string>;

double value_of(const Setup& setup, const char* parameter, const Indices& indices) {
  for (const std::string& index : indices)
    if (setup_gives(setup, parameter, index, "")) return setup_number(setup, parameter, index);
  return 0;
}

bool bit_of(const Setup& setup, const char* parameter, const Indices& indices, Bit bit) {
  for (const std::string& index : indices) {
    for (const std::string& name : {std::to_string(bit.number), std::string(bit.name)})
      if (setup_gives(setup, parameter, index, name)) return setup_number(setup, parameter, index, name) != 0;
    if (setup_gives(setup, parameter, index, ""))
      return (static_cast<unsigned>(setup_number(setup, parameter, index)) >> bit.number & 1U) != 0;
  }
  return false;
}

/// Control-wide number of the channel's first axis: numbers run on through the channels (nct 1.2).
std::size_t first_number(const Setup& setup) {
  std::size_t number = 1;
  for (const auto& [channel, other] : setup.channels)
    if (channel < setup.channel) number += other.axes.empty() ? 3 : other.axes.size();
  return number;
}

}  // namespace

MachineParameters machine_parameters(const Setup& setup, const std::vector<std::string>& axes) {
  MachineParameters p;
  const Indices channel{std::to_string(setup.channel), ""};
  p.outside_forbidden = bit_of(setup, "1001", channel, {0, "EXT"});
  p.zone2_on = bit_of(setup, "1001", channel, {1, "STE"});
  p.checks_before = bit_of(setup, "1001", channel, {2, "CBM"});
  const std::size_t first = first_number(setup);
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a) {
    const Indices axis{axes[a], std::to_string(first + a), ""};
    if (bit_of(setup, "1000", axis, {1, "RE2"})) p.zone2_axes |= 1U << a;
    if (bit_of(setup, "1000", axis, {2, "RE3"})) p.zone3_axes |= 1U << a;
    p.zone2_most[a] = value_of(setup, "1006", axis);
    p.zone2_least[a] = value_of(setup, "1007", axis);
    p.in_position[a] = value_of(setup, "0516", axis);
  }
  return p;
}

}  // namespace kadr
