// PlaneEditor: maps the words of blocks by a mirror image, a rotation or a shift. Used by edit/block_editor and edit/pattern; tested by
// tests/edit.py.

#include "edit/plane_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "edit/number_text.h"
#include "out/program/codes.h"
#include "texts/edit.h"

namespace kadr {
namespace {

template <std::size_t count>
bool is_one_of(Function function, const Function (&all)[count]) {
  return std::find(std::begin(all), std::end(all), function) != std::end(all);
}

/// Functions whose words are no positions of the XY plane, or whose path a map of their words does not map.
constexpr Function not_mapped[] = {
    Function::polar_on,        Function::polar_data_on, Function::polar_surface_on,     Function::cylinder_mode,  Function::pole_rapid,
    Function::circular_pocket, Function::pocket_define, Function::pocket_run,           Function::tilted_plane,   Function::space_rotation,
    Function::hole_pattern,    Function::engraved_text, Function::tool_orientation,     Function::profile_cycle,  Function::cubic_spline,
    Function::nurbs_point,     Function::macro_call,    Function::quadratic_spline,     Function::rotation_on,    Function::macro_modal,
    Function::turning_cycle,   Function::scale_on,      Function::threading_cycle,      Function::turning_simple, Function::thread,
    Function::probe,           Function::probe_move,    Function::permanent_subprogram, Function::measure,
};
/// Functions whose words are positions of the machine, or only name axes by them.
constexpr Function of_machine[] = {Function::machine_coordinates, Function::machine_block,  Function::machine_move, Function::machine_point,
                                   Function::approach_reference,  Function::home_axes,      Function::set_data,     Function::table_data,
                                   Function::stored_offsets,      Function::mirror_axes_on, Function::part_zero};
constexpr Function shifts[] = {Function::local_system, Function::temporary_shift};
constexpr Function sets_position[] = {Function::set_position, Function::new_system};
constexpr Function names_axes[] = {Function::mirror_off, Function::mirror_axes_off};
constexpr Function returns[] = {Function::reference_return, Function::home_through, Function::stored_move};
constexpr Function changes_zero[] = {
    Function::work_system,  Function::work_system_extended, Function::work_zero,           Function::fixture,
    Function::table_system, Function::set_position_reset,   Function::coordinate_shift_off};
constexpr std::int32_t bore_76 = 760, bore_87 = 870;  // cycles with a shift in the plane, in tenths

EditStatus fault(const Block& block, std::string why) { return tl::unexpected(EditFault{block.position.line, std::move(why)}); }

/// Returns the word of a code with another number, as many digits as before: G02 becomes G03.
std::string with_number(std::string_view text, std::int32_t tenth) {
  std::size_t digits = 0;
  while (digits + 1 < text.size() && text[digits + 1] >= '0' && text[digits + 1] <= '9') ++digits;
  std::string made = fmt::format("{}{:0{}}", text.front(), tenth / 10, digits);
  return tenth % 10 == 0 ? made : made + fmt::format(".{}", tenth % 10);
}

const CodeRow* row_of(const ControlDef& def, const Word& word) {
  if (word.code < 0) return nullptr;
  const std::int32_t at = def.row_of(word.address, word.code);
  return at < 0 ? nullptr : &def.codes[static_cast<std::size_t>(at)];
}

/// Returns the code that turns or compensates the other way; nullptr if the row has no such code.
const CodeRow* other_way(const ControlDef& def, const CodeRow& row) {
  const auto of = [&](Function function, int arg) { return row_that_does(def, {{function, arg}}); };
  constexpr int left = 41, right = 42, tenfold = 10;
  switch (row.function) {
    case Function::arc_cw: return of(Function::arc_ccw, any_argument);
    case Function::arc_ccw: return of(Function::arc_cw, any_argument);
    case Function::radius_comp_left: return of(Function::radius_comp_right, any_argument);
    case Function::radius_comp_right: return of(Function::radius_comp_left, any_argument);
    case Function::radius_side: return row.arg == 0 ? nullptr : of(Function::radius_side, row.arg == 1 ? 2 : 1);
    case Function::tool_side:
      return of(Function::tool_side, row.arg == left                 ? right
                                     : row.arg == right              ? left
                                     : row.arg == left * tenfold + 1 ? right * tenfold + 1
                                                                     : left * tenfold + 1);
    case Function::circular_bore:
      for (const CodeRow& one : def.codes)
        if (one.function == row.function && one.letter == row.letter && one.tenth != row.tenth) return &one;
      return nullptr;
    default: return nullptr;
  }
}

int direction_of(const ControlDef& def, std::uint8_t axis) {
  return axis >= def.axes.size() ? -1 : def.axes[axis] == "X" ? 0 : def.axes[axis] == "Y" ? 1 : -1;
}

}  // namespace

Vec2 PlaneEditor::program_units(Vec2 mm) const { return (inch_ ? 1 / mm_per_inch : 1.0) * mm; }

/// True if the map reverses the sense of arcs in this plane. The normal of a plane is an axial vector: it maps by det(M) · M.
bool PlaneEditor::reverses(Plane plane) const {
  const double turn = map_.mirrors() ? -1 : 1;
  if (plane == Plane::xy) return turn < 0;
  const Vec2 normal = turn * map_.vector(plane == Plane::zx ? Vec2{0, 1} : Vec2{1, 0});
  return normal.x + normal.y < 0;
}

/// Sets the unit of the words. The position is known in the old unit only.
void PlaneEditor::set_unit(bool inch) {
  if (inch_ != inch) at_[0].reset(), at_[1].reset();
  inch_ = inch;
}

void PlaneEditor::note_mode(const CodeRow& row) {
  constexpr int zx_code = 18, yz_code = 19;
  switch (row.function) {
    case Function::absolute: incremental_ = false; break;
    case Function::incremental: incremental_ = true; break;
    case Function::inch: set_unit(true); break;
    case Function::millimetre: set_unit(false); break;
    case Function::centers_absolute: centres_absolute_ = true; break;
    case Function::centers_incremental: centres_absolute_ = false; break;
    case Function::plane_xy: plane_ = Plane::xy; break;
    case Function::plane_zx: plane_ = Plane::zx; break;
    case Function::plane_yz: plane_ = Plane::yz; break;
    case Function::select_plane: plane_ = row.arg == zx_code ? Plane::zx : row.arg == yz_code ? Plane::yz : Plane::xy; break;
    case Function::arc_cw:
    case Function::arc_ccw: arc_ = true, cycle_ = Cycle::none; break;
    case Function::rapid:
    case Function::linear: arc_ = false, cycle_ = Cycle::none; break;
    case Function::no_motion:
    case Function::drilling_off: cycle_ = Cycle::none; break;
    case Function::cycle:
    case Function::canned_cycle:
    case Function::drilling: cycle_ = row.tenth == bore_76 || row.tenth == bore_87 ? Cycle::shifts : Cycle::plain; break;
    default: break;
  }
}

/// Looks at the codes of a block: what its words are. Refuses codes whose words cannot be mapped.
tl::expected<PlaneEditor::Codes, EditFault> PlaneEditor::look(const Block& block) {
  Codes codes;
  if (block.codes_vary) return tl::unexpected(EditFault{block.position.line, translated(texts::edit::computed_code)});
  bool dwells = false;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const CodeRow* const row = row_of(def_, block.words[i]);
    if (row == nullptr) continue;
    note_mode(*row);
    const Function function = row->function;
    if (is_one_of(function, not_mapped))
      return tl::unexpected(EditFault{block.position.line, translated(texts::edit::not_mapped, block.text_of(block.words[i].where))});
    if (is_one_of(function, of_machine)) codes.places = Places::kept;
    if (is_one_of(function, shifts) || (function == Function::coordinate_shift && row->arg == 1)) codes.places = Places::vectors;
    if (is_one_of(function, sets_position) || (function == Function::coordinate_shift && row->arg == 0)) codes.is_new_position = true;
    if (is_one_of(function, names_axes)) codes.places = Places::names;
    dwells = dwells || function == Function::dwell || function == Function::dwell_or_turns;
    if (function == Function::radius_side || function == Function::vector_hold || function == Function::vector_corner)
      codes.has_direction = true;
    codes.scales = codes.scales || function == Function::scaling_on;
    codes.keeps_centres = codes.keeps_centres || function == Function::circular_bore;
    codes.loses_position = codes.loses_position || is_one_of(function, of_machine) || is_one_of(function, returns) ||
                           is_one_of(function, shifts) || is_one_of(function, changes_zero) ||
                           traits_of(function).is(function_fact::calls) || traits_of(function).is(function_fact::passes_control) ||
                           traits_of(function).is(function_fact::ends);
    const bool moves_home = is_one_of(function, returns);
    if (moves_home && (map_.swaps() || !map_.is_quarter()) && (block.has('X') || block.has('Y'))) {
      for (const char letter : {'X', 'Y'})
        if (const Word* const word = block.find(letter); word != nullptr && (word->expression || word->value != 0))
          return tl::unexpected(EditFault{block.position.line, translated(texts::edit::not_mapped, block.text_of(block.words[i].where))});
      codes.places = Places::kept;
    }
  }
  if (dwells) codes.places = Places::kept;
  codes.keeps_centres = codes.keeps_centres || cycle_ == Cycle::plain || codes.scales;
  return codes;
}

