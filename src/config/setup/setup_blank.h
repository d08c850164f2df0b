#pragma once
// SetupBlank: the blank and the fixtures that a set-up states for kadr cut and for the page. A run of the program does not need them, so
// they are not part of Setup.

#include <string>
#include <string_view>
#include <vector>

namespace kadr {

struct SetupBlank {
  std::string stock;                  // as --stock takes it: "box:-60,-40,-25,60,40,0"; empty: the set-up states none
  std::vector<std::string> fixtures;  // as --fixture takes them
};

/// Returns what a set-up states of the blank. `json`: the text of a set-up that read_setup() accepts; anything else states nothing.
SetupBlank setup_blank(std::string_view json);

}  // namespace kadr
