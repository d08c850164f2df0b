#pragma once
// Describes a conversion in words, in the language of the current thread (config/language.h). Used by the command line and the web page.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "convert/conversion.h"

namespace kadr {

/// Returns the way in words: "as it stands", "with the path of the tool's centre", ….
std::string method_in_words(ConvertedAs as);
/// Returns the way as a key for programs: "as_it_stands", "contours", ….
const char* name_of(ConvertedAs as);

/// The reason why a way was not used, with the program line.
struct ConversionRefusal {
  std::string text;
  Origin at;                       // line of the source program or of a file that it calls; line 0: no line
  std::string file{};              // name of the called file that contains `at`, if known
  std::uint32_t written_line = 0;  // line of the converted text; 0: none
  std::string written_text{};      // the text of written_line, for an alarm
};
/// The two controls of a conversion; the sentences use their codes and alarm texts.
struct ConversionSides {
  const ControlDef& from;       // the source control
  const AlarmTexts& of_source;  // alarm texts of the source control
  const AlarmTexts& of_target;  // alarm texts of the target control
};
ConversionRefusal refusal_of(const ConversionTry& one, const ConversionSides& sides);
/// Returns the reason why these lines are expanded instead of rewritten word by word.
std::string why_written_out(const WrittenOut& lines, const ConversionSides& sides);

/// Returns the notes that the user must read about a way that was used.
std::vector<std::string> notes_on(const Converted& made, const ConversionTry& one);

/// Returns the index of the best expanded text that the target control can express but that is not proven: the one that keeps most of the
/// program. Returns nullopt if there is none.
std::optional<std::size_t> best_unproven(const Converted& made);
/// Returns the comment line that is put at the top of a text that is not proven.
std::string unproven_mark();

std::string nothing_proven();
std::string no_conversion_of_channels();

}  // namespace kadr
