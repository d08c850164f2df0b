// Names the methods of a conversion, and describes why a method was not used. Used by cli/convert and view/page/page_conversion; tested by
// tests/convert.py and tests/serve_convert.py.

#include "convert/conversion_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/comparison_text.h"
#include "config/language.h"
#include "out/text/alarm_print.h"
#include "texts/conversion.h"

namespace kadr {
namespace {

/// Returns the text for a function: "M6 (tool change)" if a code of the control has the function, "T" if a word has it, else the engine's
/// name of the function.
std::string function_in_words(std::string_view name, const ControlDef& def) {
  const Function function = function_named(name);
  if (function == Function::count) return std::string(name);
  const auto does = [&](const auto& row) { return row.function == function; };
  if (std::count_if(def.codes.begin(), def.codes.end(), does) == 1) {
    const CodeRow& row = *std::find_if(def.codes.begin(), def.codes.end(), does);
    return fmt::format("{} ({})", row.code, in_thread_language(row.text.en, row.text.ru));
  }
  const auto word = std::find_if(def.addresses.begin(), def.addresses.end(), does);
  return word == def.addresses.end() ? std::string(name) : std::string(1, word->letter);
}

std::string cannot_express(const Alarm& alarm, const ConversionSides& sides) {
  const Lang lang = thread_language();
  if (alarm.id != AlarmId::function_has_no_code) return sides.of_target.sentence(alarm, lang);
  std::string sentence = sides.of_target.pattern(alarm.id, lang);
  constexpr std::string_view argument = "{0}";
  if (const auto at = sentence.find(argument); at != sentence.npos)
    sentence.replace(at, argument.size(), function_in_words(alarm.args[0].text(), sides.from));
  return sentence;
}

}  // namespace

std::string method_in_words(ConvertedAs as) {
  switch (as) {
    case ConvertedAs::as_it_stands: return translated(texts::conversion::as_it_stands);
    case ConvertedAs::words: return translated(texts::conversion::word_by_word);
    case ConvertedAs::contours: return translated(texts::conversion::with_codes);
    case ConvertedAs::lengths: return translated(texts::conversion::with_centre_path);
    case ConvertedAs::plain: return translated(texts::conversion::with_all_offsets);
  }
  return {};
}

const char* name_of(ConvertedAs as) {
  switch (as) {
    case ConvertedAs::as_it_stands: return "as_it_stands";
    case ConvertedAs::words: return "words";
    case ConvertedAs::contours: return "contours";
    case ConvertedAs::lengths: return "lengths";
    case ConvertedAs::plain: return "plain";
  }
  return "";
}

ConversionRefusal refusal_of(const ConversionTry& one, const ConversionSides& sides) {
  const Lang lang = thread_language();
  if (one.cannot_express) return {cannot_express(*one.cannot_express, sides), one.at};
  if (one.proof.stopped_a)
    return {translated(texts::conversion::stopped_by_alarm, sentence_of(*one.proof.stopped_a, sides.of_source, lang)),
            one.proof.stopped_a->origin};
  if (one.proof.stopped_b) {
    const AlarmReport& alarm = *one.proof.stopped_b;
    const std::string sentence = sentence_of(alarm, sides.of_target, lang);
    // The text is the source program itself, unchanged, so the location of the alarm is a line of the source program.
    if (one.as == ConvertedAs::as_it_stands) return {sentence, alarm.origin};
    if (alarm.origin.file != 0) return {sentence, {}};
    return {sentence, {}, {}, alarm.origin.line, alarm.line_text};
  }
  if (one.proof.differences.empty()) return {translated(texts::conversion::interrupted), {}};
  const CourseDifference& first = one.proof.differences.front();
  std::string sentence = sentence_of(first, lang);
  if (one.differs_unstated) sentence = translated(texts::conversion::with_values_unstated, sentence);
  return {std::move(sentence), first.a.origin, first.a.file, first.b.origin.file == 0 ? first.b.origin.line : 0};
}

std::string why_written_out(const WrittenOut& lines, const ConversionSides& sides) {
  if (lines.cannot_express) return cannot_express(*lines.cannot_express, sides);
  if (lines.differs) return sentence_of(*lines.differs, thread_language());
  return lines.varies ? translated(texts::conversion::not_the_same_each_time) : translated(texts::conversion::calculated_in);
}

std::vector<std::string> notes_on(const Converted& made, const ConversionTry& one) {
  std::vector<std::string> notes;
  if (made.tools_by_hand) notes.push_back(translated(texts::conversion::tools_by_hand));
  if (one.proof.passed_messages != 0) notes.push_back(translated(texts::conversion::messages_are_comments));
  if (one.proof.feeds_at_speed) notes.push_back(translated(texts::conversion::feeds_per_minute));
  if (one.proof.feeds_rounded) notes.push_back(translated(texts::conversion::feeds_rounded));
  if (one.proven_states == std::size_t{0}) notes.push_back(translated(texts::conversion::unstated_is_zero));
  if (made.wear_is_zero) notes.push_back(translated(texts::conversion::wear_is_zero));
  if (one.zero_by_operator) notes.push_back(translated(texts::conversion::zero_on_machine));
  if (one.transliterated != 0) notes.push_back(translated(texts::conversion::other_letters, one.transliterated));
  std::vector<std::string> lost = one.as == ConvertedAs::as_it_stands ? std::vector<std::string>()
                                  : one.as == ConvertedAs::words      ? made.path_modes_unknown
                                                                      : made.path_modes;
  // Canned cycles contain exact stops without a code in the program, so a text for them is added here.
  if (lost.empty() && one.proof.passed_exact_stops != 0) lost.push_back(translated(texts::conversion::exact_stops));
  if (!lost.empty()) notes.push_back(translated(texts::conversion::not_carried_over, fmt::join(lost, ", ")));
  return notes;
}

std::optional<std::size_t> best_unproven(const Converted& made) {
  const auto is_expressible = [](const ConversionTry& one) {
    return !one.cannot_express && one.text->size() != 0 && one.as != ConvertedAs::as_it_stands;
  };
  const auto found = std::find_if(made.tries.begin(), made.tries.end(), is_expressible);
  if (found == made.tries.end()) return std::nullopt;
  return std::size_t(found - made.tries.begin());
}

std::string unproven_mark() { return fmt::format("({})\n", translated(texts::conversion::unproven_mark)); }

std::string nothing_proven() { return translated(texts::conversion::nothing_proven); }

std::string no_conversion_of_channels() { return translated(texts::conversion::no_channels); }

}  // namespace kadr
