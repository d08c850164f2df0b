#pragma once
// The chuck and the tailstock of a lathe as bodies of revolution that tools must not touch. It is used by cli/cut.

#include <string>
#include <vector>

#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

struct HeldBody {
  std::string name;  // as findings name it
  TurnedRegion region;
};

/// Returns the chuck, if the machine describes it and the set-up states `chuck_face`, and the tailstock, if the set-up states `tailstock`.
/// The jaws grip the blank: the chuck has a bore of the blank's greatest radius behind its face, and spins with the part.
///   blank  in the work coordinates of the set-up's positions
std::vector<HeldBody> work_holding(const MachineProfile& machine, const Setup& setup, const TurnedRegion& blank);

}  // namespace kadr
