// Finds the blank of a turned part in the comments of its program. Used by cli/cut_guess and view/page; tested by
// tests/session/stated_blank_test.cpp.

#include "session/cutting/turning/stated_blank.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double face_allowance = 1;     // mm; thickness of the material on the face of the part
constexpr double least_grip = 20;        // mm; the jaws hold at least this length
constexpr double whole_mm_noise = 1e-3;  // mm; a size this little above a whole number is that number

double whole_mm_below(double value) { return std::floor(value + whole_mm_noise) + 0.0; }
double whole_mm_above(double value) { return std::ceil(value - whole_mm_noise) + 0.0; }

/// Returns a number without the noise of a conversion from inches.
std::string plain_number(double value) { return fmt::format("{:g}", std::round(value * 1e4) / 1e4); }

void fill_sizes(StockComment& size, const StockComment& by) {
  if (!size.bore && by.bore && *by.bore < *size.diameter) size.bore = by.bore;
  if (!size.length) size.length = by.length;
}

}  // namespace

std::optional<StatedBlank> stated_blank(const ProgramLines& lines, bool inch) {
  std::optional<StatedBlank> stated;
  std::vector<StockComment> others;
  const auto take = [&](std::uint32_t line, const std::string& text) {
    const StockComment size = read_stock_comment(text, inch);
    if (size.diameter && !stated) stated = StatedBlank{size, line, text};
    else if (!size.diameter && !size.empty()) others.push_back(size);
  };
  for (const auto& [line, text] : lines) {
    if (const std::string billet = billet_of(text); !billet.empty()) take(line, billet);
    for (const std::string& comment : comments_of(text)) take(line, comment);
  }
  if (stated)
    for (const StockComment& other : others) fill_sizes(stated->size, other);
  return stated;
}

std::string turned_blank_text(const TurnedHints& hints, const TurnedExtents& path, double margin) {
  const std::optional<StatedBlank>& stated = hints.stated;
  const double lowest = std::min(path.bottom - margin, hints.chuck_face ? *hints.chuck_face - least_grip : path.bottom);
  const double diameter = stated ? *stated->size.diameter : 2 * whole_mm_above(path.radius);
  const double top = path.top > 0 && path.bottom < 0 ? face_allowance : whole_mm_above(path.top);
  const double bottom = stated && stated->size.length ? top - *stated->size.length : whole_mm_below(lowest);
  std::string text = fmt::format("cylinder:0,0,{},{},{}", plain_number(bottom), plain_number(top), plain_number(diameter));
  if (stated && stated->size.bore) text += "," + plain_number(*stated->size.bore);
  return text;
}

}  // namespace kadr