EditStatus PlaneEditor::swap_code(const Block& block, const Word& word, const CodeRow& row, LineChanges& to) {
  const CodeRow* const other = other_way(def_, row);
  if (other == nullptr) return {};
  const bool is_arc = row.function == Function::arc_cw || row.function == Function::arc_ccw;
  if (is_arc && plane_ != Plane::xy && !map_.is_quarter()) return fault(block, translated(texts::edit::only_quarters));
  if (!reverses(plane_)) return {};
  to.replace(without_blanks(block, word.where), with_number(block.text_of(without_blanks(block, word.where)), other->tenth));
  ++changed_;
  return {};
}

/// Exchanges G18 and G19 if X becomes Y.
EditStatus PlaneEditor::plane_code(const Block& block, const Word& word, const CodeRow& row, LineChanges& to) {
  constexpr int zx_code = 18, yz_code = 19;
  const bool is_zx = row.function == Function::plane_zx || (row.function == Function::select_plane && row.arg == zx_code);
  const bool is_yz = row.function == Function::plane_yz || (row.function == Function::select_plane && row.arg == yz_code);
  if ((!is_zx && !is_yz) || !map_.is_quarter() || !map_.swaps()) return {};
  const CodeRow* const other = row.function == Function::select_plane
                                   ? row_that_does(def_, {{Function::select_plane, is_zx ? yz_code : zx_code}})
                                   : row_that_does(def_, {{is_zx ? Function::plane_yz : Function::plane_zx, any_argument}});
  if (other == nullptr) return fault(block, translated(texts::edit::not_mapped, block.text_of(word.where)));
  to.replace(without_blanks(block, word.where), with_number(block.text_of(without_blanks(block, word.where)), other->tenth));
  ++changed_;
  return {};
}

