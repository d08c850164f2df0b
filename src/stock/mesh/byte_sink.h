#pragma once
// Where a written file goes, piece by piece: a file beside its place, memory, a pipe.

#include <functional>
#include <string_view>

namespace kadr {

/// Takes the next bytes.
///   returns  false: it could not; nothing more comes
using ByteSink = std::function<bool(std::string_view)>;

}  // namespace kadr
