// Decides whether rapid motions are straight lines. Used by cli/cut; tested by tests/config/rapid_path_test.cpp.

#include "config/machine/rapid_path.h"

#include "config/setup/setup_parameters.h"

namespace kadr {
namespace {

/// The name under which the engine uses a parameter that makes rapid motions straight.
constexpr std::string_view straight = "rapids_straight";

}  // namespace

bool rapids_apart(const ControlDef& def, const Setup& setup, const std::vector<std::string>& axes) {
  const SetupParameters given(setup, axes);
  for (const ParameterRow& row : def.parameters)
    for (std::size_t k = 0; k < row.means.size(); ++k) {
      if (row.means[k] != straight) continue;
      const bool bits = row.type == ParameterType::bits;
      if (bits ? given.of_channel(row.name.c_str(), {int(k), row.bits[k].c_str()}) : given.of_channel(row.name.c_str()) != 0) return false;
    }
  return def.has_parameter(straight) || def.behaviour.rapids_apart ||
         // Bit ROL of the parameter N0421 of the NCT (nct 4.1.2; INFERRED: the number of the parameter, nct 4.1.1)
         given.of_channel("0421", {0, "ROL"});
}

}  // namespace kadr
