#pragma once
// Describes what one course states where the other differs, in the language of this thread (config/told).

#include <cstdint>
#include <string>

#include "compare/comparison.h"

namespace kadr {

/// Added to numbers of M functions of a that b does not have.
constexpr std::uint32_t not_of_b = 1'000'000'000;

/// Returns what is in force of that kind: "F100 mm/min".
std::string words_of_state(const CourseState& state, CourseDifference::Kind of);

}  // namespace kadr
