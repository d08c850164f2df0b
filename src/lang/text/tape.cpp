// Converts between punched tape, which has rows of eight tracks in the ISO 7-bit code with even parity, and text (2С42 6.1, GOST 20999-83).
// Used by lang/text/tape_orientation; tested by tests/lang/tape_test.cpp.

#include "lang/text/tape.h"

#include <algorithm>
#include <array>
#include <bit>

#include "lang/text/eia.h"
#include "lang/text/encoding.h"
#include "lang/text/end_mark.h"

// The Russian register is KOI-7 Н1. Its codes 0x40..0x7E are the letters of KOI8-R without their eighth bit, ю а б … ч. Ъ would have the
// code of a deleted row, so the register lacks Ъ. Digits and signs, 0x20..0x3F, are the same in both registers.

namespace kadr {
namespace {

constexpr std::uint8_t deleted_row = 0x7F;
constexpr std::uint8_t shift_out = 0x0E;  // to Russian letters
constexpr std::uint8_t shift_in = 0x0F;   // back to Latin letters
constexpr std::uint8_t first_letter = 0x40;
constexpr std::size_t max_faults = 1000;

bool leaves_no_character(std::uint8_t code) {
  return code == 0 || code == '\r' || code == shift_out || code == shift_in || code == deleted_row;
}

/// Returns the code of a letter in the Russian register; 0 if the register lacks the letter.
std::uint8_t russian_code(char32_t letter) {
  static const auto codes = [] {
    std::array<std::uint8_t, 64> table{};
    for (std::uint8_t code = first_letter; code < deleted_row; ++code)
      table[first_character(utf8_of(Encoding::koi8r, code)).code - U'А'] = code;
    return table;
  }();
  return letter >= U'А' && letter <= U'я' ? codes[letter - U'А'] : std::uint8_t{0};
}

/// Writes rows of a tape, and switches the register (Latin or Russian letters) where a character requires this.
class RowWriter {
 public:
  RowWriter(std::string& rows, TapeCode code) : rows_(rows), code_(code) {}

  /// Writes the row of a character. Returns false if the code lacks the character.
  bool write(char32_t letter) {
    if (code_ == TapeCode::eia) {
      const auto row = eia_row(letter);
      if (row) rows_ += static_cast<char>(*row);
      return row.has_value();
    }
    const std::uint8_t russian = russian_code(letter);
    if (russian == 0 && (letter > 0x7F || leaves_no_character(static_cast<std::uint8_t>(letter)))) return false;
    if ((russian != 0) != russian_) put(russian_ ? shift_in : shift_out);
    russian_ = russian != 0;
    put(russian_ ? russian : static_cast<std::uint8_t>(letter));
    return true;
  }

 private:
  void put(std::uint8_t code) { rows_ += static_cast<char>(with_even_parity(code)); }

  std::string& rows_;
  TapeCode code_;
  bool russian_ = false;
};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

void trim_right(std::string_view& line) {
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
}

/// Removes one literal ПС or LF from the end of a line, unless the letters are the end of a word (`SELF`, `КПС`).
bool remove_mark(std::string_view& line) {
  std::string_view rest = line;
  trim_right(rest);
  for (const std::string_view mark : {end_mark_in_text, std::string_view("LF")}) {
    if (!rest.ends_with(mark)) continue;
    rest.remove_suffix(mark.size());
    const auto before = static_cast<unsigned char>(rest.empty() ? ' ' : rest.back());
    // A ПС or LF after a letter, or after the last byte of a non-ASCII letter, is a part of a word and not the end of a block.
    if (before >= 'A' && before != '_') return false;
    trim_right(rest);
    line = rest;
    return true;
  }
  return false;
}

/// Returns a line without the CRs and without the literal ПС or LF at its end. On a tape a row LF replaces these characters.
std::string_view without_end(std::string_view line) {
  while (line.ends_with('\r')) line.remove_suffix(1);
  while (remove_mark(line)) continue;
  return line;
}

}  // namespace

std::uint8_t with_even_parity(std::uint8_t code) {
  const unsigned seven = code & 0x7Fu;
  return static_cast<std::uint8_t>(std::popcount(seven) % 2 == 0 ? seven : seven | 0x80u);
}

bool has_even_parity(std::uint8_t row) { return std::popcount(row) % 2 == 0; }

void TapeLetters::append(std::uint8_t code, std::string& text) {
  if (code == shift_out) russian_ = true;
  if (code == shift_in || code == '\n') russian_ = false;
  if (leaves_no_character(code)) return;
  if (russian_ && code >= first_letter) text += utf8_of(Encoding::koi8r, code);
  else text += static_cast<char>(code);
}

TapeText decode_tape(std::string_view rows, TapeCode code) {
  TapeText tape;
  TapeLetters letters;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<std::uint8_t>(rows[i]);
    if (code == TapeCode::eia) {
      const auto character = eia_character(row);
      if (row == 0 || (character && *character == 0)) continue;
      if (character) {
        tape.text += *character;
        continue;
      }
    } else if (has_even_parity(row)) {
      letters.append(row & 0x7F, tape.text);
      continue;
    }
    tape.text += '?';
    if (tape.faults.size() < max_faults) tape.faults.push_back({i + 1, row});
  }
  return tape;
}

Result<std::string> encode_tape(std::string_view text, std::size_t leader_rows, TapeCode code) {
  std::string rows(leader_rows, '\0');
  RowWriter writer(rows, code);
  const bool bare_cr = text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos;
  const char end_of_line = bare_cr ? '\r' : '\n';
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(end_of_line, begin), text.size());
    const std::string_view line = without_end(text.substr(begin, end - begin));
    for (std::size_t i = 0; i < line.size();) {
      const Character character = first_character(line.substr(i));
      if (character.size == 0 || !writer.write(character.code)) {
        const std::size_t size = std::max<std::size_t>(character.size, 1);
        const Span where{static_cast<std::uint32_t>(begin + i), static_cast<std::uint32_t>(begin + i + size)};
        return fail(alarm(AlarmId::bad_encoding, where, line.substr(i, size)));
      }
      i += character.size;
    }
    writer.write('\n');
    begin = end + 1;
  }
  rows.append(leader_rows, '\0');
  return rows;
}

}  // namespace kadr
