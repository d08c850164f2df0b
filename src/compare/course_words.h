#pragma once
// Describes values of one course that differ from the other, in the language of the current thread (config/language).

#include <cstdint>
#include <string>

#include "compare/comparison.h"

namespace kadr {

/// Added to the numbers of a's M functions that b's control does not have.
constexpr std::uint32_t not_of_b = 1'000'000'000;

/// Describes the value in the state that this kind of difference is about: "F100 mm/min".
std::string words_of_state(const CourseState& state, CourseDifference::Kind of);

}  // namespace kadr
