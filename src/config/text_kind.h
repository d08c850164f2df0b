#pragma once
// What kind of text a file holds, before anybody asks for which control: blocks, prose, or no text at all.

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

enum class TextKind : std::uint8_t { program, prose, binary, empty };

struct KindOfText {
  TextKind kind = TextKind::program;
  std::string found;       // of prose: its first line that is no block
  std::uint32_t line = 0;  // where, from 1; 0: nowhere in particular
};

/// `sample`: the beginning of a file, UTF-8. INFERRED: a text of which less than half of the lines begin like blocks is prose.
KindOfText kind_of_text(std::string_view sample);

/// A line without its comments in brackets and the blanks around it, in capitals.
std::string bare_line(std::string_view line);

}  // namespace kadr