std::optional<std::string> PlaneEditor::text_of(const Block& block, const Word& word, char letter, double value) const {
  const std::string_view old = block.text_of(without_blanks(block, word.where));
  auto made = value == word.value ? std::optional(std::string(old)) : word_with_value(old, word, def_, value);
  if (made && !made->empty() && word.address != letter) made->front() = made->front() >= 'a' ? char(letter - 'A' + 'a') : letter;
  return made;
}

/// Replaces the word `at` by the word of `letter` whose value is `factor` times that of `value` plus `by`.
EditStatus PlaneEditor::write(const Block& block, const Word& at, const Word& value, char letter, double factor, double by,
                              LineChanges& to) {
  const Span where = without_blanks(block, at.where);
  const std::string_view old = block.text_of(without_blanks(block, value.where));
  std::optional<std::string> made;
  if (!value.expression) {
    const double wanted = factor * value.value + by;
    if (wanted == value.value && letter == value.address) made = std::string(old);
    else made = text_of(block, value, letter, wanted);
    if (!made) return fault(block, translated(texts::edit::does_not_fit, old, wanted));
  } else {
    std::size_t begin = 0;
    while (begin < old.size() && ((old[begin] >= 'A' && old[begin] <= 'Z') || (old[begin] >= 'a' && old[begin] <= 'z'))) ++begin;
    if (!def_.grammar.expressions && !def_.grammar.custom_macros) return fault(block, translated(texts::edit::parameter_word, old));
    if (begin != 1) return fault(block, translated(texts::edit::not_mapped, old));
    const std::string inside(old.substr(begin));
    const std::string offset = by == 0 ? "" : fmt::format("{:+.6g}", by);
    made = factor == 1 && by == 0 ? letter + inside
           : factor == 1          ? fmt::format("{}[{}{}]", letter, inside, offset)
                                  : fmt::format("{}[0-[{}]{}]", letter, inside, offset);
  }
  if (*made == block.text_of(where)) return {};
  to.replace(where, std::move(*made));
  ++changed_;
  return {};
}

