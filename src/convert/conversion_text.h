#pragma once
// A conversion in words, in the language of this thread (config/told.h): the same for the command line and the page.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "convert/conversion.h"

namespace kadr {

/// "as it stands"; "with the path of the tool's centre".
std::string way_in_words(ConvertedAs as);
/// "as_it_stands", "contours" …: for programs.
const char* name_of(ConvertedAs as);

/// Why a way was not taken, and where.
struct ConversionRefusal {
  std::string text;
  Origin at;                       // in the program that is converted, or in a file that it calls; line 0: at no place of it
  std::string file{};              // that `at` stands in where it is a called one, if its name is known
  std::uint32_t written_line = 0;  // of the text that was made; 0: of none
  std::string written_text{};      // that line, of an alarm
};
/// In whose words it is said.
struct ConversionSides {
  const ControlDef& from;       // of the program
  const AlarmTexts& of_source;  // of that control
  const AlarmTexts& of_target;  // of the one that the program is to be for
};
ConversionRefusal refusal_of(const ConversionTry& one, const ConversionSides& sides);
/// Why lines are not rewritten word by word.
std::string why_written_out(const WrittenOut& lines, const ConversionSides& sides);

/// What is to be known of a try that was taken.
std::vector<std::string> notes_on(const Converted& made, const ConversionTry& one);

/// Of the tries that the other control could say, written out, though none is proven: the one that keeps most; nothing: it can say none.
std::optional<std::size_t> best_unproven(const Converted& made);
/// The line that stands before its text.
std::string unproven_mark();

std::string nothing_proven();
std::string no_conversion_of_channels();

}  // namespace kadr
