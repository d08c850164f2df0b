// Loads the library expat on demand. Used by stock/mesh/xml_scan.

#include "stock/mesh/expat_library.h"

namespace kadr {

const Expat* expat_library() {
  static const std::optional<Expat> opened =
      opened_library<Expat>("libexpat.so.1", [](Expat& library, [[maybe_unused]] const auto& find) { KADR_EXPAT(KADR_LIBRARY_FIND) });
  return opened ? &*opened : nullptr;
}

}  // namespace kadr
