// Finds the rectangular blank in the comments of a milling program, or in its statement BLK FORM, and places it. Used by view/stock_guess;
// tested by tests/session/stated_box_test.cpp.

#include "session/cutting/stated_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "lang/klartext/klartext_parser.h"

namespace kadr {
namespace {

constexpr double clearly_less =
    0.5;  // another order of the sizes counts if it leaves out less than this share of what the order before does
constexpr double equal_within = 0.01;  // mm; sizes that differ by less count as equal

/// An interval along one axis.
struct AxisSpan {
  double least, most;
};

/// Returns how far the cut reaches beyond a blank.
double out_of(AxisSpan blank, AxisSpan cut) { return std::max({0.0, blank.least - cut.least, cut.most - blank.most}); }

/// Where the zero of a program usually is along one axis: in the middle of the blank, at its lower or at its upper end.
std::array<AxisSpan, 3> usual_places(double size) { return {{{-size / 2, size / 2}, {0, size}, {-size, 0}}}; }

double middle_of_span(AxisSpan s) { return (s.least + s.most) / 2; }

/// Returns where a blank of these sizes lies along X and Y: where it holds most of the cut; else with the zero at the same place
/// along both axes; else nearest to the cut.
std::array<AxisSpan, 2> placed_sideways(const std::array<double, 3>& size, const std::array<AxisSpan, 2>& cut) {
  const auto x = usual_places(size[0]), y = usual_places(size[1]);
  std::array<std::size_t, 2> best = {0, 0};
  const auto lacks = [&](std::array<std::size_t, 2> at) { return out_of(x[at[0]], cut[0]) + out_of(y[at[1]], cut[1]); };
  const auto off = [&](std::array<std::size_t, 2> at) {
    return std::fabs(middle_of_span(x[at[0]]) - middle_of_span(cut[0])) + std::fabs(middle_of_span(y[at[1]]) - middle_of_span(cut[1]));
  };
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j) {
      const std::array<std::size_t, 2> at = {i, j};
      const double gain = lacks(best) - lacks(at);
      const bool is_alike = i == j, was_alike = best[0] == best[1];
      const bool is_nearer = is_alike == was_alike ? off(at) < off(best) - equal_within : is_alike;
      if (gain > equal_within || (gain > -equal_within && is_nearer)) best = at;
    }
  std::array<AxisSpan, 2> places = {x[best[0]], y[best[1]]};
  for (std::size_t d = 0; d < 2; ++d)
    if (out_of(places[d], cut[d]) > size[d] / 2) places[d] = {middle_of_span(cut[d]) - size[d] / 2, middle_of_span(cut[d]) + size[d] / 2};
  return places;
}

/// Returns the sizes along X, Y and Z. The order of the comment counts, unless the cut fits only another one.
std::array<double, 3> sizes_along_axes(const BoxComment& stated, const Box3& cut) {
  std::array<double, 3> size = stated.size;
  if (stated.has_axes) return size;
  const Vec3 wanted = cut.most - cut.least;
  const auto lacks = [&](const std::array<double, 3>& s) {
    return std::max(0.0, wanted.x - s[0]) + std::max(0.0, wanted.y - s[1]) + std::max(0.0, wanted.z - s[2]);
  };
  std::array<double, 3> best = size;
  if (lacks(size) <= equal_within) return size;
  for (const auto& order : {std::array{1, 0, 2}, std::array{1, 2, 0}, std::array{2, 1, 0}, std::array{0, 2, 1}, std::array{2, 0, 1}}) {
    const std::array<double, 3> other = {size[std::size_t(order[0])], size[std::size_t(order[1])], size[std::size_t(order[2])]};
    if (lacks(other) < lacks(best) * clearly_less) best = other;
  }
  return best;
}

/// A line of the statement BLK FORM of a conversational program.
struct FormLine {
  int part = 0;  // 1: least corner, 2: greatest corner, 0: another form
  std::array<double, 3> corner{};
  std::array<bool, 3> incremental{};  // from the least corner
};

/// Reads BLK FORM 0.1 or 0.2 with three plain numbers; nullopt if the line is none of them.
std::optional<FormLine> form_line(std::string_view line) {
  const std::size_t begin = line.find("BLK FORM");
  if (begin == std::string_view::npos || line.find(';') < begin) return std::nullopt;
  const auto end = static_cast<std::uint32_t>(std::min(line.find(';'), line.size()));
  const auto read = read_klartext_block(line, {static_cast<std::uint32_t>(begin), end});
  if (!read || read->kind != KlartextKind::blank_form || read->part < 1 || read->part > 2) return std::nullopt;
  FormLine of{read->part};
  std::array<bool, 3> has{};
  for (const KlartextWord& word : read->words)
    for (std::size_t d = 0; d < 3; ++d)
      if (word.name == word_name(std::string_view("XYZ").substr(d, 1)) && !word.value)
        of.corner[d] = word.number, of.incremental[d] = word.incremental, has[d] = true;
  return has[0] && has[1] && has[2] ? std::optional(of) : std::nullopt;
}

/// Reads BLK FORM CYLINDER Z R50 L105 DIST+5: a cylinder whose upper end is DIST above the zero (INFERRED); nullopt for another line, and
/// for a tube.
std::optional<StatedBox> form_cylinder(std::string_view line, std::uint32_t number, double scale) {
  const std::size_t begin = line.find("BLK FORM");
  if (begin == std::string_view::npos || line.find(';') < begin) return std::nullopt;
  const auto end = static_cast<std::uint32_t>(std::min(line.find(';'), line.size()));
  const auto read = read_klartext_block(line, {static_cast<std::uint32_t>(begin), end});
  if (!read || read->kind != KlartextKind::blank_form || read->part != 3 || read->name != "Z" || read->find("RI") != nullptr)
    return std::nullopt;
  const auto of = [&](std::string_view name) {
    const KlartextWord* const word = read->find(name);
    return word == nullptr || word->value ? 0 : scale * word->number;
  };
  const double radius = of("R"), length = of("L"), top = of("DIST");
  if (!(radius > 0) || !(length > 0)) return std::nullopt;
  StatedBox made{{}, number, std::string(line.substr(begin))};
  made.size.size = {2 * radius, 2 * radius, length};
  made.size.has_axes = true;
  made.size.zero = {radius, radius, length - top};
  made.cylinder = {2 * radius, top - length, top};
  return made;
}

/// Returns the blank of BLK FORM 0.1 and 0.2 (spec/heidenhain 2); nullopt if the program has none or computes its corners.
std::optional<StatedBox> blank_form(const ProgramLines& lines) {
  constexpr double mm_per_inch = 25.4;
  double scale = 1;
  std::optional<FormLine> least;
  for (const auto& [line, text] : lines) {
    if (text.find("BEGIN PGM") != std::string::npos) scale = text.find(" INCH") == std::string::npos ? 1 : mm_per_inch;
    if (auto cylinder = form_cylinder(text, line, scale)) return cylinder;
    const auto form = form_line(text);
    if (!form) continue;
    if (form->part == 1) {
      least = form;
      continue;
    }
    if (!least) return std::nullopt;
    StatedBox box{{}, line, text.substr(text.find("BLK FORM"))};
    box.size.has_axes = true;
    box.size.zero.emplace();
    for (std::size_t d = 0; d < 3; ++d) {
      box.size.size[d] = scale * (form->corner[d] - (form->incremental[d] ? 0 : least->corner[d]));
      (*box.size.zero)[d] = -scale * least->corner[d];
      if (!(box.size.size[d] > 0)) return std::nullopt;
    }
    return box;
  }
  return std::nullopt;
}

}  // namespace