/// Maps words one by one: X to X, or X to Y. Two words stay in their order.
EditStatus PlaneEditor::map_quarter(const Block& block, const Pair& pair, Places places, LineChanges& to) {
  const Vec2 by = places == Places::points ? program_units(map_.by) : Vec2{};
  const bool swaps = map_.swaps();
  for (const int i : {0, 1}) {  // i: where the value goes, j: where it comes from
    const int j = swaps ? 1 - i : i;
    const Word* const from = pair.words[j];
    if (from == nullptr) continue;
    const Word& at = pair.words[i] != nullptr ? *pair.words[i] : *from;
    const double factor = places == Places::names ? 1 : i == 0 ? (swaps ? map_.of_y.x : map_.of_x.x) : (swaps ? map_.of_x.y : map_.of_y.y);
    const double scale = def_.address(from->address).scale;
    if (auto status = write(block, at, *from, pair.letters[i], factor, (i == 0 ? by.x : by.y) / scale, to); !status) return status;
  }
  return {};
}

/// Returns the value as the word can state it. What increments lose by the rounding is added to the next one.
double PlaneEditor::rounded(const Word& like, char letter, bool is_increment, double value) {
  constexpr double least_mm = 1e-3, least_inch = 1e-4;  // usual increments of controls whose words may have any number of decimals
  const WordFormat& format = def_.grammar.word(like.address);
  const bool is_limited = format.whole_digits > 0 || format.fraction_digits > 0 || format.implied;
  const double step = is_limited ? std::pow(10.0, -double(format.fraction_digits)) : inch_ ? least_inch : least_mm;
  const bool is_end = letter == 'X' || letter == 'Y';
  double& lost = lost_[letter == 'X' ? 0 : 1];
  const double exact = is_increment && is_end ? value + lost : value, made = std::round(exact / step) * step;
  if (is_end) lost = is_increment ? exact - made : value - made;
  return made;
}

/// Maps a pair of words. `missing`: the values of words that the block does not state; nullopt: they are not known.
EditStatus PlaneEditor::map_pair(const Block& block, const Pair& pair, Places places, std::optional<Vec2> missing, LineChanges& to) {
  if ((pair.words[0] == nullptr && pair.words[1] == nullptr) || places == Places::kept) return {};
  const bool adds_one = states_both_ && places == Places::points && pair.letters[0] == 'X';
  if (adds_one) states_both_ = false;
  if (map_.is_quarter() && (!adds_one || (pair.words[0] != nullptr && pair.words[1] != nullptr)))
    return map_quarter(block, pair, places, to);
  if (places == Places::names) return fault(block, translated(texts::edit::only_quarters));
  const int only = pair.words[0] == nullptr ? 1 : 0;
  for (const Word* const word : pair.words)
    if (word != nullptr && word->expression && !map_.is_quarter())
      return fault(block, translated(texts::edit::computed_word, block.text_of(word->where)));
  const Word& pattern = *pair.words[only];
  if ((!missing || (adds_one && pattern.expression)) && (pair.words[0] == nullptr || pair.words[1] == nullptr))
    return fault(block, translated(texts::edit::position_unknown, std::string(1, pair.letters[1 - only])));
  Vec2 value = missing.value_or(Vec2{});
  if (pair.words[0] != nullptr) value.x = pair.words[0]->value;
  if (pair.words[1] != nullptr) value.y = pair.words[1]->value;
  Vec2 made = map_.vector(value);
  if (places == Places::points) made = made + program_units(map_.by);
  const bool is_packed = block.word_count > 1 && block.text.find(' ') == std::string_view::npos;
  for (const int i : {0, 1}) {
    const Word& like = pair.words[i] != nullptr ? *pair.words[i] : pattern;
    const double exact = i == 0 ? made.x : made.y;
    const double wanted = map_.is_quarter() ? exact : rounded(like, pair.letters[i], places == Places::vectors, exact);
    auto text = text_of(block, like, pair.letters[i], wanted);
    if (!text) return fault(block, translated(texts::edit::does_not_fit, block.text_of(like.where), wanted));
    const Span where = without_blanks(block, like.where);
    if (pair.words[i] != nullptr) to.replace(where, std::move(*text));
    else if (i < only) to.replace({where.begin, where.begin}, *text + (is_packed ? "" : " "));
    else to.replace({where.end, where.end}, (is_packed ? "" : " ") + *text);
    ++changed_;
  }
  return {};
}

