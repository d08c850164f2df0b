#pragma once
// Describes a conversion in words, in the language of the current thread (config/language.h). Used by the command line and the web page.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "convert/conversion.h"

namespace kadr {

/// Returns the method in words: "as it stands", "with the path of the tool's centre", ….
std::string method_in_words(ConvertedAs as);
/// Returns the method as a key for programs that read the output: "as_it_stands", "contours", ….
const char* name_of(ConvertedAs as);

/// The reason why a method was not used, with the program line that caused it.
struct ConversionRefusal {
  std::string text;
  Origin at;                       // line of the source program, or of a file that it calls; line 0: the reason concerns no line
  std::string file{};              // name of the called file that contains the line `at`, if known
  std::uint32_t written_line = 0;  // number of the line in the converted text; 0: the reason concerns no line there
  std::string written_text{};      // text of the line number `written_line` of the converted text, if the reason is an alarm in that line
};
/// The two controls of a conversion. Sentences about the conversion use their codes and alarm texts.
struct ConversionSides {
  const ControlDef& from;       // the source control
  const AlarmTexts& of_source;  // alarm texts of the source control
  const AlarmTexts& of_target;  // alarm texts of the target control
};
ConversionRefusal refusal_of(const ConversionTry& one, const ConversionSides& sides);
/// Returns the reason why the given lines are expanded instead of rewritten word by word.
std::string why_written_out(const WrittenOut& lines, const ConversionSides& sides);

/// Returns the notes that the user must read about a text that was used.
std::vector<std::string> notes_on(const Converted& made, const ConversionTry& one);

/// Returns the index of the best text among the expanded texts that the target control can express but that are not proven: the text that
/// keeps most of the program. Returns nullopt if there is no such text.
std::optional<std::size_t> best_unproven(const Converted& made);
/// Returns the comment line that is added at the top of a text that is not proven.
std::string unproven_mark();

std::string nothing_proven();
std::string no_conversion_of_channels();

}  // namespace kadr
