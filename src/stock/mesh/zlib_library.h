#pragma once
// Loads the library zlib when the first 3MF file is read or written, so that commands without such a file need not load it.

#include <zlib.h>

#include "stock/mesh/loaded_library.h"

namespace kadr {

// clang-format off
#define KADR_ZLIB(X) X(inflateInit2_) X(inflate) X(inflateEnd) X(deflateInit2_) X(deflate) X(deflateEnd) X(crc32)
// clang-format on

/// The functions of zlib that this program calls.
struct Zlib {
  KADR_ZLIB(KADR_LIBRARY_FUNCTION)
};

/// Returns the functions of the library. The first call loads the library, which then stays loaded.
///   returns  nullptr if the library is not installed
const Zlib* zlib_library();

}  // namespace kadr
