#pragma once
// BlockMaker: blocks of one control, word by word, as its file says they are written: numbers, end, comments, signs at the beginning.

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "config/control_def.h"
#include "out/program/codes.h"
#include "out/program/words.h"

namespace kadr {

/// Bytes of a program that is made: some ten million blocks. It is held in memory while it is proven.
constexpr std::size_t most_made = std::size_t{256} << 20;
/// conversion_too_long.
Alarm too_long();

class BlockMaker {
 public:
  /// `put` gets the text, line by line, UTF-8. False: it has no room for it.
  BlockMaker(const ControlDef& def, std::function<bool(std::string_view)> put) : def_(def), put_(std::move(put)) {}

  const ControlDef& def() const { return def_; }
  /// The signs before the first block.
  void begin();
  /// … and behind the last one.
  void close();
  /// "O0012", with as many digits as the control's programs have.
  std::string program_label(std::uint32_t number) const;

  /// One more code in the block.
  ///   alarms  function_has_no_code
  Status code(std::initializer_list<Wanted> wanted);
  /// … if the control has it. False: it has not.
  bool code_if_there(std::initializer_list<Wanted> wanted);
  /// A word, its value in mm, degrees, s, … as the address counts it; a feed or speed, where the control codes them, as the code that
  /// stands for it.
  ///   more    decimals, where the address has any number of them: of inches one
  ///   alarms  word_has_no_room; word_below_format  of F: it would be 0
  Status word(char letter, double value, int more = 0);
  /// The same of an address whose form is known.
  Status word(const Words& form, double value);
  /// A time, s: with P milliseconds where the control counts those (spec/fanuc 4.1, spec/haas 4.1).
  Status seconds_word(char letter, double seconds);
  /// … with the letter that this code of a dwell takes.
  ///   alarms  function_has_no_code  it takes none
  Status dwell_word(const CodeRow& row, double seconds);
  bool has_word(char letter) const { return def_.grammar.word(letter).known; }
  /// A code, already written. Where the block holds as many as it may, and nothing but codes, those are a block before.
  Status code_text(std::string_view code);
  /// As it stands, already written.
  void text(std::string_view word);
  /// In the block's brackets; what must not stand there is left out.
  void comment(std::string_view what);
  /// `number`: N of the block, where the program had one; 0: none.
  void set_number(std::uint32_t number) { wanted_number_ = number; }
  void set_skip(std::uint8_t skip) { skip_ = skip; }
  /// What stands in the block so far is not written.
  void drop() { words_.clear(), comment_.clear(), wanted_number_ = 0, skip_ = 0; }
  /// The next blocks are those of a subprogram whose number is the first digits of theirs (spec/s2c42 3): 2 of N02001.
  void begin_section(std::uint32_t number) {
    if (section_ == 0) number_before_ = last_number_;
    section_ = number, last_number_ = number * section_blocks;
  }
  /// They are over.
  ///   returns  the number of the last one
  std::uint32_t end_section() {
    section_ = 0;
    return std::exchange(last_number_, number_before_);
  }
  bool empty() const { return words_.empty() && comment_.empty(); }
  /// The block is over.
  ///   alarms  word_has_no_room  of N, where every block needs one; conversion_too_long
  Status end();
  std::size_t blocks() const { return blocks_; }

  static constexpr std::uint32_t section_blocks = 1000;  // numbers of a subprogram's blocks

 private:
  Status number(std::string& line);
  bool is_full_of_codes(char letter) const;

  const ControlDef& def_;
  std::function<bool(std::string_view)> put_;
  std::string words_, comment_;
  std::string line_;  // keeps its memory
  std::uint32_t wanted_number_ = 0, last_number_ = 0;
  std::uint32_t section_ = 0, number_before_ = 0;  // 0: none; of the block before it
  std::uint8_t skip_ = 0;
  std::size_t blocks_ = 0;
};

}  // namespace kadr
