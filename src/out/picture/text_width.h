#pragma once
// Computes the width of a picture's texts without a font library: the layout is the same on every machine and in both file formats.

#include <string>
#include <string_view>

namespace kadr {

/// Returns the width of UTF-8 text in DejaVu Sans of that size (Verdana is as wide, Arial narrower); approximate for other scripts.
double text_width(std::string_view text, double size);

/// Returns UTF-8 that is fit for a picture: control characters as their pictures (␀ …); what XML does not allow, and what is not UTF-8, as
/// �.
std::string printable(std::string_view text);

}  // namespace kadr
