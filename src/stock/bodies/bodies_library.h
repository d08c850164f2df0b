#pragma once
// kadr-bodies.so, opened when a machine with bodies is first asked for: no other command waits for it.

#include "stock/bodies/bodies_door.h"

namespace kadr {

/// Its door; opened by the first call, it stays so. It lies beside the program or the library that this is part of (a build), or in
/// lib/kadr of the installation.
///   returns  nullptr: it is not there, cannot be loaded, or is of another version
const KadrBodiesDoor* bodies_library();

}  // namespace kadr
