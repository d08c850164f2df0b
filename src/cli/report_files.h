#pragma once
// The viewer of a report and the licence notices, embedded by dev/embed.cpp.

#include <string_view>

#include "config/embedded.h"

namespace kadr {

/// "report.html", which is missing if there was no npm at build time, and "licences.txt".
std::span<const EmbeddedFile> report_files();

/// Returns an empty text if the file is missing.
inline std::string_view report_file(std::string_view name) {
  for (const EmbeddedFile& file : report_files())
    if (file.name == name) return file.text;
  return {};
}

}  // namespace kadr
