// Names the ways of a conversion, and describes why a way was not used. Used by cli/convert and view/page/page_conversion; tested by
// tests/convert.py and tests/serve_convert.py.

#include "convert/conversion_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/comparison_text.h"
#include "config/language.h"
#include "out/text/alarm_print.h"

namespace kadr {
namespace {

/// Returns "M6 (tool change)" if one code of the control has the function, "T" if a word has it, else the engine's name of the function.
std::string function_in_words(std::string_view name, const ControlDef& def) {
  const Function function = function_named(name);
  if (function == Function::count) return std::string(name);
  const auto does = [&](const auto& row) { return row.function == function; };
  if (std::count_if(def.codes.begin(), def.codes.end(), does) == 1) {
    const CodeRow& row = *std::find_if(def.codes.begin(), def.codes.end(), does);
    return fmt::format("{} ({})", row.code, told(row.text.en, row.text.ru));
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
    case ConvertedAs::as_it_stands: return told("as it stands", "как есть");
    case ConvertedAs::words: return told("word by word", "слово за словом");
    case ConvertedAs::contours: return told("with offsets and radius compensation as codes", "с коррекциями и эквидистантой кодами");
    case ConvertedAs::lengths: return told("with the path of the tool's centre", "с рассчитанной эквидистантой");
    case ConvertedAs::plain: return told("with all offsets calculated in", "со всеми коррекциями в координатах");
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
    return {
        fmt::format("{}: {}", told("an alarm stops the program under its own control", "программу останавливает ошибка у своей системы"),
                    sentence_of(*one.proof.stopped_a, sides.of_source, lang)),
        one.proof.stopped_a->origin};
  if (one.proof.stopped_b) {
    const AlarmReport& alarm = *one.proof.stopped_b;
    const std::string sentence = sentence_of(alarm, sides.of_target, lang);
    if (one.as == ConvertedAs::as_it_stands) return {sentence, alarm.origin};  // the text is the source program itself
    if (alarm.origin.file != 0) return {sentence, {}};
    return {sentence, {}, {}, alarm.origin.line, alarm.line_text};
  }
  if (one.proof.differences.empty()) return {told("interrupted", "прервано"), {}};
  const CourseDifference& first = one.proof.differences.front();
  const std::string where =
      one.differs_unstated
          ? told("with work zeros, tool lengths, radii and reference points other than 0, which no set-up states (--setup): ",
                 "при нулях, вылетах, радиусах и опорных точках, не равных 0 и нигде не заданных (--setup): ")
          : "";
  return {where + sentence_of(first, lang), first.a.origin, first.a.file, first.b.origin.file == 0 ? first.b.origin.line : 0};
}

std::string why_written_out(const WrittenOut& lines, const ConversionSides& sides) {
  if (lines.cannot_express) return cannot_express(*lines.cannot_express, sides);
  if (lines.differs) return sentence_of(*lines.differs, thread_language());
  return lines.varies ? told("not the same each time", "каждый раз по-разному") : told("calculated in", "рассчитано");
}

std::vector<std::string> notes_on(const Converted& made, const ConversionTry& one) {
  std::vector<std::string> notes;
  if (made.tools_by_hand) notes.push_back(told("tools are changed by hand, at M0", "инструмент меняют вручную, на M0"));
  if (one.proof.passed_messages != 0)
    notes.push_back(told("what the program shows to the operator is a comment there", "сообщения оператору стали комментариями"));
  if (one.proof.feeds_at_speed)
    notes.push_back(told("feed per revolution is written per minute, at the speed of the program",
                         "подача на оборот записана минутной, при частоте вращения из программы"));
  if (one.proof.feeds_rounded)
    notes.push_back(told("feeds are rounded to what the F word of that control can say",
                         "подачи округлены до значений, которые допускает слово F этой системы"));
  if (one.told_states == std::size_t{0})
    notes.push_back(
        told("taken for granted: zeros, lengths, radii and reference points that no set-up states are 0, for with others the program stops",
             "принято: не заданные нули, вылеты, радиусы и опорные точки равны 0, с другими программа останавливается"));
  if (one.zero_by_operator)
    notes.push_back(told("taken for granted: the zero of the part is set on the machine, no work zero of the program is stated",
                         "принято: нуль детали задаёт наладчик на станке, рабочий нуль программы не задан"));
  if (one.transliterated != 0)
    notes.push_back(told(fmt::format("letters that its text cannot hold are written as others: {}", one.transliterated),
                         fmt::format("букв, которых нет в её кодировке, записано другими: {}", one.transliterated)));
  std::vector<std::string> lost = one.as == ConvertedAs::as_it_stands ? std::vector<std::string>()
                                  : one.as == ConvertedAs::words      ? made.path_modes_unknown
                                                                      : made.path_modes;
  // Canned cycles contain exact stops without a code in the program.
  if (lost.empty() && one.proof.passed_exact_stops != 0) lost.push_back(told("exact stops", "точные остановы"));
  if (!lost.empty())
    notes.push_back(told(fmt::format("not carried over: {} (how corners are gone round)", fmt::join(lost, ", ")),
                         fmt::format("не перенесено: {} (как проходятся углы)", fmt::join(lost, ", "))));
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

std::string unproven_mark() { return fmt::format("({})\n", told("NOT PROVEN EQUAL: SEE kadr convert", "НЕ ДОКАЗАНО: СМ. kadr convert")); }

std::string nothing_proven() {
  return told("not converted: no way of writing it for that control could be proven equal",
              "не переведено: ни одна запись для этой системы не доказана");
}

std::string no_conversion_of_channels() {
  return told("not converted: programs of several channels are not", "не переведено: программы нескольких каналов не переводятся");
}

}  // namespace kadr
