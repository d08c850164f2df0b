// Detects the image of a punched tape, its code, and the orientation in which the tape was read. Used by cli, lang; tested by
// tests/lang/tape_orientation_test.cpp.

#include "lang/text/tape_orientation.h"

#include <algorithm>

#include "base/ascii.h"
#include "lang/text/eia.h"

namespace kadr {
namespace {

constexpr double least_valid = 0.95;   // least fraction of valid rows (0 to 1); it is below 1, because a torn tape has some invalid rows
constexpr std::size_t least_rows = 8;  // least number of rows; with fewer rows a match may be chance
// Least number of rows for a tape in a wrong orientation. Eight variants are tried, so chance matches are more probable.
constexpr std::size_t least_turned = 16;
// The least difference, as a fraction of all pairs, by which pairs "address, number" must outnumber pairs "number, address". With this
// difference the orientation is certain.
constexpr double sure = 0.1;
constexpr std::size_t looked_at = 64 * 1024;

std::uint8_t mirrored(std::uint8_t row) {
  unsigned from = row, to = 0;
  for (int track = 0; track < 8; ++track, from >>= 1) to = to << 1 | (from & 1u);
  return static_cast<std::uint8_t>(to);
}

/// Returns the meaning of a row in a code: a character, or 0 for a row without a character; nullopt if the code has no such row.
std::optional<char> character_of(TapeCode code, std::uint8_t row) {
  if (code == TapeCode::eia) return has_odd_parity(row) ? eia_character(row) : std::nullopt;
  if (!has_even_parity(row)) return std::nullopt;
  const int c = row & 0x7F;
  constexpr int first_register = 0x0E, last_register = 0x0F;
  if (c < ' ' && !(c >= '\t' && c <= '\r') && c != first_register && c != last_register) return std::nullopt;
  return static_cast<char>(c);
}

/// A measure of how similar the rows are to a program in a given code.
struct Likeness {
  bool is_tape = false;
  // Measure of the order in words, from -1 (numbers are before their addresses) to 1 (addresses are before their numbers).
  double forward = 0;
};

Likeness likeness(std::string_view rows, TapeCode code, std::size_t least_count) {
  std::size_t count = 0, valid = 0, digits = 0, forward = 0, backward = 0;
  char last = '\n';
  for (const char byte : rows) {
    if (byte == 0) continue;
    ++count;
    const auto c = character_of(code, static_cast<std::uint8_t>(byte));
    if (!c) continue;
    ++valid;
    if (*c == 0 || *c == ' ') continue;
    digits += is_digit(*c) ? 1u : 0u;
    const bool sign = *c == '+' || *c == '-', last_sign = last == '+' || last == '-';
    forward += is_capital(last) && (is_digit(*c) || sign) ? 1u : 0u;
    forward += last == '\n' && (is_capital(*c) || *c == '%') ? 1u : 0u;
    backward += (is_digit(last) || last_sign) && is_capital(*c) ? 1u : 0u;
    backward += *c == '\n' && is_capital(last) ? 1u : 0u;
    last = *c;
  }
  Likeness like;
  like.is_tape = count >= least_count && digits > 0 && static_cast<double>(valid) >= least_valid * static_cast<double>(count);
  const std::size_t pairs = forward + backward;
  if (pairs > 0) like.forward = (static_cast<double>(forward) - static_cast<double>(backward)) / static_cast<double>(pairs);
  return like;
}

}  // namespace

std::optional<TapeFinding> inspect_tape(std::string_view rows) {
  rows = rows.substr(0, looked_at);
  std::optional<TapeFinding> best;
  double most = -2;
  for (const TapeCode code : {TapeCode::iso, TapeCode::eia})
    for (const TapeOrientation orientation :
         {TapeOrientation::right, TapeOrientation::wrong_end, TapeOrientation::wrong_side, TapeOrientation::both}) {
      const bool right = orientation == TapeOrientation::right;
      const Likeness like = right ? likeness(rows, code, least_rows) : likeness(turned(rows, orientation), code, least_turned);
      if (!like.is_tape) continue;
      if (right && like.forward > 0) return TapeFinding{code, orientation};
      if (!right && like.forward < sure) continue;
      if (like.forward <= most) continue;
      most = like.forward;
      best = TapeFinding{code, orientation};
    }
  return best;
}

std::string turned(std::string_view rows, TapeOrientation orientation) {
  std::string there(rows);
  if (orientation == TapeOrientation::wrong_end || orientation == TapeOrientation::both) std::reverse(there.begin(), there.end());
  if (orientation == TapeOrientation::wrong_side || orientation == TapeOrientation::both)
    for (char& row : there) row = static_cast<char>(mirrored(static_cast<std::uint8_t>(row)));
  return there;
}

std::string_view name_of(TapeOrientation orientation) {
  switch (orientation) {
    case TapeOrientation::wrong_end: return "wrong end";
    case TapeOrientation::wrong_side: return "wrong side";
    case TapeOrientation::both: return "wrong end, wrong side";
    default: return "right";
  }
}

}  // namespace kadr
