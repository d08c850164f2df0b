#pragma once
// PlainBlocks: reads plain blocks, which consist only of addresses with decimal numbers. Most blocks of a long program are plain.

#include <array>
#include <string_view>

#include "lang/block/block.h"
#include "lang/block/grammar.h"

namespace kadr {

/// Reads plain blocks. All other blocks, and every fault, are left to lex_block (lang/block/lexer).
///   law  a block read here equals, word for word, the result of lex_block
class PlainBlocks {
 public:
  explicit PlainBlocks(const Grammar& grammar);

  /// Reads the block that starts at `from` and ends at the end of the text.
  ///   block    cleared by the caller; this function sets its text, where, words and shape
  ///   returns  false if the block is not plain; then `block` is unchanged, except for the contents of its words
  bool read(std::string_view text, std::size_t from, Block& block) const;

 private:
  enum class Kind : std::uint8_t { other, blank, block_number, word };
  struct Digits;

  static const char* digits_at(const char* at, const char* end, Digits& digits);
  const char* block_number(const char* at, const char* end, Block& block) const;
  const char* word(const char* at, const char* end, Block& block) const;
  static bool follows(const WordFormat& format, const Digits& digits);
  static bool has_room(const Block& block, char letter, const WordFormat& format);
  bool read_words(std::string_view text, std::size_t from, Block& block) const;

  const Grammar& grammar_;
  std::array<Kind, 256> kinds_{};           // by character
  std::array<bool, max_addresses> easy_{};  // by address: true if any number of digits is allowed
  std::size_t most_digits_ = 0;             // greatest number of digits of a value
  std::size_t most_number_digits_ = 0;      // greatest number of digits of a block number
};

}  // namespace kadr
