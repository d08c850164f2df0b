#pragma once
// A page into a file, SVG or PNG, or into memory.

#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "out/picture/svg_canvas.h"
#include "out/trace/result_file.h"

namespace kadr {

/// The ending of the name (.svg, .png) says which. `width`, `height`: of the page, in its units. The file is the caller's to keep.
///   returns  an error sentence
tl::expected<void, std::string> write_page(const ResultFile& file, double width, double height, const PageText& says,
                                           const std::function<void(Canvas&)>& draw);

/// The same as SVG in memory; empty: there was no room for it.
std::string svg_page(double width, double height, const PageText& says, const std::function<void(Canvas&)>& draw);

/// The name ends in one of those.
bool is_page_name(const std::string& file);

/// Why no page can be drawn here, or nothing.
std::string page_fault(const std::string& file);

}  // namespace kadr
