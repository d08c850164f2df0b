// Reads plain blocks, which consist only of addresses with decimal numbers. Used by lang/block/block_reader; tested by
// tests/lang/plain_block_test.cpp.

#include "lang/block/plain_block.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "base/powers_of_ten.h"
#include "lang/block/word_reader.h"

namespace kadr {
namespace {

constexpr char letter_of(char c) { return static_cast<char>(c & ~0x20); }

/// Returns true for a name that has letters after a digit and needs no '='. PlainBlocks cannot distinguish such a name from two words (nct
/// 2.2).
bool looks_like_words(const AddressName& name) {
  return std::any_of(name.text.begin(), name.text.end() - 1, is_digit) && !is_digit(name.text.back());
}

/// Addresses of the blocks that need no lang/named: motions with their feed and speed. T, D, H, L, P, R depend on the control's state.
constexpr std::string_view letters_of_plain_named_blocks = "ABCFGIJKMNSUVWXYZ";

constexpr std::ptrdiff_t least_bytes = 8;  // length of the texts in which eight_bytes() may be used

/// Returns the eight bytes from `at` on; the bytes from `end` on count as 0. There are at least eight bytes before `end`, and at != end.
inline std::uint64_t eight_bytes(const char* at, const char* end) {
  std::uint64_t bytes = 0;
  const std::ptrdiff_t left = end - at;
  std::memcpy(&bytes, left >= least_bytes ? at : end - least_bytes, sizeof bytes);
  return left >= least_bytes ? bytes : bytes >> (8 * (least_bytes - left));
}

/// Reads a number of fewer than eight characters at once. `Digits`: PlainBlocks::Digits, which is private. Returns nullptr if the number
/// may be longer. Works on bytes in little-endian order, in which the first character is the lowest byte. The digits are added up in pairs,
/// then in fours, then in eights.
template <class Digits>
const char* short_number(const char* at, const char* end, Digits& digits) {
  constexpr std::uint64_t every = 0x0101010101010101, high_bits = every * 0x80, beyond_nine = every * 0x76;
  const std::uint64_t characters = eight_bytes(at, end) ^ every * std::uint64_t{'0'};  // the digits are now 0 to 9
  const std::uint64_t others = ((characters + beyond_nine) | characters) & high_bits;  // exact up to the first character that is no digit
  if (others == 0) return nullptr;
  const auto whole = static_cast<unsigned>(__builtin_ctzll(others)) / 8;
  unsigned count = whole, size = whole;
  std::uint64_t sum = characters;
  digits.whole = whole;
  if ((characters >> 8 * whole & 0xFFU) == ('.' ^ '0')) {
    const std::uint64_t further = others & (others - 1);
    if (further == 0) return nullptr;
    size = static_cast<unsigned>(__builtin_ctzll(further)) / 8;
    count = size - 1;
    const std::uint64_t before = (std::uint64_t{1} << 8 * whole) - 1;
    sum = (characters & before) | (characters >> 8 & ~before);
    digits.fraction = count - whole;
    digits.has_point = true;
  }
  if (count == 0) return at + size;
  sum <<= 64 - 8 * count;  // leading zeros
  sum = sum * 2561 >> 8 & 0x00FF00FF00FF00FF;
  sum = sum * 6553601 >> 16 & 0x0000FFFF0000FFFF;
  digits.mantissa = sum * 42949672960001 >> 32;
  return at + size;
}

}  // namespace

/// An unsigned number as written: its digits and the decimal point.
struct PlainBlocks::Digits {
  std::uint64_t mantissa = 0;
  std::size_t whole = 0, fraction = 0;
  bool has_point = false;
  std::size_t count() const { return whole + fraction; }
};

PlainBlocks::PlainBlocks(const Grammar& grammar) : grammar_(grammar) {
  // Greatest numbers of digits: a whole number of 15 digits is exact in a double, and one of 9 digits is exact in 32 bits.
  constexpr std::size_t exact_digits = 15, number_digits = 9;
  // Greatest numbers of digits for Grbl, which uses only the first eight digits of a number; seven digits never make a block number too
  // large (spec/grbl 1.3).
  constexpr std::size_t lone_digits = 8, lone_number_digits = 7;
  most_digits_ = grammar.filtered_lines ? lone_digits : exact_digits;
  most_number_digits_ = grammar.filtered_lines ? lone_number_digits : number_digits;
  for (const char c : {' ', '\t', '\r', '\0', '\x7f'}) kinds_[static_cast<unsigned char>(c)] = Kind::blank;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const WordFormat& format = grammar.word(letter);
    Kind kind = letter == 'N' ? Kind::block_number : Kind::word;
    if (!format.known || (format.code && format.implied) || letter == grammar.label_address || letter == grammar.parameter_address)
      kind = Kind::other;
    if (grammar.named_blocks && letters_of_plain_named_blocks.find(letter) == std::string_view::npos) kind = Kind::other;
    if (grammar.klartext_blocks) kind = Kind::other;
    for (const AddressName& name : grammar.names)
      if (name.text.front() == letter && looks_like_words(name)) kind = Kind::other;
    kinds_[static_cast<unsigned char>(letter)] = kind;
    if (grammar.lower_case) kinds_[static_cast<unsigned char>(letter | 0x20)] = kind;
    // An address is easy if its format allows any number of digits and has no further rules; then check_digits (lang/block/word_reader) has
    // nothing to check.
    easy_[static_cast<std::size_t>(letter - 'A')] =
        !format.code && format.whole_digits == 0 && !format.implied && !format.second_number && format.counted == 0;
  }
}

