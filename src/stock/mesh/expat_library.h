#pragma once
// expat, opened when the first 3MF file is read: no other command waits for it.

#include <expat.h>

#include "stock/mesh/loaded_library.h"

namespace kadr {

// clang-format off
#define KADR_EXPAT(X) X(XML_ParserCreate) X(XML_ParserFree) X(XML_SetUserData) X(XML_SetElementHandler) X(XML_SetStartDoctypeDeclHandler) \
                      X(XML_Parse) X(XML_StopParser) X(XML_ResumeParser) X(XML_GetParsingStatus) X(XML_GetCurrentByteIndex) X(XML_GetErrorCode)
// clang-format on

/// The functions we call.
struct Expat {
  KADR_EXPAT(KADR_LIBRARY_FUNCTION)
};

/// The library; opened by the first call, it stays so.
///   returns  nullptr where this machine has none
const Expat* expat_library();

}  // namespace kadr
