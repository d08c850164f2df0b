#pragma once
// Computes the width of text in a picture without a font library. The layout is therefore the same on every computer, in SVG and in PNG.

#include <string>
#include <string_view>

namespace kadr {

/// Returns the width of UTF-8 text in the font DejaVu Sans of this size, in the unit of the size. Verdana is as wide, Arial is narrower.
/// For scripts other than ASCII and Russian the width is approximate.
double text_width(std::string_view text, double size);

/// Returns the text as valid UTF-8 for a picture. Control characters are replaced by their symbols (␀ …). Characters that XML forbids and
/// bytes that are not UTF-8 are replaced by �.
std::string printable(std::string_view text);

}  // namespace kadr
