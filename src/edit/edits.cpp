// Reads the words that describe an edit. Used by cli/edit_command; tested by tests/edit.py.

#include "edit/edits.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/ascii.h"
#include "texts/edit.h"

namespace kadr {
namespace {

constexpr double least_percent = 1, most_percent = 1000;
constexpr std::uint32_t most_number = 99'999'999;
constexpr double most_shift = 100'000;  // mm
constexpr std::int32_t tenths = 10;
constexpr double percent = 100;

/// Reads a number from the start of the text and removes it from there; nullopt if the text does not start with a number.
template <class Number>
std::optional<Number> number_of(std::string_view& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end == text.data()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool take(std::string_view& text, char letter) {
  if (text.empty() || to_upper(text.front()) != letter) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<std::uint32_t> whole(std::string_view& text) {
  const auto value = number_of<std::uint32_t>(text);
  return value && *value <= most_number ? value : std::nullopt;
}

std::optional<SystemCode> system_of(std::string_view& text) {
  if (!take(text, 'G')) return std::nullopt;
  const auto number = whole(text);
  if (!number || *number > 999) return std::nullopt;
  SystemCode system{static_cast<std::int32_t>(*number) * tenths, {}};
  if (take(text, '.')) {
    const auto fraction = whole(text);
    if (!fraction || *fraction >= static_cast<std::uint32_t>(tenths)) return std::nullopt;
    system.code += static_cast<std::int32_t>(*fraction);
  }
  while (take(text, ' ')) {
  }
  if (take(text, 'P'))
    if (system.further = whole(text); !system.further) return std::nullopt;
  return system;
}

}  // namespace

double factor_for(const std::vector<Factor>& factors, std::uint32_t tool) {
  double all = 1;
  for (const Factor& one : factors) {
    if (one.tool == tool) return one.factor;
    if (!one.tool) all = one.factor;
  }
  return all;
}

tl::expected<Factor, std::string> read_factor(std::string_view text) {
  std::string_view rest = text;
  Factor made;
  bool right = true;
  if (take(rest, 'T')) {
    made.tool = whole(rest);
    right = made.tool && take(rest, '=');
  }
  const auto value = right ? number_of<double>(rest) : std::nullopt;
  if (!value || !take(rest, '%') || !rest.empty() || !(*value >= least_percent && *value <= most_percent))
    return tl::unexpected(translated(texts::edit::want_factor, text, least_percent, most_percent));
  made.factor = *value / percent;
  return made;
}

tl::expected<Numbering, std::string> read_numbering(std::string_view text) {
  std::string_view rest = text;
  const auto first = whole(rest);
  auto step = first;
  if (first && take(rest, ':')) step = whole(rest);
  if (!first || !step || *step == 0 || !rest.empty()) return tl::unexpected(translated(texts::edit::want_numbering, text));
  return Numbering{*first, *step};
}

tl::expected<std::pair<std::uint32_t, std::uint32_t>, std::string> read_tools(std::string_view text) {
  std::string_view rest = text;
  (void)take(rest, 'T');
  const auto from = whole(rest);
  const bool has_sign = take(rest, '=');
  (void)take(rest, 'T');
  const auto to = whole(rest);
  if (!from || !has_sign || !to || *from == 0 || *to == 0 || !rest.empty())
    return tl::unexpected(translated(texts::edit::want_tools, text));
  return std::pair(*from, *to);
}

tl::expected<std::pair<SystemCode, SystemCode>, std::string> read_systems(std::string_view text) {
  std::string_view rest = text;
  const auto from = system_of(rest);
  const bool has_sign = take(rest, '=');
  const auto to = system_of(rest);
  if (!from || !has_sign || !to || !rest.empty()) return tl::unexpected(translated(texts::edit::want_systems, text));
  return std::pair(*from, *to);
}

tl::expected<std::pair<std::string, double>, std::string> read_shift(std::string_view text) {
  std::string_view rest = text;
  std::string axis;
  if (!rest.empty() && is_letter(rest.front())) axis = to_upper(rest.front()), rest.remove_prefix(1);
  (void)take(rest, '+');
  const auto value = axis.empty() ? std::nullopt : number_of<double>(rest);
  if (!value || !rest.empty() || !(std::abs(*value) <= most_shift)) return tl::unexpected(translated(texts::edit::want_shift, text));
  return std::pair(axis, *value);
}

tl::expected<PlaneMap, std::string> read_mirror(std::string_view text) {
  std::string_view rest = text;
  const bool is_x = take(rest, 'X'), is_y = !is_x && take(rest, 'Y');
  std::optional<double> at = 0;
  if (take(rest, '=')) at = number_of<double>(rest);
  if ((!is_x && !is_y) || !at || !rest.empty() || !(std::abs(*at) <= most_shift))
    return tl::unexpected(translated(texts::edit::want_mirror, text));
  return is_x ? PlaneMap::mirror_x(*at) : PlaneMap::mirror_y(*at);
}

tl::expected<PlaneMap, std::string> read_rotation(std::string_view text) {
  constexpr double most_degrees = 3600;
  std::string_view rest = text;
  const auto degrees = number_of<double>(rest);
  Vec2 centre;
  bool right = degrees && std::abs(*degrees) <= most_degrees;
  if (right && take(rest, '@')) {
    const auto x = number_of<double>(rest);
    const bool has_comma = take(rest, ',');
    const auto y = number_of<double>(rest);
    right = x && has_comma && y && std::abs(*x) <= most_shift && std::abs(*y) <= most_shift;
    if (right) centre = {*x, *y};
  }
  if (!right || !rest.empty()) return tl::unexpected(translated(texts::edit::want_rotation, text));
  return PlaneMap::turn(*degrees, centre);
}

namespace {

constexpr std::uint32_t most_places = 1000;

std::optional<Vec2> pair_of(std::string_view& text) {
  const auto x = number_of<double>(text);
  const bool has_comma = take(text, ',');
  const auto y = number_of<double>(text);
  if (!x || !has_comma || !y || !(std::abs(*x) <= most_shift && std::abs(*y) <= most_shift)) return std::nullopt;
  return Vec2{*x, *y};
}

std::optional<std::vector<PlaneMap>> grid_of(std::string_view rest, std::uint32_t columns) {
  const auto rows = whole(rest);
  const auto by = take(rest, ':') ? pair_of(rest) : std::nullopt;
  const bool right = rows && *rows > 0 && columns > 0 && *rows <= most_places && columns <= most_places && *rows * columns <= most_places;
  if (!right || !by || !rest.empty()) return std::nullopt;
  std::vector<PlaneMap> places;
  for (std::uint32_t row = 0; row < *rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column)
      if (row + column > 0) places.push_back(PlaneMap::shift({column * by->x, row * by->y}));
  return places;
}

std::optional<std::vector<PlaneMap>> circle_of(std::string_view rest, std::uint32_t count) {
  constexpr double most_degrees = 360;
  const auto step = number_of<double>(rest);
  const auto centre = take(rest, ':') ? pair_of(rest) : std::optional(Vec2{});
  const bool right = step && std::abs(*step) <= most_degrees && count > 0 && count <= most_places;
  if (!right || !centre || !rest.empty()) return std::nullopt;
  std::vector<PlaneMap> places;
  for (std::uint32_t i = 1; i < count; ++i) places.push_back(PlaneMap::turn(i * *step, *centre));
  return places;
}

}  // namespace

tl::expected<std::vector<PlaneMap>, std::string> read_places(std::string_view text) {
  std::string_view rest = text;
  const auto count = whole(rest);
  std::optional<std::vector<PlaneMap>> places;
  if (count && take(rest, 'X')) places = grid_of(rest, *count);
  else if (count && take(rest, '@')) places = circle_of(rest, *count);
  if (!places) return tl::unexpected(translated(texts::edit::want_places, text));
  return std::move(*places);
}

tl::expected<EditLines, std::string> read_lines(std::string_view text) {
  std::string_view rest = text;
  const auto first = whole(rest);
  const bool has_dash = take(rest, '-');
  const auto last = whole(rest);
  if (!first || !has_dash || !last || *first == 0 || *last < *first || !rest.empty())
    return tl::unexpected(translated(texts::edit::want_lines, text));
  return EditLines{*first, *last};
}

tl::expected<void, std::string> add_edit(Edits& edits, std::string_view name, std::string_view word) {
  const auto put = [](auto made, const auto& keep) -> tl::expected<void, std::string> {
    if (!made) return tl::unexpected(std::move(made.error()));
    keep(std::move(*made));
    return {};
  };
  const std::pair<std::string_view, bool*> switches[] = {{"numbers", &edits.no_numbers},
                                                         {"comments", &edits.no_comments},
                                                         {"spaces", &edits.no_spaces},
                                                         {"empty-lines", &edits.no_empty_lines}};
  const auto put_on = [](bool& is_on) {
    is_on = true;
    return tl::expected<void, std::string>();
  };
  for (const auto& [what, is_on] : switches)
    if (name == "strip" && word == what) return put_on(*is_on);
  if (name == "add" && word == "spaces") return put_on(edits.spaces);
  if (name == "renumber") return put(read_numbering(word), [&](Numbering one) { edits.numbering = one; });
  if (name == "feed") return put(read_factor(word), [&](Factor one) { edits.feeds.push_back(one); });
  if (name == "speed") return put(read_factor(word), [&](Factor one) { edits.speeds.push_back(one); });
  if (name == "replace-tool") return put(read_tools(word), [&](auto one) { edits.tools.push_back(one); });
  if (name == "replace-zero") return put(read_systems(word), [&](auto one) { edits.work_systems.push_back(one); });
  if (name == "shift") return put(read_shift(word), [&](const auto& one) { edits.shift[one.first] = one.second; });
  if (name == "mirror") return put(read_mirror(word), [&](const PlaneMap& map) { edits.plane = map, ++edits.maps; });
  if (name == "rotate") return put(read_rotation(word), [&](const PlaneMap& map) { edits.plane = map, ++edits.maps; });
  if (name == "copy") return put(read_places(word), [&](auto places) { edits.places = std::move(places), edits.copies = true; });
  if (name == "lines") return put(read_lines(word), [&](const EditLines& lines) { edits.copied = lines; });
  if (name == "reverse") return put(read_lines(word), [&](const EditLines& lines) { edits.reverses = lines; });
  return tl::unexpected(translated(texts::edit::no_such_edit, name, word));
}

int places_edited(const Edits& edits) {
  return int(!edits.shift.empty()) + edits.maps + int(edits.copies) + int(edits.reverses.has_value());
}

}  // namespace kadr
