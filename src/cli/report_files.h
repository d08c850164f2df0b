#pragma once
// The HTML viewer of a report and the licence texts, embedded into the executable by dev/embed.cpp.

#include <string_view>

#include "config/embedded.h"

namespace kadr {

/// Returns "report.html", which is missing if npm was not available at build time, and "licences.txt".
std::span<const EmbeddedFile> report_files();

/// Returns the contents of the embedded file; empty if the file is missing.
inline std::string_view report_file(std::string_view name) {
  for (const EmbeddedFile& file : report_files())
    if (file.name == name) return file.text;
  return {};
}

}  // namespace kadr
