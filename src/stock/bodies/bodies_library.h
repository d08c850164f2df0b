#pragma once
// Loads kadr-bodies.so when a machine with bodies is first used, so that no other command waits for it.

#include "stock/bodies/bodies_door.h"

namespace kadr {

/// Returns the module's interface. The first call loads the module, which then stays loaded. It is next to the program or the library
/// that contains this code (in a build), or in lib/kadr/modules of the installation.
///   returns  nullptr if the file is missing, cannot be loaded, or has another version
const KadrBodiesDoor* bodies_library();

}  // namespace kadr
