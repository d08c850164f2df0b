// Explains the words of a code, for commands such as `kadr explain nct G81`. This file is used by out/text/explain/code_page.

#include "out/text/explain/word_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/code_literals.h"
#include "out/text/explain/cycle_text.h"
#include "out/text/in_language.h"
#include "texts/explain_words.h"

namespace kadr {
namespace {

namespace word_ids = texts::explain_words;

/// The meaning of a letter in blocks with a code of this function, e.g. Q in a drilling block. The meanings are listed for letters that
/// have several.
struct Meaning {
  Function function;
  char letter;
  WordUnit unit;
  PlainText text;
};

// Sources of the meanings: nct 18.0 for drilling codes, nct 15.5.1 for codes of cutter compensation, Mach3 10.7.22 to 10.7.24 for codes of
// other cycles.
constexpr Meaning meanings[] = {
    {Function::drilling, 'R', WordUnit::length, word_ids::point_r},
    {Function::drilling, 'Q', WordUnit::length, word_ids::peck_depth},
    {Function::drilling, 'E', WordUnit::length, word_ids::way_between_pecks},
    {Function::drilling, 'P', WordUnit::none, word_ids::dwell_or_revolutions},
    {Function::drilling, 'L', WordUnit::none, word_ids::repetitions},
    {Function::drilling, 'I', WordUnit::length, word_ids::shift_along_x},
    {Function::drilling, 'J', WordUnit::length, word_ids::shift_along_y},
    {Function::drilling, 'K', WordUnit::length, word_ids::shift_along_z},
    {Function::radius_side, 'I', WordUnit::length, word_ids::way_in_along_x},
    {Function::radius_side, 'J', WordUnit::length, word_ids::way_in_along_y},
    {Function::radius_side, 'K', WordUnit::length, word_ids::way_in_along_z},
    {Function::cycle, 'Z', WordUnit::length, word_ids::bottom_of_hole},
    {Function::cycle, 'R', WordUnit::length, word_ids::level_r},
    {Function::cycle, 'Q', WordUnit::length, word_ids::peck_depth},
    {Function::cycle, 'P', WordUnit::none, word_ids::dwell_at_bottom},
    {Function::cycle, 'L', WordUnit::none, word_ids::repetitions},
    {Function::cycle, 'I', WordUnit::length, word_ids::shift_along_first_axis},
    {Function::cycle, 'J', WordUnit::length, word_ids::shift_along_second_axis},
    {Function::cycle, 'K', WordUnit::length, word_ids::end_of_back_boring},
};

std::string with_unit(const std::string& text, WordUnit unit, Lang lang) {
  if (unit == WordUnit::length) return translated_in(lang, word_ids::length_in_unit, text);
  if (unit == WordUnit::angle) return translated_in(lang, word_ids::angle_in_degrees, text);
  return text;
}

std::string meaning_text(const Meaning& meaning, Lang lang) { return with_unit(plain_text(meaning.text, lang), meaning.unit, lang); }

bool is_tap(const CodeRow& code) { return code.arg == 84.2_g || code.arg == 84.3_g; }

/// Returns the meaning of a letter in a drilling block if this control differs from the NCT; nullopt otherwise.
std::optional<Meaning> drilling_meaning(const ControlDef& def, const CodeRow& code, char letter) {
  using enum WordUnit;
  const std::uint64_t used = words_used(code);
  const bool pecks = (used >> ('Q' - 'A') & 1u) != 0, shifts = (used >> ('K' - 'A') & 1u) != 0;
  if (letter == 'K' && def.behaviour.repeats_by_k) return Meaning{code.function, letter, none, word_ids::repetitions};
  if (letter == 'Q' && shifts && def.behaviour.shifts_by_q()) return Meaning{code.function, letter, length, word_ids::shift_of_tool};
  if (!pecks || is_tap(code) || def.behaviour.cycle_words != CycleWords::pecks_by_ijk) return std::nullopt;
  switch (letter) {
    case 'I': return Meaning{code.function, letter, length, word_ids::first_peck};
    case 'J': return Meaning{code.function, letter, length, word_ids::decrease_of_pecks};
    case 'K': return Meaning{code.function, letter, length, word_ids::smallest_peck};
    default: return std::nullopt;
  }
}

/// Returns the letters that the canned cycle uses on this control, as a bit set.
std::uint64_t used_letters(const ControlDef& def, const CodeRow& row) {
  std::uint64_t used = words_used(row);
  if (row.function != Function::drilling) return used;
  for (int i = 0; i <= 'Z' - 'A'; ++i)
    if (drilling_meaning(def, row, static_cast<char>('A' + i))) used |= std::uint64_t{1} << i;
  return used;
}

}  // namespace

std::uint64_t number_words(const ControlDef& def, const CodeRow& row) {
  const Function wanted = row.function == Function::radius_side   ? Function::radius_number
                          : row.function == Function::length_comp ? Function::length_number
                                                                  : Function::count;
  std::uint64_t letters = 0;
  for (const AddressRow& address : def.addresses)
    if (wanted != Function::count && address.function == wanted) letters |= std::uint64_t{1} << (address.letter - 'A');
  return letters;
}

std::string meaning_of(const ControlDef& def, const CodeRow& code, char letter, Lang lang) {
  if (code.function == Function::drilling)
    if (const auto own = drilling_meaning(def, code, letter)) return meaning_text(*own, lang);
  const auto* const found = std::find_if(std::begin(meanings), std::end(meanings),
                                         [&](const Meaning& one) { return one.function == code.function && one.letter == letter; });
  if (found != std::end(meanings)) return meaning_text(*found, lang);
  const AddressRow& row = def.address(letter);
  return with_unit(in_language(row.text, lang), row.unit, lang);
}

std::string words_text(const ControlDef& def, const CodeRow& row, Lang lang) {
  const bool drills = row.function == Function::drilling;
  std::string text;
  if (drills) text += fmt::format("    {}\n", plain_text(word_ids::axes_of_drilling, lang));
  const std::uint64_t used = used_letters(def, row);
  std::string idle;
  for (int i = 0; i <= comma_vector - 'A'; ++i) {
    if (((row.takes | number_words(def, row)) >> i & 1u) == 0) continue;
    const char letter = static_cast<char>('A' + i);
    const std::string name = address_written(letter);
    if ((used >> i & 1u) == 0) idle += (idle.empty() ? "" : " ") + name;
    else text += fmt::format("    {:<3}{}\n", name, meaning_of(def, row, letter, lang));
  }
  // the word F belongs to the block and not to the code of the cycle, so its line is added separately
  if ((drills || row.function == Function::cycle) && def.address('F').function != Function::count)
    text += fmt::format("    {:<3}{}\n", "F", meaning_of(def, row, 'F', lang));
  if (!idle.empty()) text += fmt::format("    {}\n", translated_in(lang, word_ids::not_used, idle));
  return text;
}

}  // namespace kadr
