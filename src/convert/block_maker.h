#pragma once
// BlockMaker: writes blocks of one control word by word, in the form that the control's file defines: numbers, ends, comments, characters
// at the beginning.

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "config/control_def.h"
#include "out/program/codes.h"
#include "out/program/words.h"

namespace kadr {

/// The most bytes of a program written: some ten million blocks. It is kept in memory while it is proven.
constexpr std::size_t most_made = std::size_t{256} << 20;
/// Returns the alarm conversion_too_long.
Alarm too_long();

class BlockMaker {
 public:
  ///   put  receives the text line by line, UTF-8, and returns false if it has no room for it
  BlockMaker(const ControlDef& def, std::function<bool(std::string_view)> put) : def_(def), put_(std::move(put)) {}

  const ControlDef& def() const { return def_; }
  /// Writes the characters before the first block.
  void begin();
  /// Writes the characters after the last block.
  void close();
  /// Returns "O0012", with as many digits as the control's program numbers have.
  std::string program_label(std::uint32_t number) const;

  /// Adds a code to the block.
  ///   alarms  function_has_no_code
  Status code(std::initializer_list<Wanted> wanted);
  /// Adds the code if the control has it, else returns false.
  bool code_if_there(std::initializer_list<Wanted> wanted);
  /// Adds a word, its value in mm, degrees, s, … as the address counts it. A feed or speed is written as its code if the control has a
  /// table of codes.
  ///   more    extra decimals, where the address allows any number of them: one for inches
  ///   alarms  word_has_no_room; word_below_format  for an F that would become 0
  Status word(char letter, double value, int more = 0);
  /// The same for an address whose form is known.
  Status word(const Words& form, double value);
  /// Adds a time in s; P counts milliseconds on controls that do so (spec/fanuc 4.1, spec/haas 4.1).
  Status seconds_word(char letter, double seconds);
  /// The same with the letter that this dwell code uses.
  ///   alarms  function_has_no_code  if the code has no time word
  Status dwell_word(const CodeRow& row, double seconds);
  bool has_word(char letter) const { return def_.grammar.word(letter).known; }
  /// Adds a code that is already in written form. If the block has as many codes as it may and nothing else, they become a block of their
  /// own before this one.
  Status code_text(std::string_view code);
  /// Adds a word that is already in written form, unchanged.
  void text(std::string_view word);
  /// Adds a comment in brackets; characters that must not be in a comment are left out.
  void comment(std::string_view what);
  ///   number  N of the block, if the program has one; 0: none
  void set_number(std::uint32_t number) { wanted_number_ = number; }
  void set_skip(std::uint8_t skip) { skip_ = skip; }
  /// Discards the block so far.
  void drop() { words_.clear(), comment_.clear(), wanted_number_ = 0, skip_ = 0; }
  /// The next blocks belong to a subprogram whose number is the leading digits of their block numbers (spec/s2c42 3): 2 of N02001.
  void begin_section(std::uint32_t number) {
    if (section_ == 0) number_before_ = last_number_;
    section_ = number, last_number_ = number * section_blocks;
  }
  /// Ends the subprogram.
  ///   returns  the number of its last block
  std::uint32_t end_section() {
    section_ = 0;
    return std::exchange(last_number_, number_before_);
  }
  bool empty() const { return words_.empty() && comment_.empty(); }
  /// Ends the block.
  ///   alarms  word_has_no_room  of N, where every block needs one; conversion_too_long
  Status end();
  std::size_t blocks() const { return blocks_; }

  static constexpr std::uint32_t section_blocks = 1000;  // block numbers per subprogram

 private:
  Status number(std::string& line);
  bool is_full_of_codes(char letter) const;

  const ControlDef& def_;
  std::function<bool(std::string_view)> put_;
  std::string words_, comment_;
  std::string line_;  // a member to keep its memory
  std::uint32_t wanted_number_ = 0, last_number_ = 0;
  std::uint32_t section_ = 0, number_before_ = 0;  // 0: none; the last block number before the section
  std::uint8_t skip_ = 0;
  std::size_t blocks_ = 0;
};

}  // namespace kadr
