#pragma once
// The types of the constants that name texts (config/texts.h). This header needs no other, so headers of the library may use it.

#include <cstddef>
#include <cstdint>

namespace kadr {

/// Names a text that wants `Holes` arguments for its placeholders {}.
template <std::size_t Holes>
struct TextId {
  std::uint16_t section = 0, row = 0;
};

/// Names a text whose form depends on a number, its first argument; `Holes` further arguments follow.
template <std::size_t Holes>
struct PluralId {
  std::uint16_t section = 0, row = 0;
};

/// Names a text without placeholders; tables of texts consist of these.
using PlainText = TextId<0>;

}  // namespace kadr