/// Reads digits with at most one decimal point among them, character by character. Returns a pointer to the character after the digits.
inline const char* PlainBlocks::digits_at(const char* at, const char* end, Digits& digits) {
  constexpr unsigned ten = 10;
  const auto digit = [](char c) { return static_cast<unsigned>(static_cast<unsigned char>(c)) - unsigned{'0'}; };
  const char* const first = at;
  std::uint64_t mantissa = 0;
  for (unsigned d; at != end && (d = digit(*at)) < ten; ++at) mantissa = mantissa * ten + d;
  digits.whole = static_cast<std::size_t>(at - first);
  if (at != end && *at == '.') {
    const char* const point = at++;
    for (unsigned d; at != end && (d = digit(*at)) < ten; ++at) mantissa = mantissa * ten + d;
    digits.has_point = true;
    digits.fraction = static_cast<std::size_t>(at - point - 1);
  }
  digits.mantissa = mantissa;
  return at;
}

inline const char* PlainBlocks::block_number(const char* at, const char* end, Block& block) const {
  const char* const begin = block.text.data();
  const WordFormat& format = grammar_.word('N');
  Digits digits;
  const char* const number_end = digits_at(at + 1, end, digits);
  if (block.has_number || block.word_count != 0 || digits.has_point || digits.whole == 0 || digits.whole > most_number_digits_)
    return nullptr;
  if (format.whole_digits != 0 && (digits.whole > format.whole_digits || !format.drop_zeros || format.implied)) return nullptr;
  block.has_number = true;
  block.number = static_cast<std::uint32_t>(digits.mantissa);
  block.number_digits = static_cast<std::uint8_t>(digits.whole);
  block.number_where = {static_cast<std::uint32_t>(at - begin), static_cast<std::uint32_t>(number_end - begin)};
  return number_end;
}

