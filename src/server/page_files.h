#pragma once
// This file gives access to the files of the built page, which dev/embed.cpp embeds in the program.

#include <string_view>

#include "config/embedded.h"

namespace kadr {

/// Returns the embedded files. Their names are relative to the page's folder: "index.html". The list is empty if npm was missing when the
/// program was built: such a program has no page.
std::span<const EmbeddedFile> page_files();

/// Returns the content type of a file, which depends on the ending of the file's name.
std::string_view content_type(std::string_view name);

}  // namespace kadr
