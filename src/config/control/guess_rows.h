#pragma once
// The evidence by which programs are recognised. For a control, it is the section [guess] of the control's file; for a program language
// that Kadr does not read, it is in controls/dialects.toml.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/control/guess_pattern.h"
#include "config/control/guess_traits.h"

namespace kadr {

enum class MarkLocation : std::uint8_t {
  statement,  // rows of [guess]: the pattern is searched in the blocks
  comment,    // rows of [guess.comment]: the pattern is searched in the comments
  name        // rows of [guess.name]: the pattern is searched in the names of the file and its folder
};

struct GuessMark {
  std::string pattern;  // pattern of the text to find, in the form of guess_pattern.h
  double weight = 0;    // strength of the evidence; below 0: evidence against the control
  MarkLocation place = MarkLocation::statement;
  LineSigns needs = 0;  // characters without which the pattern cannot match
  // Number of the bit, in `needs`, of the rarest character: of the characters that the pattern needs, the fewest lines of programs contain
  // it
  std::size_t rarest = any_sign;
};

struct LanguageReader;

/// The evidence that points to one control or program language.
struct GuessRows {
  std::string control;           // id of the control or of the program language
  std::string name_en, name_ru;  // name of a program language, for people; empty for a control
  // Only for a program language: controls that must not be used for its programs, because Kadr reads programs of these controls
  // differently.
  std::vector<std::string> refused_by;
  // Only for a program language that some controls read, such as that of lathes: these controls, whether they are built in or not. Empty
  // for a language that Kadr does not read.
  std::vector<LanguageReader> read_by;
  std::vector<GuessMark> marks;
  std::vector<std::pair<TextTrait, double>> traits;
};

/// A control that reads the programs of a language in controls/dialects.toml.
struct LanguageReader {
  std::string id;    // id of the control
  std::string mill;  // id of the control for the same maker's mills, whose evidence counts for this control too
  GuessRows rows;    // the evidence that distinguishes this control from the others that read the language
};

/// A mark with at least this weight identifies the control by itself. A program language is identified if the weights of all its evidence
/// add up to at least this number.
inline constexpr double decisive_weight = 10;

/// Returns the rows of the built-in controls, which are read once; add_rows_of_language() has added to them.
const std::vector<GuessRows>& built_in_guess_rows();
/// Returns the rows of the program languages in controls/dialects.toml; they are read once.
const std::vector<GuessRows>& dialect_rows();

/// Adds the rows that a control gets from the program language that it reads (`read_by` in controls/dialects.toml): those of the control
/// in this language, those of the language, those of the same maker's mill. Of two rows with the same pattern or trait, the first is kept.
///   control  id of the control, or of the control that a user's own control file extends; if it reads no such language, nothing changes
void add_rows_of_language(GuessRows& rows, std::string_view control);

}  // namespace kadr
