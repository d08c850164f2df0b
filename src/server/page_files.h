#pragma once
// The files of the built page, which dev/embed.cpp embeds in the program.

#include <string_view>

#include "config/embedded.h"

namespace kadr {

/// Returns the embedded files. Their names are relative to the page's folder: "index.html". Empty if npm was missing when the program was
/// built, since the program then has no page.
std::span<const EmbeddedFile> page_files();

/// Returns the content type for a file name, by its ending.
std::string_view content_type(std::string_view name);

}  // namespace kadr
