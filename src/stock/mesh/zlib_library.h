#pragma once
// zlib, opened when the first 3MF file is read or written: no other command waits for it.

#include <zlib.h>

#include "stock/mesh/loaded_library.h"

namespace kadr {

// clang-format off
#define KADR_ZLIB(X) X(inflateInit2_) X(inflate) X(inflateEnd) X(deflateInit2_) X(deflate) X(deflateEnd) X(crc32)
// clang-format on

/// The functions we call.
struct Zlib {
  KADR_ZLIB(KADR_LIBRARY_FUNCTION)
};

/// The library; opened by the first call, it stays so.
///   returns  nullptr where this machine has none
const Zlib* zlib_library();

}  // namespace kadr