std::optional<StatedBox> stated_box(const ProgramLines& lines, bool inch) {
  if (auto form = blank_form(lines)) return form;
  bool after_heading = false;
  std::string heading;
  for (const auto& [line, text] : lines)
    for (const std::string& comment : comments_of(text)) {
      if (const auto size = read_box_comment(comment, inch)) return StatedBox{*size, line, comment};
      if (after_heading)
        if (const auto size = read_box_comment(heading + " " + comment, inch)) return StatedBox{*size, line, heading + ": " + comment};
      after_heading = is_heading_of_box(comment);
      heading = comment;
    }
  return std::nullopt;
}

Box3 placed_box(const BoxComment& stated, const Box3& cut, double top) {
  const std::array<double, 3> size = sizes_along_axes(stated, cut);
  if (stated.zero) {
    const auto& zero = *stated.zero;
    return {{-zero[0], -zero[1], -zero[2]}, {size[0] - zero[0], size[1] - zero[1], size[2] - zero[2]}};
  }
  const auto [x, y] = placed_sideways(size, {{{cut.least.x, cut.most.x}, {cut.least.y, cut.most.y}}});
  const bool stands_on_zero = top > equal_within && top <= size[2] + equal_within && cut.least.z > -size[2] / 2;
  const double upper = stands_on_zero ? size[2] : std::fabs(top) <= equal_within ? 0 : top;
  return {{x.least, y.least, upper - size[2]}, {x.most, y.most, upper}};
}

}  // namespace kadr