/// Reads the word that starts here, and returns a pointer to the character after it. Returns nullptr if the word is not plain, or faulty.
[[gnu::always_inline]] inline const char* PlainBlocks::word(const char* at, const char* end, Block& block) const {
  const char* const begin = at;
  const char letter = letter_of(*at++);
  const auto address = static_cast<std::size_t>(letter - 'A');
  const WordFormat& format = grammar_.words[address];
  const char sign = at != end && (*at == '-' || *at == '+') ? *at++ : '\0';
  if (sign != 0 && (format.code || !(format.sign || grammar_.custom_macros))) return nullptr;
  Digits digits;
  // The numbers of codes are so short that they are read as quickly digit by digit.
  const bool at_once = std::endian::native == std::endian::little && !format.code && end - block.text.data() >= least_bytes && at != end;
  const char* const after = at_once ? short_number(at, end, digits) : nullptr;
  if (after == nullptr) digits = {};
  at = after != nullptr ? after : digits_at(at, end, digits);
  if (digits.count() == 0 || digits.count() > most_digits_ || block.word_count == limits::block_words) return nullptr;
  const std::uint64_t bit = letter_bit(letter);
  if ((block.letters & bit) == 0) {
    block.letters |= bit;
    block.at[address] = static_cast<std::uint8_t>(block.word_count);
  } else if (!has_room(block, letter, format)) {
    return nullptr;
  }
  Word& w = block.words[block.word_count];
  w.code = -1;
  std::size_t decimals = digits.fraction;
  w.counted = 0;
  if (!easy_[address]) {
    if (!follows(format, digits)) return nullptr;
    if (format.code) w.code = static_cast<std::int32_t>(digits.fraction == 1 ? digits.mantissa : digits.mantissa * 10);
    if (format.implied && !digits.has_point) decimals = format.fraction_digits;
    if (!digits.has_point) decimals += w.counted = format.counted;
    if (format.second_number) w.second = std::numeric_limits<double>::quiet_NaN();
  }
  // The quotient is correctly rounded, because the digits as a whole number and the power of ten are exact.
  const double value = static_cast<double>(digits.mantissa) / powers_of_ten[decimals];
  w.value = sign == '-' ? -value : value;
  w.where = {static_cast<std::uint32_t>(begin - block.text.data()), static_cast<std::uint32_t>(at - block.text.data())};
  w.expression = {};
  w.address = w.written = letter;
  w.digits = static_cast<std::uint8_t>(digits.count());
  w.has_point = digits.has_point;
  w.incremental = w.bare = false;
  block.shape.add(letter, w.code);
  ++block.word_count;
  return at;
}

bool PlainBlocks::read(std::string_view text, std::size_t from, Block& block) const {
  if (read_words(text, from, block)) return true;
  block.has_number = false;
  block.number_digits = 0;
  block.number = block.word_count = 0;
  block.letters = 0;
  block.shape = {};
  return false;
}

bool PlainBlocks::read_words(std::string_view text, std::size_t from, Block& block) const {
  const char* const end = text.data() + text.size();
  const char* at = text.data() + from;
  block.text = text;
  block.where = {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(text.size())};
  while (at != end) {
    switch (kinds_[static_cast<unsigned char>(*at)]) {
      case Kind::blank: ++at; continue;
      case Kind::block_number: at = block_number(at, end, block); break;
      case Kind::word: at = word(at, end, block); break;
      case Kind::other: return false;
    }
    if (at == nullptr) return false;
  }
  if (block.word_count == 0) return !block.has_number || grammar_.block_length == 0;
  if (grammar_.block_number_required && !block.has_number) return false;
  return grammar_.block_length == 0 || text.size() - from <= grammar_.block_length;
}

/// Returns true if the number of digits and the decimal point conform to the format.
bool PlainBlocks::follows(const WordFormat& format, const Digits& digits) {
  constexpr std::uint64_t max_code = 99'999;
  if (format.code && (digits.fraction > 1 || digits.mantissa > max_code || digits.whole < format.code_digits)) return false;
  if (format.whole_digits == 0) return true;
  const bool implied = format.implied && !digits.has_point;
  const std::size_t most = format.whole_digits + (implied ? std::size_t{format.fraction_digits} : 0);
  if ((digits.has_point && !format.point) || digits.whole > most || digits.fraction > format.fraction_digits) return false;
  return format.drop_zeros || digits.has_point || digits.whole >= most;
}

/// Returns true if the format allows one more word with an address that the block already has.
bool PlainBlocks::has_room(const Block& block, char letter, const WordFormat& format) {
  const auto same = [letter](const Word& w) { return w.address == letter; };
  return format.at_most == 0 || std::count_if(block.words.begin(), block.words.begin() + block.word_count, same) < format.at_most;
}

}  // namespace kadr
