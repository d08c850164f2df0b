#pragma once
// Describes values in which one course differs from the other, in the language of the current thread (config/language).

#include <cstdint>
#include <string>

#include "compare/comparison.h"

namespace kadr {

/// Offset that is added to the numbers of a's M functions that b's control does not have, so that they equal no function of b.
constexpr std::uint32_t not_of_b = 1'000'000'000;

/// Describes the value of the state in which this kind of difference consists: "F100 mm/min".
std::string words_of_state(const CourseState& state, CourseDifference::Kind of);

}  // namespace kadr
