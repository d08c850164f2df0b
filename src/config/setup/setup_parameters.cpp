// Reads the values that the set-up states for parameters, of an axis of the channel or of the channel itself. Used by machine, motion.

#include "config/setup/setup_parameters.h"

#include "config/machine/machine_axes.h"

namespace kadr {

SetupParameters::SetupParameters(const Setup& setup, const std::vector<std::string>& axes)
    : setup_(setup), channel_{std::to_string(setup.channel), ""} {
  for (const auto& [channel, other] : setup.channels)
    if (channel < setup.channel) first_ += other.axes.empty() ? 3 : other.axes.size();
  std::size_t number = first_;
  for (const std::string& name : axes) axes_.push_back({name, std::to_string(number++), ""});
}

double SetupParameters::value(const char* parameter, const Indices& indices) const {
  for (const std::string& index : indices)
    if (setup_gives(setup_, parameter, index, "")) return setup_number(setup_, parameter, index);
  return 0;
}

bool SetupParameters::value(const char* parameter, const Indices& indices, ParameterBit bit) const {
  for (const std::string& index : indices) {
    for (const std::string& name : {std::to_string(bit.number), std::string(bit.name)})
      if (setup_gives(setup_, parameter, index, name)) return setup_number(setup_, parameter, index, name) != 0;
    if (setup_gives(setup_, parameter, index, ""))
      return (static_cast<unsigned>(setup_number(setup_, parameter, index)) >> bit.number & 1U) != 0;
  }
  return false;
}

}  // namespace kadr
