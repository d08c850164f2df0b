#pragma once
// Loads kadr-bodies.so when a machine with solid bodies is first used, so that commands without such a machine need not load it.

#include "stock/bodies/bodies_interface.h"

namespace kadr {

/// Returns the module's interface. The first call loads the module, which then stays loaded. The module is in the directory of the
/// program or library that contains this code (in a build), or in lib/kadr/modules of the installation.
///   returns  nullptr if the file is missing, cannot be loaded, or has another version
const KadrBodiesInterface* bodies_library();

}  // namespace kadr
