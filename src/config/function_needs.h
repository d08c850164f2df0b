#pragma once
// The columns of config/function.h that only the loader of control files looks at: what may call a function, and what it needs of the
// control. Until each control brings its own dialect, this keeps apart what works on the machine of the NCT and what does not.

#include <cstdint>

#include "config/function.h"

namespace kadr {

/// What calls a function: a row of [address], or one of [g] and [m].
enum class CalledBy : std::uint8_t { word, code };

/// What a function needs. The machine of the NCT (dialect = "nct") has axes, spindles, offsets and calls of its own: what works
/// on it does not work beside it, and the other way round.
enum class Needs : std::uint8_t {
  nothing,
  nct,         // dialect = "nct"
  no_nct,      // another one, or none
  correctors,  // dialect = "correctors"
  sections,    // [behaviour] subprograms_by_section = true
  labels,      // [grammar] label
};

CalledBy called_by(Function function);
Needs needs_of(Function function);

inline constexpr std::size_t most_groups = 48;  // of codes, the one that is none among them

}  // namespace kadr
