// Loads the library zlib on demand. Used by stock/mesh/zip_read and zip_write.

#include "stock/mesh/zlib_library.h"

namespace kadr {

const Zlib* zlib_library() {
  static const std::optional<Zlib> opened =
      opened_library<Zlib>("libz.so.1", [](Zlib& library, [[maybe_unused]] const auto& find) { KADR_ZLIB(KADR_LIBRARY_FIND) });
  return opened ? &*opened : nullptr;
}

}  // namespace kadr
