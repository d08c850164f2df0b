#pragma once
// "Did you mean …": the name that a mistyped one is nearest to.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// Number of edits that turn one word into the other: a character put in, taken out, replaced, or two neighbours swapped; small and capital
/// letters alike.
std::size_t edits(std::string_view a, std::string_view b);

/// The nearest of `known`, of several one that begins alike, the first; nothing, if none is like it: more than half of its letters would
/// change.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& known);

/// What an error may end in: "; did you mean 'x'?", in Russian if that is spoken (told.h); empty, if none is like it.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

/// Equal but for capitals, of Latin letters.
bool same_letters(std::string_view a, std::string_view b);

/// In small letters, of the Latin ones.
std::string in_small_letters(std::string_view text);

}  // namespace kadr
