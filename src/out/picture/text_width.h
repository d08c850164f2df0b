#pragma once
// How wide a text of a picture is, without asking a library for fonts: the layout is the same on every machine and in both file forms.

#include <string>
#include <string_view>

namespace kadr {

/// Width of UTF-8 text set in DejaVu Sans (Verdana is as wide, Arial narrower) of that size; other scripts: about.
double text_width(std::string_view text, double size);

/// UTF-8 fit for a picture: control characters as their signs (␀ …), what is no character of XML, or no UTF-8, as �.
std::string printable(std::string_view text);

}  // namespace kadr
