#pragma once
// BlockRewriter: a block of one control word by word as a block of another one: its codes by what they do, its words in the other's form,
// variables and expressions as they stand. Only how it is said is looked at, not what it does: that the proof tells (convert/conversion).

#include <array>
#include <optional>
#include <string>

#include "config/machine_codes.h"
#include "convert/block_maker.h"
#include "convert/code_match.h"
#include "convert/flow_rewriter.h"
#include "convert/o_line_rewriter.h"
#include "lang/block/block.h"

namespace kadr {

class BlockRewriter {
 public:
  /// Both must outlive this.
  BlockRewriter(const ControlDef& from, const ControlDef& to);

  /// The words of a block, into `out`; on an alarm something may stand there.
  ///   alarms  function_has_no_code, word_has_no_room: the other control cannot say it
  Status write(const Block& block, BlockMaker& out);
  /// Behind the block: what it has put in force for itself alone is over.
  Status end(BlockMaker& out);
  /// Numbers of variables that the program uses.
  void set_used(std::set<std::uint32_t> used) { flow_.set_used(std::move(used)); }
  void set_macros(MacroShape shape) { o_lines_.set_shape(std::move(shape)); }
  /// The first block of a subprogram.
  Status write_label(std::uint32_t label, BlockMaker& out);
  /// Ends of a program end nothing there: a section of subprograms (spec/s2c42 6).
  void set_in_section(bool is) { in_section_ = is; }
  /// A block that is not written in this way: what it puts in force in the text counts all the same.
  void pass(const Block& block);
  /// Blocks of other words stand there now: the next motion says its code again, and in inches its feed.
  void say_again() { says_again_ = true, says_feed_again_ = is_inch_; }
  /// The lengths of the text are inches from here on.
  bool is_inch() const { return is_inch_; }

 private:
  struct Kinds;
  struct PlainWord {
    Words form;    // of the other control
    double scale;  // of this one
  };
  bool is_plain(const Block& block) const {
    return block.shape && (block.letters & ~plain_letters_) == 0 && !says_again_ && !(stops_.is_mode && stops_.by_block);
  }
  /// The alarm of a word that the other control does not have.
  static Status cannot(std::string_view what);
  Status write_plain(const Block& block, BlockMaker& out);
  const CodeRow* row_of(const Word& word) const;
  void look(const Block& block, Kinds& kinds) const;
  Status statement(const Block& block, BlockMaker& out);
  Status implied_number(const Block& block, const CodeRow& row, BlockMaker& out) const;
  Status said_again(const Kinds& kinds, BlockMaker& out);
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
  std::uint8_t motion_group_ = 0;    // of the codes of `from`
  const CodeRow* motion_ = nullptr;  // in force in the text
  bool motion_is_cycle_ = false;
  struct Stops {
    bool by_block = false, by_mode = false;  // the other control has nothing but this
    bool is_mode = false;                    // exact stops are in force in the text
    bool goes_on = false;                    // behind this block they are not
  } stops_;
  bool is_metric_ = false;  // the other control counts in mm alone
  bool is_inch_ = false, in_section_ = false;
  bool says_again_ = false, says_feed_again_ = false;
  double feed_ = -1;                                // last F of the text
  double tool_ = 0;                                 // last T
  std::array<std::optional<PlainWord>, 26> plain_;  // by letter: what it means depends on nothing else in its block
  std::uint64_t plain_letters_ = 0;                 // those
};

}  // namespace kadr
