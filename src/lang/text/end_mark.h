#pragma once
// The text that marks the end of a block in a program for a Soviet control. ПС stands for «перевод строки», line feed (2С42 6.2). On a tape
// the character LF is used instead.

#include <string_view>

namespace kadr {

inline constexpr std::string_view end_mark_in_text = "ПС";

}  // namespace kadr
