#pragma once
// Blocks of nothing but plain words: an address and a decimal number, one after the other. Most blocks of a long program are such.

#include <array>
#include <string_view>

#include "lang/block/block.h"
#include "lang/block/grammar.h"

namespace kadr {

/// Reads what is plain and says so; all else, and every fault, is for lex_block (lang/block/lexer).
///   law  a block read here is, word for word, what lex_block makes of it
class PlainBlocks {
 public:
  explicit PlainBlocks(const Grammar& grammar);

  /// Reads the block that begins at `from` and ends with the text.
  ///   block    cleared by the caller; its text, where, words and shape are set here
  ///   returns  false: it is not plain; the block is as it was, but for what its words hold
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
  std::array<Kind, 256> kinds_{};            // by character
  std::array<bool, most_addresses> easy_{};  // any digits will do
  std::size_t most_digits_ = 0;              // of a value
  std::size_t most_number_digits_ = 0;       // of a block number
};

}  // namespace kadr
