#pragma once
// The assertion that all fuzz targets use: an invariant that is violated is a finding.

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "lang/text/encoding.h"

namespace kadr::fuzz {

/// Aborts if `holds` is false. `what` is the sentence that does not hold, for the reader of the log.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

inline bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = first_character(text).size;
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

}  // namespace kadr::fuzz
