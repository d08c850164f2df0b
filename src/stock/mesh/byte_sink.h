#pragma once
// ByteSink: the destination of a file that is written piece by piece: a temporary file, memory or a pipe.

#include <functional>
#include <string_view>

namespace kadr {

/// Receives the next bytes.
///   returns  false if the bytes could not be written; the sink is then not called again
using ByteSink = std::function<bool(std::string_view)>;

}  // namespace kadr
