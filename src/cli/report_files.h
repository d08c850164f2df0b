#pragma once
// The viewer of a report and the notices of licences, embedded by dev/embed.cpp.

#include <string_view>

#include "config/embedded.h"

namespace kadr {

/// "report.html", which is missing where there was no npm, and "licences.txt".
std::span<const EmbeddedFile> report_files();

/// Empty: it is not there.
inline std::string_view report_file(std::string_view name) {
  for (const EmbeddedFile& file : report_files())
    if (file.name == name) return file.text;
  return {};
}

}  // namespace kadr
