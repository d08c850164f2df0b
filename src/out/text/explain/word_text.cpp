// Explains the words of a code, for commands such as `kadr explain nct G81`. Used by out/text/explain/code_page.

#include "out/text/explain/word_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/code_literals.h"
#include "out/text/explain/cycle_text.h"

namespace kadr {
namespace {

/// The meaning of a letter in blocks with one function; for addresses with several meanings.
struct Meaning {
  Function function;
  char letter;
  WordUnit unit;
  std::string_view en, ru;
};

// nct 18.0: drilling; 15.5.1: radius_side. Mach3 10.7.22 to 10.7.24: cycle.
constexpr Meaning meanings[] = {
    {Function::drilling, 'R', WordUnit::length, "point R: coordinate, in G91 the distance from the initial point",
     "точка R: координата, в G91 расстояние от исходной точки"},
    {Function::drilling, 'Q', WordUnit::length, "depth of one peck, positive", "глубина за один проход, положительная"},
    {Function::drilling, 'E', WordUnit::length, "way back between pecks, clearance before the next one",
     "отвод между проходами, недоход перед следующим"},
    {Function::drilling, 'P', WordUnit::none, "dwell at the bottom, s; in G95 revolutions of the spindle",
     "выдержка на дне, с; в G95 обороты шпинделя"},
    {Function::drilling, 'L', WordUnit::none, "number of repetitions", "число повторений"},
    {Function::drilling, 'I', WordUnit::length, "shift of the oriented tool along X, incremental",
     "смещение ориентированного инструмента по X, в приращениях"},
    {Function::drilling, 'J', WordUnit::length, "shift of the oriented tool along Y, incremental",
     "смещение ориентированного инструмента по Y, в приращениях"},
    {Function::drilling, 'K', WordUnit::length, "shift of the oriented tool along Z, incremental",
     "смещение ориентированного инструмента по Z, в приращениях"},
    {Function::radius_side, 'I', WordUnit::length, "direction of the way in, along X", "направление подхода по X"},
    {Function::radius_side, 'J', WordUnit::length, "direction of the way in, along Y", "направление подхода по Y"},
    {Function::radius_side, 'K', WordUnit::length, "direction of the way in, along Z", "направление подхода по Z"},
    {Function::cycle, 'Z', WordUnit::length, "bottom of the hole (G17): coordinate, in G91 the distance from R",
     "дно отверстия (G17): координата, в G91 расстояние от R"},
    {Function::cycle, 'R', WordUnit::length, "level R: coordinate, in G91 the distance from where the tool stands",
     "уровень R: координата, в G91 расстояние от положения инструмента"},
    {Function::cycle, 'Q', WordUnit::length, "depth of one peck, positive", "глубина за один проход, положительная"},
    {Function::cycle, 'P', WordUnit::none, "dwell at the bottom, s", "выдержка на дне, с"},
    {Function::cycle, 'L', WordUnit::none, "number of repetitions", "число повторений"},
    {Function::cycle, 'I', WordUnit::length, "shift in the plane, first axis", "смещение в плоскости по первой оси"},
    {Function::cycle, 'J', WordUnit::length, "shift in the plane, second axis", "смещение в плоскости по второй оси"},
    {Function::cycle, 'K', WordUnit::length, "upper end of the back boring: coordinate, in G91 the distance from the bottom",
     "верх обратного растачивания: координата, в G91 расстояние от дна"},
};

std::string_view unit_of(WordUnit unit, Lang lang) {
  const bool ru = lang == Lang::ru;
  if (unit == WordUnit::length) return ru ? ", мм (дюйм)" : ", mm (inch)";
  if (unit == WordUnit::angle) return ru ? ", градусы" : ", degrees";
  return "";
}

bool is_tap(const CodeRow& code) { return code.arg == 84.2_g || code.arg == 84.3_g; }

/// Returns the meaning of a letter on the controls on which it differs from the NCT.
std::optional<Meaning> drilling_meaning(const ControlDef& def, const CodeRow& code, char letter) {
  using enum WordUnit;
  const std::uint64_t used = words_used(code);
  const bool pecks = (used >> ('Q' - 'A') & 1u) != 0, shifts = (used >> ('K' - 'A') & 1u) != 0;
  if (letter == 'K' && def.behaviour.repeats_by_k) return Meaning{code.function, letter, none, "number of repetitions", "число повторений"};
  if (letter == 'Q' && shifts && def.behaviour.shifts_by_q())
    return Meaning{code.function, letter, length, "shift of the oriented tool, positive",
                   "смещение ориентированного инструмента, положительное"};
  if (!pecks || is_tap(code) || def.behaviour.cycle_words != CycleWords::pecks_by_ijk) return std::nullopt;
  switch (letter) {
    case 'I': return Meaning{code.function, letter, length, "depth of the first peck, without Q", "глубина первого прохода, без Q"};
    case 'J': return Meaning{code.function, letter, length, "how much less each next peck is", "на сколько каждый следующий проход меньше"};
    case 'K': return Meaning{code.function, letter, length, "depth of the smallest peck", "глубина наименьшего прохода"};
    default: return std::nullopt;
  }
}

/// Returns the letters that the canned cycle uses on this control.
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
  const bool ru = lang == Lang::ru;
  if (code.function == Function::drilling)
    if (const auto own = drilling_meaning(def, code, letter)) return fmt::format("{}{}", ru ? own->ru : own->en, unit_of(own->unit, lang));
  const auto* const found = std::find_if(std::begin(meanings), std::end(meanings),
                                         [&](const Meaning& one) { return one.function == code.function && one.letter == letter; });
  if (found != std::end(meanings)) return fmt::format("{}{}", ru ? found->ru : found->en, unit_of(found->unit, lang));
  const AddressRow& row = def.address(letter);
  return fmt::format("{}{}", ru && !row.text.ru.empty() ? row.text.ru : row.text.en, unit_of(row.unit, lang));
}

std::string words_text(const ControlDef& def, const CodeRow& row, Lang lang) {
  const bool ru = lang == Lang::ru;
  const bool drills = row.function == Function::drilling;
  std::string text;
  if (drills)
    text += fmt::format("    {}{}\n", ru ? "оси" : "axes",
                        ru ? ": отверстие в плоскости; ось сверления: дно, в G91 расстояние от R, мм (дюйм)"
                           : ": the hole in the plane; the drilling axis: the bottom, in G91 the distance from R, mm (inch)");
  const std::uint64_t used = used_letters(def, row);
  std::string idle;
  for (int i = 0; i <= comma_vector - 'A'; ++i) {
    if (((row.takes | number_words(def, row)) >> i & 1u) == 0) continue;
    const char letter = static_cast<char>('A' + i);
    const std::string name = address_written(letter);
    if ((used >> i & 1u) == 0) idle += (idle.empty() ? "" : " ") + name;
    else text += fmt::format("    {:<3}{}\n", name, meaning_of(def, row, letter, lang));
  }
  if ((drills || row.function == Function::cycle) && def.address('F').function != Function::count)  // F belongs to the block, not the code
    text += fmt::format("    {:<3}{}\n", "F", meaning_of(def, row, 'F', lang));
  if (!idle.empty()) text += fmt::format("    {}: {}\n", ru ? "не используются этим циклом" : "not used by this cycle", idle);
  return text;
}

}  // namespace kadr
