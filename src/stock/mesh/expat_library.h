#pragma once
// Loads the library expat when the first 3MF file is read, so that commands without such a file need not load it.

#include <expat.h>

#include "stock/mesh/loaded_library.h"

namespace kadr {

// clang-format off
#define KADR_EXPAT(X) X(XML_ParserCreate) X(XML_ParserFree) X(XML_SetUserData) X(XML_SetElementHandler) X(XML_SetStartDoctypeDeclHandler) \
                      X(XML_Parse) X(XML_StopParser) X(XML_ResumeParser) X(XML_GetParsingStatus) X(XML_GetCurrentByteIndex) X(XML_GetErrorCode)
// clang-format on

/// The functions of expat that this program calls.
struct Expat {
  KADR_EXPAT(KADR_LIBRARY_FUNCTION)
};

/// Returns the functions of the library. The first call loads the library, which then stays loaded.
///   returns  nullptr if the library is not installed
const Expat* expat_library();

}  // namespace kadr
