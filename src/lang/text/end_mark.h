#pragma once
// The mark of the end of a block in the text of a program for a Soviet control: ПС, for «перевод строки», line feed (2С42 6.2). A tape has
// the character LF in its place.

#include <string_view>

namespace kadr {

inline constexpr std::string_view end_mark_in_text = "ПС";

}  // namespace kadr
