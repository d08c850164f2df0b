#pragma once
// BlockEditor: the changes that edits make in the words of one block. It follows the modes of the text (absolute or incremental, inches) as
// far as they decide what a word means; the proof (edit/edit_proof) finds the cases in which the run has other modes than the text.

#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "config/control/control_def.h"
#include "edit/edits.h"
#include "edit/line_changes.h"
#include "edit/line_uses.h"
#include "edit/plane_editor.h"
#include "edit/renumbering.h"

namespace kadr {

class BlockEditor {
 public:
  ///   use  what the lines are used for; nullptr if no edit depends on it
  BlockEditor(const ControlDef& def, const Edits& edits, const LineUses* use);

  /// Adds the changes of the block's words. Must be called for each block in order.
  tl::expected<void, EditFault> change(const Block& block, LineChanges& to);
  /// Returns the number of words that were changed in blocks that the run did not execute, so that the proof does not cover them.
  std::size_t not_executed() const { return not_executed_; }

 private:
  /// What the codes of a block mean for its words.
  struct Codes {
    std::uint64_t taken = 0;     // letters (one bit each) of words that belong to a code, not to a modal function
    bool keeps_places = false;   // the axis words are no positions of the work system: G4 X, G53, G92
    bool is_macro_call = false;  // the words are arguments
    bool takes_offset = false;   // a code of tool length or cutter compensation uses H or D
  };
  Codes look(const Block& block);
  void note_mode(const CodeRow& row);
  tl::expected<double, EditFault> factor_of(const Block& block, const std::vector<Factor>& factors) const;
  tl::expected<void, EditFault> feed_word(const Block& block, const Word& word, LineChanges& to);
  tl::expected<void, EditFault> speed_word(const Block& block, const Word& word, LineChanges& to);
  void tool_word(const Block& block, const Word& word, LineChanges& to);
  void system_word(const Block& block, const Word& word, LineChanges& to);
  tl::expected<void, EditFault> place_word(const Block& block, const Word& word, const Codes& codes, LineChanges& to);
  tl::expected<void, EditFault> scale(const Block& block, const Word& word, double factor, LineChanges& to);
  tl::expected<void, EditFault> set(const Block& block, const Word& word, double value, LineChanges& to);
  void spacing(const Block& block, LineChanges& to) const;
  std::optional<std::uint32_t> new_tool(std::uint32_t tool) const;
  bool is_absolute_centre() const;
  void count_unproven(const Block& block);

  const ControlDef& def_;
  const Edits& edits_;
  const LineUses* use_;
  std::uint32_t tool_ = 0;  // tool in the spindle after the last line that was executed
  std::optional<PlaneEditor> plane_;
  std::size_t not_executed_ = 0;
  bool incremental_ = false, inch_ = false, centres_absolute_ = false;
};

}  // namespace kadr
