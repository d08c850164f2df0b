#pragma once
// The HTML viewer of a report and the licence texts. dev/embed.cpp embeds these files into the executable.

#include <string_view>

#include "config/embedded.h"

namespace kadr {

/// Returns the embedded files "report.html" and "licences.txt". The file "report.html" is missing if npm was not available when Kadr was
/// built.
std::span<const EmbeddedFile> report_files();

/// Returns the contents of the embedded file; empty if the file is missing.
inline std::string_view report_file(std::string_view name) {
  for (const EmbeddedFile& file : report_files())
    if (file.name == name) return file.text;
  return {};
}

}  // namespace kadr
