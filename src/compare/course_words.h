#pragma once
// What one course says where the other says something else, in the language of who asks (config/told).

#include <cstdint>
#include <string>

#include "compare/comparison.h"

namespace kadr {

/// Added to numbers of M functions of a that are no functions of b.
constexpr std::uint32_t not_of_b = 1'000'000'000;

/// What is in force of that kind: "F100 mm/min".
std::string words_of_state(const CourseState& state, CourseDifference::Kind of);

}  // namespace kadr
