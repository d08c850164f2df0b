#pragma once
// Classifies the text of a file, without regard to any control: blocks of a program, prose, or no text at all.

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

enum class TextKind : std::uint8_t { program, prose, binary, empty };

struct KindOfText {
  TextKind kind = TextKind::program;
  std::string found;       // for prose: the first line that is not a block
  std::uint32_t line = 0;  // line number of `found`, from 1; 0: the reason is no particular line
};

/// Classifies a text. `sample`: the start of a file, UTF-8. INFERRED: a text is prose if less than half of its lines start like blocks.
KindOfText kind_of_text(std::string_view sample);

/// Returns a line in upper case, without comments in brackets and without blanks at both ends.
std::string bare_line(std::string_view line);

}  // namespace kadr
