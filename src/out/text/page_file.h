#pragma once
// Draws a page to an SVG or PNG file, or to memory.

#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "out/picture/svg_canvas.h"
#include "out/trace/result_file.h"

namespace kadr {

/// Draws the page. The ending of the file's name (.svg, .png) selects the format. `width`, `height`: size of the page, in its units.
/// Afterwards the caller must call ResultFile::keep().
///   returns  an error sentence if the page cannot be drawn
tl::expected<void, std::string> write_page(const ResultFile& file, double width, double height, const PageText& page_text,
                                           const std::function<void(Canvas&)>& draw);

/// Returns the page as SVG; empty if the memory was not sufficient.
std::string svg_page(double width, double height, const PageText& page_text, const std::function<void(Canvas&)>& draw);

/// True if the file name ends in .svg or .png.
bool is_page_name(const std::string& file);

/// Returns the reason why this computer cannot draw a page in the format of the file name; empty if it can draw the page.
std::string page_fault(const std::string& file);

}  // namespace kadr
