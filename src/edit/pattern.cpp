// Pattern: repeats the cutting of a program at other places. Used by edit/editing; tested by tests/edit.py.

#include "edit/pattern.h"

#include <algorithm>

#include "config/control/control_def.h"
#include "edit/block_style.h"
#include "edit/plane_editor.h"
#include "lang/block/block_reader.h"
#include "texts/edit.h"

namespace kadr {
namespace {

/// What a block means for the lines that are repeated.
struct BlockPart {
  bool separates = false;  // a piece ends before this block: tool change, end, position of the machine, another work system
  bool cuts = false;       // the block belongs to a piece that has begun: motions, cycles, compensation
  bool places = false;     // the block states a position in the plane
  bool flows = false;      // the block calls or jumps
  bool assigns = false;    // the block gives a variable a value
  bool absolute = true;
};

class PatternMaker {
 public:
  PatternMaker(const EditedSource& program, const Edits& edits, const StopToken& stop)
      : program_(program), def_(*program.control), edits_(edits), stop_(stop) {}

  tl::expected<Pattern, EditFault> make() {
    if (auto status = find(); !status) return tl::unexpected(status.error());
    if (made_.pieces.empty()) return tl::unexpected(EditFault{0, translated(texts::edit::nothing_to_copy)});
    if (auto status = write(); !status) return tl::unexpected(status.error());
    return std::move(made_);
  }

 private:
  template <class Take>
  EditStatus each_block(const Take& take) {
    BlockReader reader(program_.source, def_.grammar, program_.encoding);
    Block block;
    while (!stop_.requested()) {
      const auto got = reader.next(block);
      if (got && *got == BlockReader::Got::end) break;
      if (!got) continue;
      if (auto status = take(block); !status) return status;
    }
    return {};
  }

  BlockPart look(const Block& block) {
    BlockPart part;
    part.separates = block.marker != Marker::none;
    part.assigns = !block.assignments.empty() || block.statement.kind == StatementKind::assign;
    part.flows = block.statement.kind != StatementKind::none && !part.assigns;
    bool keeps = false;
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
      const Word& word = block.words[i];
      const std::int32_t at = word.code < 0 ? -1 : def_.row_of(word.address, word.code);
      if (at < 0) continue;
      const CodeRow& row = def_.codes[static_cast<std::size_t>(at)];
      const FunctionTraits& traits = traits_of(row.function);
      if (row.function == Function::absolute) incremental_ = false;
      if (row.function == Function::incremental) incremental_ = true;
      const bool ends = traits.is(function_fact::ends) || traits.is(function_fact::stops);
      part.flows = part.flows || traits.is(function_fact::calls) || (traits.is(function_fact::passes_control) && !ends);
      part.separates = part.separates || ends || traits.phase == Phase::tool_change || traits.phase == Phase::zero ||
                       (traits.phase == Phase::data && traits.takes_axes()) || row.function == Function::machine_coordinates ||
                       row.function == Function::machine_block;
      part.cuts = part.cuts || traits.phase == Phase::motion || traits.phase == Phase::positioning || traits.phase == Phase::compensation;
      keeps = keeps || traits.phase == Phase::dwell;
    }
    if (keeps || part.separates) return part;
    part.places = block.has('X') || block.has('Y');
    part.cuts = part.cuts || part.places || block.has('Z');
    part.absolute = !incremental_;
    return part;
  }

  EditStatus find() {
    EditLines piece;
    const auto end_piece = [&] {
      if (piece.first != 0) made_.pieces.push_back(piece);
      piece = {};
    };
    const auto status = each_block([&](const Block& block) -> EditStatus {
      const std::uint32_t line = block.position.line;
      const BlockPart part = look(block);
      const auto fault = [&](std::string why) { return tl::unexpected(EditFault{line, std::move(why)}); };
      if (edits_.copied && (line < edits_.copied->first || line > edits_.copied->last)) return {};
      if (part.separates) {
        if (edits_.copied) return fault(translated(texts::edit::not_copied, block.text_of(block.where)));
        end_piece();
        return {};
      }
      if (part.flows || (piece.first != 0 && part.assigns)) return fault(translated(texts::edit::not_copied, block.text_of(block.where)));
      if (piece.first == 0) {
        // Stated lines are repeated from the first motion on, so this motion must say where it leads
        if (!part.places && (!edits_.copied || !part.cuts)) return {};
        if (!part.places) return fault(translated(texts::edit::copy_begins_without, block.text_of(block.where)));
        if (!part.absolute) return fault(translated(texts::edit::copy_needs_position));
        piece.first = line;
      }
      if (part.cuts) piece.last = line;
      return {};
    });
    end_piece();
    return status;
  }

