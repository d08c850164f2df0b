// "Did you mean …": finds the known name that is closest to a mistyped name. Used by cli, config, out.

#include "config/nearest.h"

#include <algorithm>
#include <utility>

#include "base/ascii.h"
#include "texts/nearest.h"

namespace kadr {
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above, row(b.size() + 1);  // rows i - 2, i - 1 and i of the table of edit distances (Levenshtein)
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  const auto same = [&](std::size_t i, std::size_t j) { return to_lower(a[i]) == to_lower(b[j]); };
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j - 1] + (same(i - 1, j - 1) ? 0 : 1), above[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 64;  // greatest length of a name that is compared; no known name is longer
  if (name.size() > longest) return std::nullopt;
  const auto begins_alike = [&](const std::string& one) { return !name.empty() && !one.empty() && to_lower(name[0]) == to_lower(one[0]); };
  const std::string* best = nullptr;
  std::size_t fewest = 0;
  for (const std::string& one : known) {
    const std::size_t n = edits(name, one);
    // If two names are equally close, one with the same first letter is likelier, because the first letter is rarely mistyped.
    const bool likelier = best != nullptr && n == fewest && begins_alike(one) && !begins_alike(*best);
    if (best == nullptr || n < fewest || likelier) best = &one, fewest = n;
  }
  if (best == nullptr || 2 * fewest > std::max(name.size(), best->size())) return std::nullopt;
  return *best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  const auto near = nearest(name, known);
  return near ? translated(texts::nearest::did_you_mean, *near) : "";
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return to_lower(x) == to_lower(y); });
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), to_lower);
  return small;
}

}  // namespace kadr
