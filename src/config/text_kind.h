#pragma once
// Classifies the text of a file before any control is considered: blocks, prose, or no text at all.

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

enum class TextKind : std::uint8_t { program, prose, binary, empty };

struct KindOfText {
  TextKind kind = TextKind::program;
  std::string found;       // for prose: the first line of the text that is not a block
  std::uint32_t line = 0;  // number of this line, from 1; 0: no particular line
};

/// `sample`: the start of a file, UTF-8. INFERRED: a text is prose if less than half of its lines start like blocks.
KindOfText kind_of_text(std::string_view sample);

/// Returns a line in upper case, without comments in brackets and surrounding blanks.
std::string bare_line(std::string_view line);

}  // namespace kadr
