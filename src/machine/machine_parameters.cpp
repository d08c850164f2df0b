// Reads the parameters that the machine itself obeys (nct 4.1.1, 22): safety zones, in-position windows. Used by machine/zones.

#include "machine/machine_parameters.h"

#include <algorithm>

#include "config/setup/setup_parameters.h"

namespace kadr {

MachineParameters machine_parameters(const Setup& setup, const std::vector<std::string>& axes) {
  MachineParameters p;
  const SetupParameters given(setup, axes);
  p.outside_forbidden = given.of_channel("1001", {0, "EXT"});
  p.zone2_on = given.of_channel("1001", {1, "STE"});
  p.checks_before = given.of_channel("1001", {2, "CBM"});
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a) {
    if (given.of_axis("1000", a, {1, "RE2"})) p.zone2_axes |= 1U << a;
    if (given.of_axis("1000", a, {2, "RE3"})) p.zone3_axes |= 1U << a;
    p.zone2_most[a] = given.of_axis("1006", a);
    p.zone2_least[a] = given.of_axis("1007", a);
    p.in_position[a] = given.of_axis("0516", a);
    const double master = given.of_axis("2101", a) - static_cast<double>(given.first_axis());
    if (!given.of_axis("2102", a, {4, "PSN"}) || !(master >= 0 && master < static_cast<double>(axes.size()))) continue;
    p.gantry |= 1U << a;
    p.gantry_master[a] = static_cast<std::size_t>(master);
  }
  return p;
}

}  // namespace kadr
