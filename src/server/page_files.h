#pragma once
// The files of the built page, embedded by dev/embed.cpp.

#include <string_view>

#include "config/embedded.h"

namespace kadr {

/// Names are relative to the page's folder: "index.html". Empty if the program was built without npm, and so without the page.
std::span<const EmbeddedFile> page_files();

/// Content type by the file's ending.
std::string_view content_type(std::string_view name);

}  // namespace kadr
