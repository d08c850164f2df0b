#pragma once
// Describes a conversion in words, in the language of this thread (config/told.h): the same for the command line and the page.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "convert/conversion.h"

namespace kadr {

/// Returns "as it stands", "with the path of the tool's centre", ….
std::string way_in_words(ConvertedAs as);
/// Returns "as_it_stands", "contours", …: for programs.
const char* name_of(ConvertedAs as);

/// Why a way was not used, and where.
struct ConversionRefusal {
  std::string text;
  Origin at;                       // in the program that is converted, or in a file that it calls; line 0: at no line of it
  std::string file{};              // the called file that `at` is in, if its name is known
  std::uint32_t written_line = 0;  // in the text that was written; 0: none
  std::string written_text{};      // the text of that line, for an alarm
};
/// The controls whose wording is used.
struct ConversionSides {
  const ControlDef& from;       // the control of the program
  const AlarmTexts& of_source;  // of that control
  const AlarmTexts& of_target;  // of the control that the program is converted to
};
ConversionRefusal refusal_of(const ConversionTry& one, const ConversionSides& sides);
/// Returns why these lines are not rewritten word by word.
std::string why_written_out(const WrittenOut& lines, const ConversionSides& sides);

/// Returns what the user must know about a try that was used.
std::vector<std::string> notes_on(const Converted& made, const ConversionTry& one);

/// Of the written-out texts that the other control can express, though none is proven, returns the one that keeps most; nullopt if there is
/// none.
std::optional<std::size_t> best_unproven(const Converted& made);
/// Returns the line that is put before an unproven text.
std::string unproven_mark();

std::string nothing_proven();
std::string no_conversion_of_channels();

}  // namespace kadr
