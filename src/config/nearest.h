#pragma once
// "Did you mean …": the name that a mistyped one is nearest to.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// Number of single-character edits that turn one word into the other, small and capital letters alike.
std::size_t edits(std::string_view a, std::string_view b);

/// The nearest of `known`, the first of several; nothing, if none is like it: more than half of its letters would change.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& known);

}  // namespace kadr
