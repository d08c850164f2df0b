// ContourReversal: writes a contour backwards. Used by edit/editing; tested by tests/edit.py.

#include "edit/contour_reversal.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/tolerance.h"
#include "edit/block_style.h"
#include "edit/number_text.h"
#include "lang/block/block_reader.h"
#include "out/program/codes.h"
#include "out/program/words.h"
#include "texts/edit.h"

namespace kadr {
namespace {

constexpr int usual_decimals = 3, most_decimals = 6;  // of positions in words without a limit (out/program/words)
constexpr double same = 1e-6;                         // difference of positions that counts as none, in the unit of the program

/// The codes of compensation and their opposites.
enum class Side : std::uint8_t { none, off, left, right };

/// One motion of the contour, as the program states it.
struct Element {
  std::uint32_t line = 0;
  Function move = Function::linear;
  Vec2 from, to;
  std::optional<Vec2> centre;
  std::optional<double> radius;
  std::optional<double> feed;  // in force; nullopt: not known
  Side side = Side::none;      // what the block commands
  std::string offset;          // the words D, H … of the block
  std::string comment;         // with its brackets
  std::string number;          // the block number
};

class ContourReversal {
 public:
  ContourReversal(const EditedSource& program, const Edits& edits, const StopToken& stop)
      : program_(program), def_(*program.control), lines_(*edits.reverses), stop_(stop) {}

  tl::expected<Pattern, EditFault> make() {
    BlockReader reader(program_.source, def_.grammar, program_.encoding);
    Block block;
    while (!stop_.requested()) {
      const auto got = reader.next(block);
      if (got && *got == BlockReader::Got::end) break;
      if (block.position.line > lines_.last) break;
      if (!got) continue;
      if (auto status = take(block); !status) return tl::unexpected(status.error());
    }
    if (auto status = check(); !status) return tl::unexpected(status.error());
    return write();
  }

 private:
  static tl::unexpected<EditFault> fault(std::uint32_t line, std::string why) { return tl::unexpected(EditFault{line, std::move(why)}); }
  bool is_inside(const Block& block) const { return block.position.line >= lines_.first; }

  EditStatus take(const Block& block) {
    Element element;
    element.line = block.position.line;
    bool is_other = block.statement.kind != StatementKind::none || !block.assignments.empty() || block.marker != Marker::none ||
                    block.codes_vary || block.skip != 0;
    if (is_other || block.codes_vary) forget();
    if (!note_codes(block, element, is_other)) is_other = true;
    if (auto status = note_words(block, element, is_other); !status) return status;
    if (is_other && is_inside(block)) return fault(element.line, translated(texts::edit::not_reversed, block.text_of(block.where)));
    if (is_inside(block) && mark_.empty()) mark_ = BlockStyle::ending_of(block);
    return {};
  }

  /// The position after this block is not known.
  void forget() { x_.reset(), y_.reset(), approach_.reset(); }

  /// True for functions after which the tool is not where the words of the program say: calls, positions of the machine, other zeros.
  static bool moves_elsewhere(const FunctionTraits& traits) {
    return traits.takes_axes() || traits.phase == Phase::zero || traits.phase == Phase::transform || traits.phase == Phase::flow;
  }

  /// Returns false if the block has a code that no contour in the plane has.
  bool note_codes(const Block& block, Element& element, bool& is_other) {
    bool is_known = true;
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
      const Word& word = block.words[i];
      if (word.code < 0) continue;
      const std::int32_t at = def_.row_of(word.address, word.code);
      if (at < 0) {
        is_known = false;
        continue;
      }
      const CodeRow& row = def_.codes[static_cast<std::size_t>(at)];
      constexpr int left_side = 41, right_side = 42, xy_code = 17;
      switch (row.function) {
        case Function::rapid:
        case Function::linear:
        case Function::arc_cw:
        case Function::arc_ccw: move_ = row.function; break;
        case Function::absolute: incremental_ = false; break;
        case Function::incremental: incremental_ = true; break;
        case Function::centers_absolute: centres_absolute_ = true; break;
        case Function::centers_incremental: centres_absolute_ = false; break;
        case Function::inch: inch_ = true; break;
        case Function::millimetre: inch_ = false; break;
        case Function::radius_comp_off: element.side = Side::off; break;
        case Function::radius_comp_left: element.side = Side::left; break;
        case Function::radius_comp_right: element.side = Side::right; break;
        case Function::radius_side: element.side = row.arg == 0 ? Side::off : row.arg == 1 ? Side::left : Side::right; break;
        case Function::tool_side:
          if (row.arg != left_side && row.arg != right_side) is_known = false;
          element.side = row.arg == left_side ? Side::left : Side::right;
          break;
        case Function::plane_xy: break;
        default:
          is_known = is_known && row.function == Function::select_plane && row.arg == xy_code;
          if (moves_elsewhere(traits_of(row.function))) forget();
          break;
      }
    }
    is_other = is_other || (is_inside(block) && (incremental_ || !is_known));
    return is_known || !is_inside(block);
  }

