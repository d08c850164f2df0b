#pragma once
// Computes the width of text in a picture without a font library, so that the layout is the same on every machine, in SVG and in PNG.

#include <string>
#include <string_view>

namespace kadr {

/// Returns the width of UTF-8 text in DejaVu Sans of this font size (Verdana is as wide, Arial narrower); approximate for scripts other
/// than ASCII and Russian.
double text_width(std::string_view text, double size);

/// Returns the text as valid UTF-8 for a picture. Control characters become their symbols (␀ …); characters that XML forbids and bytes
/// that are not UTF-8 become �.
std::string printable(std::string_view text);

}  // namespace kadr
