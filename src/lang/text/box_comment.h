#pragma once
// Reads the size of a rectangular blank from a comment: "(PLATE 120X80X25)", "(STOCK SIZE X=4. Y=3. Z=1.)", «ЗАГОТОВКА 120Х80Х25». It is
// used by session/cutting/stated_box. A person must check the result.

#include <array>
#include <optional>
#include <string_view>

namespace kadr {

struct BoxComment {
  std::array<double, 3> size{};                    // mm, as they are written
  bool has_axes = false;                           // true: the comment says which size lies along X, Y and Z
  std::optional<std::array<double, 3>> zero = {};  // program zero from the least corner, mm (CutViewer)
};

/// Returns the sizes of the blank that the comment states with certainty.
///   text  UTF-8, without its brackets
///   inch  true: numbers without a unit are in inches; fractions are always in inches
std::optional<BoxComment> read_box_comment(std::string_view text, bool inch);

/// True if the comment names the blank without a number, so that the next comment may state its size: "(Material size)", "(X= 120.0,
/// Y= 80.0, Z= 25.0)" of Vectric's programs.
bool is_heading_of_box(std::string_view text);

}  // namespace kadr