  EditStatus note_words(const Block& block, Element& element, bool& is_other) {
    std::optional<double> x, y, i_word, j_word, z;
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
      const Word& word = block.words[i];
      if (word.code >= 0) continue;
      if (word.expression || word.incremental) {
        is_other = true;
        if (word.address == 'X') x_.reset();
        if (word.address == 'Y') y_.reset();
        continue;
      }
      note_decimals(block.text_of(word.where));
      switch (word.address) {
        case 'X': x = word.value; break;
        case 'Y': y = word.value; break;
        case 'Z': z = word.value; break;
        case 'I': i_word = word.value; break;
        case 'J': j_word = word.value; break;
        case 'R': element.radius = word.value; break;
        case 'F': feed_ = word.value; break;
        case 'D':
        case 'H': element.offset += std::string(block.text_of(without_blanks(block, word.where))) + " "; break;
        default: is_other = true; break;
      }
    }
    if (is_inside(block) && z) is_other = true;
    if (pending_.side != Side::none && element.side == Side::none) element.side = pending_.side, element.offset = pending_.offset;
    if (!x && !y && !i_word && !j_word) {
      if (!is_inside(block) || block.word_count == 0) return {};
      if (element.side != Side::none) pending_ = element;
      if (!block.comments.empty()) is_other = true;
      alone_.push_back(element.line);
      return {};
    }
    pending_ = {};
    const std::optional<Vec2> from = x_ && y_ ? std::optional(Vec2{*x_, *y_}) : std::nullopt;
    if (incremental_) {
      if (x_) *x_ += x.value_or(0);
      if (y_) *y_ += y.value_or(0);
    } else {
      if (x) x_ = x;
      if (y) y_ = y;
    }
    if (!is_inside(block)) {
      // The rapid that leads to the contour. A coordinate that it does not state is known from blocks before it
      approach_.reset();
      if (move_ == Function::rapid && x_ && y_ && !incremental_) note_approach(block);
      return {};
    }
    if (!from || !x_ || !y_) return fault(element.line, translated(texts::edit::contour_unknown));
    element.from = *from, element.to = {*x_, *y_}, element.move = move_, element.feed = feed_;
    if (i_word || j_word) element.centre = centre_of(*from, i_word, j_word);
    for (const Span comment : block.comments) element.comment += " (" + std::string(block.text_of(comment)) + ")";
    if (block.has_number) element.number = std::string(block.text_of(block.number_where));
    elements_.push_back(std::move(element));
    return {};
  }

  /// Positions are written with as many decimals as the program has.
  void note_decimals(std::string_view word) {
    const std::size_t point = word.find('.');
    if (point == std::string_view::npos) return;
    std::size_t end = point + 1;
    while (end < word.size() && word[end] >= '0' && word[end] <= '9') ++end;
    decimals_ = std::clamp(int(end - point) - 1, decimals_, most_decimals);
  }

  Vec2 centre_of(Vec2 from, std::optional<double> i, std::optional<double> j) const {
    const bool is_absolute = def_.behaviour.arc_centers == ArcCenters::by_code       ? centres_absolute_
                             : def_.behaviour.arc_centers == ArcCenters::as_distance ? !incremental_
                                                                                     : false;
    if (is_absolute) return {i.value_or(0), j.value_or(0)};
    return from + Vec2{i.value_or(0), j.value_or(0)};
  }

  void note_approach(const Block& block) {
    approach_ = block.position.line, approach_text_ = std::string(block.text);
    const Word* const x = block.find('X');
    const Word* const y = block.find('Y');
    approach_x_ = x == nullptr ? std::nullopt : std::optional(*x), approach_y_ = y == nullptr ? std::nullopt : std::optional(*y);
  }

  EditStatus check() {
    if (elements_.empty()) return fault(lines_.first, translated(texts::edit::no_contour));
    if (pending_.side != Side::none) return fault(pending_.line, translated(texts::edit::contour_side));
    Side side = Side::none;
    int begins = 0, ends = 0;
    for (const Element& one : elements_) {
      if (one.side == Side::none) continue;
      begins += one.side != Side::off, ends += one.side == Side::off;
      side = one.side;
    }
    if (begins != ends || begins > 1 || (side != Side::none && side != Side::off))
      return fault(lines_.first, translated(texts::edit::contour_side));
    const Vec2 gap = elements_.back().to - elements_.front().from;
    is_closed_ = std::abs(gap.x) <= same && std::abs(gap.y) <= same;
    if (!is_closed_ && !approach_) return fault(lines_.first, translated(texts::edit::contour_open));
    return {};
  }

  std::string code(Function function) const {
    const CodeRow* const row = row_that_does(def_, {{function, any_argument}});
    return row == nullptr ? std::string() : with_digits(def_, *row);
  }
  std::string side_code(Side side) const {
    if (side == Side::off) {
      if (const auto found = code_of(def_, {{Function::radius_comp_off, any_argument}, {Function::radius_side, 0}})) return *found;
      return {};
    }
    constexpr int left_side = 41, right_side = 42;
    const bool is_left = side == Side::left;
    return code_of(def_, {{is_left ? Function::radius_comp_left : Function::radius_comp_right, any_argument},
                          {Function::radius_side, is_left ? 1 : 2},
                          {Function::tool_side, is_left ? left_side : right_side}})
        .value_or("");
  }

