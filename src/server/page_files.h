#pragma once
// The built page, embedded by dev/embed.cpp.

#include <string_view>

#include "config/embedded.h"

namespace kadr {

/// Names from the page's folder on: "index.html". Empty: the program was built without it, where there was no npm.
std::span<const EmbeddedFile> page_files();

/// By its ending.
std::string_view content_type(std::string_view name);

}  // namespace kadr
