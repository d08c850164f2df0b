// SectionNumbers: assigns numbers to the subprograms of a section. Used by convert/flow_rewriter; tested by tests/convert.py.

#include "convert/section_numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace kadr {
namespace {

constexpr std::uint32_t most = 99;  // greatest number of a subprogram, because the number has two digits

/// Returns the label as a number; 0 if the label is a name, or a number that the section does not allow.
std::uint32_t number_in(const std::string& label) {
  const bool digits = !label.empty() && std::all_of(label.begin(), label.end(), [](char c) { return c >= '0' && c <= '9'; });
  constexpr std::size_t max_digits = 8;
  const unsigned long number = digits && label.size() <= max_digits ? std::stoul(label) : 0;
  return number <= most ? static_cast<std::uint32_t>(number) : 0;
}

}  // namespace

bool SectionNumbers::is_free(std::uint32_t number) const {
  const bool is_cycle =
      std::any_of(to_.cycles.begin(), to_.cycles.end(), [number](const CycleRow& row) { return row.call_number == number; });
  return number != 0 && !is_cycle && taken_.count(number) == 0;
}

std::optional<std::uint32_t> SectionNumbers::of(const std::string& label) {
  if (const auto known = numbers_.find(label); known != numbers_.end()) return known->second;
  std::uint32_t number = number_in(label);
  // The search goes down from the highest number, because programs mostly use small numbers.
  if (!is_free(number))
    for (number = most; number != 0 && !is_free(number);) --number;
  if (number == 0) return std::nullopt;
  taken_.insert(number);
  return numbers_[label] = number;
}

std::optional<std::string> SectionNumbers::call(const std::string& label, std::uint32_t times) {
  const auto number = of(label);
  if (!number || times == 0 || times > most) return std::nullopt;
  return times == 1 ? fmt::format("{}{:02}", to_.grammar.section_address, *number)
                    : fmt::format("{}{:02}{:02}", to_.grammar.section_address, *number, times);
}

}  // namespace kadr