  EditStatus write() {
    std::vector<PlaneEditor> editors;
    for (const PlaneMap& place : edits_.places) editors.emplace_back(def_, place);
    PlaneEditor in_place(def_, PlaneMap());
    incremental_ = false;
    std::vector<std::vector<Copied>> copies(editors.size());
    BlockStyle style = BlockStyle::of(program_.source, program_.encoding, def_, std::nullopt, stop_);
    auto piece = made_.pieces.begin();
    return each_block([&](const Block& block) -> EditStatus {
      if (auto status = lead_back(in_place, block, piece == made_.pieces.end()); !status) return status;
      if (piece == made_.pieces.end()) return {};
      const std::uint32_t line = block.position.line;
      for (std::size_t i = 0; i < editors.size(); ++i) {
        LineChanges changes;
        if (line == piece->first) editors[i].state_both();
        if (auto status = editors[i].change(block, changes); !status) return status;
        if (line < piece->first || line > piece->last) continue;
        copies[i].emplace_back(block, std::move(changes));
      }
      if (line != piece->last) return {};
      for (std::vector<Copied>& copy : copies) {
        for (Copied& one : copy) made_.patches.after[line].push_back(numbered(one, style));
        copy.clear();
      }
      if (!edits_.places.empty()) in_place.state_both();
      ++piece;
      return {};
    });
  }

  /// After copies the tool stands at the last place. The next position gets both words, so that it is where it was.
  ///   is_behind  no piece follows: a block that cannot be read is left to the proof
  EditStatus lead_back(PlaneEditor& in_place, const Block& block, bool is_behind) {
    const bool adds_a_word = in_place.will_state_both();
    if (is_behind && !adds_a_word) return {};
    LineChanges changes;
    const BlockPart part = look(block);
    const EditStatus status = in_place.change(block, changes);
    if (!adds_a_word) return {};  // the copies refuse what cannot be read before them
    if (part.places && !part.absolute)
      return tl::unexpected(EditFault{block.position.line, translated(texts::edit::increment_after_copies)});
    if (!status) return is_behind && in_place.will_state_both() ? EditStatus() : status;
    if (!changes.empty()) made_.patches.instead[block.position.line] = changes.applied(block.text);
    return {};
  }

  /// A line that is repeated, with its changes.
  struct Copied {
    Copied(const Block& block, LineChanges its_changes)
        : text(block.text), number(block.has_number ? std::optional(block.number_where) : std::nullopt), changes(std::move(its_changes)) {}
    std::string text;
    std::optional<Span> number;
    LineChanges changes;
  };

  /// Returns the repeated line with a number of its own, or with none if the program has none.
  static std::string numbered(Copied& line, BlockStyle& style) {
    if (line.number) {
      std::string number = style.next_number();
      Span where = *line.number;
      while (number.empty() && where.end < line.text.size() && line.text[where.end] == ' ') ++where.end;
      line.changes.replace(where, std::move(number));
    }
    return line.changes.applied(line.text);
  }

  const EditedSource& program_;
  const ControlDef& def_;
  const Edits& edits_;
  const StopToken& stop_;
  Pattern made_;
  bool incremental_ = false;
};

}  // namespace

tl::expected<Pattern, EditFault> pattern_of(const EditedSource& program, const Edits& edits, const StopToken& stop) {
  return PatternMaker(program, edits, stop).make();
}

}  // namespace kadr