  /// Appends a word, with a blank before it. `value` in the unit of the program.
  bool put(std::string& text, char letter, double value) const {
    const Words words(def_, letter, std::max(decimals_ - usual_decimals, inch_ ? 1 : 0));
    std::string word;
    if (!words.append(word, value * def_.address(letter).scale)) return false;
    text += (text.empty() ? "" : " ") + word;
    return true;
  }

  tl::expected<Pattern, EditFault> write() {
    Pattern made;
    EditLines piece = lines_;
    Side begun = Side::none;
    std::string offset;
    for (const Element& one : elements_)
      if (one.side == Side::left || one.side == Side::right) begun = one.side, offset = one.offset;
    std::optional<double> feed;
    Function move = Function::count;
    for (std::size_t k = elements_.size(); k-- > 0;) {
      const Element& old = elements_[k];
      const Element& slot = elements_[elements_.size() - 1 - k];
      std::string text;
      const auto add = [&text](const std::string& word) { text += (text.empty() || word.empty() ? "" : " ") + word; };
      if (old.side == Side::off) add(side_code(begun == Side::left ? Side::right : Side::left));
      if (old.side == Side::left || old.side == Side::right) add(side_code(Side::off));
      const Function way = old.move == Function::arc_cw ? Function::arc_ccw : old.move == Function::arc_ccw ? Function::arc_cw : old.move;
      if (way != move || way == Function::arc_cw || way == Function::arc_ccw) add(code(way));
      move = way;
      bool fits = put(text, 'X', old.from.x) && put(text, 'Y', old.from.y);
      if (old.radius) fits = fits && put(text, 'R', *old.radius);
      if (old.centre && !old.radius) {
        const bool is_absolute =
            def_.behaviour.arc_centers == ArcCenters::by_code ? centres_absolute_ : def_.behaviour.arc_centers == ArcCenters::as_distance;
        const Vec2 centre = is_absolute ? *old.centre : *old.centre - old.to;
        fits = fits && put(text, 'I', centre.x) && put(text, 'J', centre.y);
      }
      if (old.side == Side::off && !offset.empty()) add(offset.substr(0, offset.size() - 1));
      if (old.feed && old.move != Function::rapid && (!feed || *feed != *old.feed))
        fits = fits && put(text, 'F', *old.feed), feed = old.feed;
      if (!fits) return fault(old.line, translated(texts::edit::contour_words));
      made.patches.instead[slot.line] =
          (slot.number.empty() ? "" : slot.number + (slot.number.ends_with(' ') ? "" : " ")) + text + old.comment + mark_;
    }
    for (const std::uint32_t line : alone_) made.patches.instead[line] = "";
    if (!is_closed_) {
      std::string text = approach_text_;
      if (!lead_to(text, elements_.back().to)) return fault(*approach_, translated(texts::edit::contour_words));
      made.patches.instead[*approach_] = text;
      piece.first = *approach_;
    }
    made.pieces.push_back(piece);
    return made;
  }

  /// Writes another end into the line of the approach.
  bool lead_to(std::string& text, Vec2 to) const {
    LineChanges changes;
    const std::string_view old = text;
    for (const bool is_x : {true, false}) {
      const std::optional<Word>&own = is_x ? approach_x_ : approach_y_, &other = is_x ? approach_y_ : approach_x_;
      const Word& word = own ? *own : *other;
      Span where = word.where;
      while (where.end > where.begin && old[where.end - 1] == ' ') --where.end;
      auto made = word_with_value(old.substr(where.begin, where.end - where.begin), word, def_, is_x ? to.x : to.y);
      if (!made) return false;
      if (own) {
        changes.replace(where, std::move(*made));
        continue;
      }
      made->front() = is_x ? 'X' : 'Y';
      if (is_x) changes.replace({where.begin, where.begin}, *made + " ");
      else changes.replace({where.end, where.end}, " " + *made);
    }
    text = changes.applied(std::string(old));
    return true;
  }

  const EditedSource& program_;
  const ControlDef& def_;
  const EditLines lines_;
  const StopToken& stop_;
  std::vector<Element> elements_;
  std::vector<std::uint32_t> alone_;  // lines of codes without a motion; the reversed contour has their codes in other lines
  Element pending_;                   // a block with compensation alone, which the next motion executes
  Function move_ = Function::rapid;
  std::optional<double> x_, y_, feed_;
  std::optional<std::uint32_t> approach_;  // line of the rapid that leads to the contour
  std::string approach_text_, mark_;
  std::optional<Word> approach_x_, approach_y_;  // at least one of them if there is an approach
  int decimals_ = usual_decimals;
  bool incremental_ = false, centres_absolute_ = false, inch_ = false, is_closed_ = false;
};

}  // namespace

tl::expected<Pattern, EditFault> reversed_contour(const EditedSource& program, const Edits& edits, const StopToken& stop) {
  return ContourReversal(program, edits, stop).make();
}

}  // namespace kadr
