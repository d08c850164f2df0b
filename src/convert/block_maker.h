#pragma once
// BlockMaker: writes the blocks of one control word by word, in the form that the control's file defines: number formats, ends of blocks,
// comments, leading characters.

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "config/control/control_def.h"
#include "out/program/codes.h"
#include "out/program/words.h"

namespace kadr {

/// The greatest size in bytes of a converted program: some ten million blocks. The text is in memory until it is proven.
constexpr std::size_t max_made = std::size_t{256} << 20;
/// Returns the alarm conversion_too_long, which reports that a converted program exceeds max_made.
Alarm too_long();

class BlockMaker {
 public:
  ///   put  receives the text line by line, UTF-8; returns false if it cannot store the line
  BlockMaker(const ControlDef& def, std::function<bool(std::string_view)> put) : def_(def), put_(std::move(put)) {}

  const ControlDef& def() const { return def_; }
  /// Writes the characters that the control expects before the first block.
  void begin();
  /// Writes the characters that the control expects after the last block.
  void close();
  /// Returns the program number as a word: "O0012", with as many digits as the control's program numbers have.
  std::string program_label(std::uint32_t number) const;

  /// Adds to the block the code with which the control calls one of these functions.
  ///   alarms  function_has_no_code
  Status code(std::initializer_list<FunctionArg> functions);
  /// Like code(), but returns false and adds nothing if the control has no such code.
  bool code_if_there(std::initializer_list<FunctionArg> functions);
  /// Adds a word. `value` is in the unit of the address: mm, degrees, s, … A feed or speed is replaced by its code if the control has a
  /// table of codes for it.
  ///   more    additional decimals if the format allows any number of decimals; 1 if the lengths are in inches
  ///   alarms  word_has_no_room; word_below_format if an F would become 0
  Status word(char letter, double value, int more = 0);
  /// Like word() above, for an address whose word format has been looked up already.
  Status word(const Words& form, double value);
  /// Adds a time in s. If the control requires it, the word P is written in milliseconds (spec/fanuc 4.1, spec/haas 4.1).
  Status seconds_word(char letter, double seconds);
  /// Adds a time in s with the address letter that the dwell code of this row uses.
  ///   alarms  function_has_no_code  if the code has no time word
  Status dwell_word(const CodeRow& row, double seconds);
  bool has_word(char letter) const { return def_.grammar.word(letter).known; }
  /// Adds a code that is already formatted. If the block already has as many codes as the control allows, and no other words, those codes
  /// are first written as a block of their own.
  Status code_text(std::string_view code);
  /// Adds, unchanged, a word that is already formatted.
  void text(std::string_view word);
  /// Adds a comment in brackets. Characters that the control does not allow in a comment are removed.
  void comment(std::string_view what);
  ///   number  block number N, if the program has block numbers; 0: none
  void set_number(std::uint32_t number) { requested_number_ = number; }
  void set_skip(std::uint8_t skip) { skip_ = skip; }
  /// Discards the words that were added since the last end of block.
  void drop() { words_.clear(), comment_.clear(), requested_number_ = 0, skip_ = 0; }
  /// Begins a subprogram, to which the next blocks belong. Its number is the leading digits of their block numbers (spec/s2c42 3): 2 in
  /// N02001.
  void begin_section(std::uint32_t number) {
    if (section_ == 0) number_before_ = last_number_;
    section_ = number, last_number_ = number * section_blocks;
  }
  /// Ends the subprogram, so that the next blocks belong to the program.
  ///   returns  the number of its last block
  std::uint32_t end_section() {
    section_ = 0;
    return std::exchange(last_number_, number_before_);
  }
  bool empty() const { return words_.empty() && comment_.empty(); }
  /// Ends the block and writes it.
  ///   alarms  word_has_no_room  if each block needs an N and N has too few digits; conversion_too_long
  Status end();
  std::size_t blocks() const { return blocks_; }

  static constexpr std::uint32_t section_blocks = 1000;  // block numbers per subprogram

 private:
  Status number(std::string& line);
  bool is_full_of_codes(char letter) const;

  const ControlDef& def_;
  std::function<bool(std::string_view)> put_;
  std::string words_, comment_;
  std::string line_;  // text of the line; a member so that its memory is reused
  std::uint32_t requested_number_ = 0, last_number_ = 0;
  std::uint32_t section_ = 0, number_before_ = 0;  // number of the subprogram, 0: none; last block number before the subprogram began
  std::uint8_t skip_ = 0;
  std::size_t blocks_ = 0;
};

}  // namespace kadr
