#pragma once
// BlockRewriter: rewrites a block of the source control word by word as a block of the target control. Codes are matched by their function,
// words are reformatted, variables and expressions stay. The class reads only the text and does not check what the block does; the proof
// (convert/conversion) checks this.

#include <array>
#include <optional>
#include <string>

#include "config/machine/machine_codes.h"
#include "convert/block_maker.h"
#include "convert/code_match.h"
#include "convert/flow_rewriter.h"
#include "convert/o_line_rewriter.h"
#include "lang/block/block.h"

namespace kadr {

class BlockRewriter {
 public:
  ///   from, to  the source control and the target control; both must outlive this object
  BlockRewriter(const ControlDef& from, const ControlDef& to);

  /// Writes the words of a block into `out`. After an alarm, the words in `out` may be incomplete.
  ///   alarms  function_has_no_code, word_has_no_room  the target control cannot express the block
  Status write(const Block& block, BlockMaker& out);
  /// Ends the modes that the rewritten block has switched on for itself only. The caller must call this function after each block.
  Status end(BlockMaker& out);
  /// Sets the numbers of the variables that the program uses. Named variables then get other numbers.
  void set_used(std::set<std::uint32_t> used) { flow_.set_used(std::move(used)); }
  void set_macros(MacroShape shape) { o_lines_.set_shape(std::move(shape)); }
  /// Writes the block with which a subprogram begins on the target control.
  Status write_label(std::uint32_t label, BlockMaker& out);
  /// Sets whether the blocks belong to the section of subprograms. In this section, a program end code does not end the program (spec/s2c42
  /// 6).
  void set_in_section(bool is) { in_section_ = is; }
  /// Tracks the modes that a block puts in force, without rewriting it. The caller must call this function for each block that is not
  /// rewritten here.
  void pass(const Block& block);
  /// Makes the next motion repeat its code and, in inches, its feed. The caller must call this function after it has inserted other blocks.
  void repeat_modes() { repeats_modes_ = true, repeats_feed_ = is_inch_; }
  /// True if the source text states lengths in inches from the present block on.
  bool is_inch() const { return is_inch_; }

 private:
  struct Kinds;
  struct PlainWord {
    Words form;    // number format, on the target control, of a word that is to be written
    double scale;  // factor that converts the number in the source text to mm, degrees, s, …
  };
  bool is_plain(const Block& block) const {
    return block.shape && (block.letters & ~plain_letters_) == 0 && !repeats_modes_ && !(stops_.is_mode && stops_.by_block);
  }
  /// Returns the alarm that the target control has no word like `what`.
  static Status cannot(std::string_view what);
  Status write_plain(const Block& block, BlockMaker& out);
  const CodeRow* row_of(const Word& word) const;
  void look(const Block& block, Kinds& kinds) const;
  Status statement(const Block& block, BlockMaker& out);
  Status implied_number(const Block& block, const CodeRow& row, BlockMaker& out) const;
  Status write_again(const Kinds& kinds, BlockMaker& out);
  Status code(const CodeRow& row, BlockMaker& out) const;
  bool is_other_code(const Word& word, const CodeRow& row) const;
  bool machine_code(const Word& word, const CodeRow& row, BlockMaker& out) const;
  std::optional<char> letter_of(const Word& word, const Kinds& kinds) const;
  bool is_to_o_lines() const { return from_.grammar.has_statements() && to_.grammar.o_words; }
  Status o_line(const Block& block, BlockMaker& out);
  Status macro_call(const Block& block, BlockMaker& out);
  Status exact_stop(const Kinds& kinds, BlockMaker& out);
  Status words_of(const Block& block, const Kinds& kinds, BlockMaker& out);
  Status word(const Block& block, const Word& word, const Kinds& kinds, BlockMaker& out);
  Status section_call(const Word& word, BlockMaker& out) const;
  Status dwell_word(const Word& word, const CodeRow& dwell, BlockMaker& out) const;
  Status number(const Word& word, char letter, BlockMaker& out) const;
  std::string assignment(std::string_view text) const;
  Status slice(std::string_view text, BlockMaker& out);
  double seconds(const Word& word) const;
  double value_of(const Word& word) const;

  const ControlDef& from_;
  const ControlDef& to_;
  const CodeMatch match_;
  const MachineCodes codes_;
  FlowRewriter flow_;
  OLineRewriter o_lines_;
  std::uint8_t motion_group_ = 0;    // index of the modal group of motion codes of `from_`
  const CodeRow* motion_ = nullptr;  // motion code in force in the source text
  bool motion_is_cycle_ = false;
  struct Stops {
    // by_block: the target control has only exact stops for a single block; by_mode: it has only an exact stop mode
    bool by_block = false, by_mode = false;
    bool is_mode = false;  // exact stop mode is in force in the source text
    bool goes_on = false;  // true: the exact stop mode was switched on for this block only, so end() must switch it off
  } stops_;
  bool is_metric_ = false;  // true: the target control reads lengths in mm only, not in inches
  bool is_inch_ = false, in_section_ = false;
  bool repeats_modes_ = false, repeats_feed_ = false;
  double feed_ = -1;  // number of the last F word in the source text; -1: none yet
  double tool_ = 0;   // number of the last T word in the source text
  // Formats of the words whose meaning does not depend on other words of the block, by letter.
  std::array<std::optional<PlainWord>, 26> plain_;
  std::uint64_t plain_letters_ = 0;  // letters (one bit each) that have an element in plain_
};

}  // namespace kadr
