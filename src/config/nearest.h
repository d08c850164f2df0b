#pragma once
// "Did you mean …": finds the known name that is closest to a mistyped name.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// Returns the number of edits that change one word into the other. An edit inserts, deletes or replaces a character, or swaps two
/// neighbours. Upper and lower case count as equal.
std::size_t edits(std::string_view a, std::string_view b);

/// Returns the element of `known` that needs the fewest edits; if several need the same number, the first one with the same first letter.
/// Returns nullopt if the edits would change more than half of the letters.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& known);

/// Returns the end of an error sentence, "; did you mean 'x'?", in the language of messages (language.h); empty if no known name is close.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

/// Returns true if two texts are equal without regard to upper and lower case of Latin letters.
bool same_letters(std::string_view a, std::string_view b);

/// Converts Latin letters to lower case.
std::string in_small_letters(std::string_view text);

}  // namespace kadr
