#pragma once
// The faults of a conversation with a controller, in words.

#include <string>

#include "drive/grbl/grbl_link.h"

namespace kadr::drive {

/// Returns a fault as a sentence in the language of the thread.
///   seconds  how long the machine may still move, s
std::string fault_text(const LinkEvent& fault, double seconds);

}  // namespace kadr::drive
