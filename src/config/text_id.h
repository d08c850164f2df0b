#pragma once
// The types of the constants that name texts (config/texts.h). This header includes no other header of Kadr, so headers of the library may
// include it.

#include <cstddef>
#include <cstdint>

namespace kadr {

/// Names a text that has `Holes` placeholders {}, so a call must pass as many arguments.
template <std::size_t Holes>
struct TextId {
  std::uint16_t section = 0, row = 0;
};

/// Names a text whose form depends on a number. The number is the first argument, and `Holes` further arguments follow it.
template <std::size_t Holes>
struct PluralId {
  std::uint16_t section = 0, row = 0;
};

/// Names a text without placeholders. Tables of texts consist of such names.
using PlainText = TextId<0>;

}  // namespace kadr
