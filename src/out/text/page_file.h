#pragma once
// Draws a page into an SVG or PNG file, or into memory.

#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "out/picture/svg_canvas.h"
#include "out/trace/result_file.h"

namespace kadr {

/// Draws the page; the ending of the file's name (.svg, .png) selects the format. `width` and `height` are those of the page, in its
/// units. The caller calls ResultFile::keep().
///   returns  an error sentence
tl::expected<void, std::string> write_page(const ResultFile& file, double width, double height, const PageText& says,
                                           const std::function<void(Canvas&)>& draw);

/// Returns the page as SVG; empty if memory ran out.
std::string svg_page(double width, double height, const PageText& says, const std::function<void(Canvas&)>& draw);

/// True if the name ends in .svg or .png.
bool is_page_name(const std::string& file);

/// Returns the reason why a page in this format cannot be drawn on this machine; empty if it can.
std::string page_fault(const std::string& file);

}  // namespace kadr
