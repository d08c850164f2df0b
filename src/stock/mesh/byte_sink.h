#pragma once
// ByteSink: the destination of a file that is written in portions: a temporary file, memory or a pipe.

#include <functional>
#include <string_view>

namespace kadr {

/// A function that receives the next bytes of the file.
///   returns  false if the bytes could not be written; the writer then does not call the sink again
using ByteSink = std::function<bool(std::string_view)>;

}  // namespace kadr
