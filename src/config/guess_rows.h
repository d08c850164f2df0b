#pragma once
// What speaks for each control: the section [guess] of the controls' files; and for each language that Kadr does not read:
// controls/dialects.toml.

#include <toml++/toml.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "config/guess_pattern.h"
#include "config/guess_traits.h"

namespace kadr {

enum class MarkPlace : std::uint8_t {
  statement,  // [guess]: in the blocks
  comment,    // [guess.comment]: words of the comments
  name        // [guess.name]: what the file is called, and the folder it lies in
};

struct GuessMark {
  std::string pattern;  // guess_pattern.h
  double weight = 0;    // below 0: speaks against it
  MarkPlace place = MarkPlace::statement;
  LineSigns needs = 0;            // of the pattern
  std::size_t rarest = any_sign;  // of those
};

/// Of one control, or one language.
struct GuessRows {
  std::string control;                  // its id
  std::string name_en, name_ru;         // of a language: for people
  std::vector<std::string> refused_by;  // of a language: controls that it is taken for, and that Kadr reads as something else
  std::vector<GuessMark> marks;
  std::vector<std::pair<TextTrait, double>> traits;
};

/// A mark of this weight tells the control by itself; what is found of a language must weigh as much.
inline constexpr double decisive_weight = 10;

/// Rows of a section [guess].
///   returns  an error sentence: a weight that is no number from -20 to 20 or 0, a trait that nobody knows
tl::expected<GuessRows, std::string> guess_rows_of(const toml::table& guess, const std::string& file);

/// Of the built-in controls, read once.
const std::vector<GuessRows>& built_in_guess_rows();
/// Of the languages that Kadr does not read, read once.
const std::vector<GuessRows>& dialect_rows();

}  // namespace kadr