void PlaneEditor::note_position(const Block& block, const Pair& pair, const Codes& codes) {
  for (const int i : {0, 1}) {
    if (codes.loses_position) at_[i].reset();
    const Word* const word = pair.words[i];
    if (word == nullptr || codes.places != Places::points) continue;
    if (word->expression) at_[i].reset();
    else if (!incremental_ && !word->incremental) at_[i] = word->value;
    else if (at_[i]) *at_[i] += word->value;
  }
  if (block.marker != Marker::none || block.statement.kind == StatementKind::o_word || block.statement.kind == StatementKind::go_to ||
      block.statement.kind == StatementKind::loop || block.statement.kind == StatementKind::loop_end)
    at_[0].reset(), at_[1].reset();
}

EditStatus PlaneEditor::axis_words(const Block& block, const Codes& codes, LineChanges& to) {
  Pair places, increments;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& word = block.words[i];
    if (word.code >= 0 || word.address < 'A' || word.address > 'Z') continue;
    if (word.axis) return fault(block, translated(texts::edit::not_mapped, block.text_of(word.where)));
    const AddressRow& row = def_.address(word.address);
    const bool is_axis = row.function == Function::axis || row.function == Function::machine_axis;
    if (is_axis && (word.address == 'X' || word.address == 'Y')) {
      Pair& pair = word.incremental ? increments : places;
      pair.words[word.address == 'X' ? 0 : 1] = &word;
    }
    if (row.function == Function::increment_axis && direction_of(def_, row.axis) >= 0)
      return fault(block, translated(texts::edit::not_mapped, block.text_of(word.where)));
  }
  const bool are_vectors = codes.places == Places::points && incremental_ && !codes.is_new_position;
  const std::optional<Vec2> here = at_[0] && at_[1] ? std::optional(Vec2{*at_[0], *at_[1]}) : std::nullopt;
  std::optional<Vec2> missing = are_vectors || codes.places == Places::vectors ? std::optional(Vec2{}) : here;
  if (!missing && at_[0]) missing = places.words[1] != nullptr ? std::optional(Vec2{*at_[0], 0}) : std::nullopt;
  if (!missing && at_[1]) missing = places.words[0] != nullptr ? std::optional(Vec2{0, *at_[1]}) : std::nullopt;
  if (auto status = map_pair(block, places, are_vectors ? Places::vectors : codes.places, missing, to); !status) return status;
  if (increments.words[0] != nullptr || increments.words[1] != nullptr)
    if (auto status = map_pair(block, increments, codes.places == Places::points ? Places::vectors : codes.places, Vec2{}, to); !status)
      return status;
  note_position(block, places, codes);
  note_position(block, increments, codes);
  return {};
}

EditStatus PlaneEditor::centre_words(const Block& block, const Codes& codes, LineChanges& to) {
  if (codes.keeps_centres) return {};
  Pair pair;
  pair.letters[0] = 'I', pair.letters[1] = 'J';
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& word = block.words[i];
    if (word.code >= 0 || word.address < 'A' || word.address > 'Z') continue;
    const AddressRow& row = def_.address(word.address);
    if (row.function == Function::center && direction_of(def_, row.axis) >= 0) pair.words[direction_of(def_, row.axis)] = &word;
  }
  const bool is_absolute = !codes.has_direction && cycle_ == Cycle::none &&
                           (def_.behaviour.arc_centers == ArcCenters::by_code       ? centres_absolute_
                            : def_.behaviour.arc_centers == ArcCenters::as_distance ? !incremental_
                                                                                    : false);
  return map_pair(block, pair, is_absolute ? Places::points : Places::vectors, is_absolute ? std::nullopt : std::optional(Vec2{}), to);
}

/// The angle of a rotation of the coordinates changes its sign in a mirror image.
EditStatus PlaneEditor::angle_word(const Block& block, LineChanges& to) {
  const Word* const angle = block.find('R');
  if (angle == nullptr || !reverses(plane_)) return {};
  return write(block, *angle, *angle, 'R', -1, 0, to);
}

EditStatus PlaneEditor::change(const Block& block, LineChanges& to) {
  const auto codes = look(block);
  if (!codes) return tl::unexpected(codes.error());
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const CodeRow* const row = row_of(def_, block.words[i]);
    if (row == nullptr) continue;
    EditStatus status = swap_code(block, block.words[i], *row, to);
    if (status) status = plane_code(block, block.words[i], *row, to);
    if (status && row->function == Function::plane_rotation_on) status = angle_word(block, to);
    if (!status) return status;
  }
  if (block.has('X') || block.has('Y') || codes->loses_position || block.marker != Marker::none ||
      block.statement.kind != StatementKind::none)
    if (auto status = axis_words(block, *codes, to); !status) return status;
  return centre_words(block, *codes, to);
}

}  // namespace kadr
