#pragma once
// Loads zlib when the first 3MF file is read or written, so that no other command waits for it.

#include <zlib.h>

#include "stock/mesh/loaded_library.h"

namespace kadr {

// clang-format off
#define KADR_ZLIB(X) X(inflateInit2_) X(inflate) X(inflateEnd) X(deflateInit2_) X(deflate) X(deflateEnd) X(crc32)
// clang-format on

/// The functions that we call.
struct Zlib {
  KADR_ZLIB(KADR_LIBRARY_FUNCTION)
};

/// Returns the library. The first call loads it, and it stays loaded.
///   returns  nullptr if the machine does not have it
const Zlib* zlib_library();

}  // namespace kadr
