#pragma once
// Sizes that have a name instead of a figure: drills by number and letter, screws by number, metric and pipe threads.

#include <cstdint>
#include <optional>

namespace kadr {

/// Drill 1 … 80: #7 is 0.2010 in; mm. ASME B94.11M.
std::optional<double> numbered_drill(std::uint32_t number);
/// Drill A … Z: F is 0.2570 in; mm. ASME B94.11M.
std::optional<double> lettered_drill(char letter);

/// Major diameter of a thread by its size in inches, or by the number of a screw, and its threads per inch: 0.25-20, 1-8, 8-32; mm.
/// Nothing: there is no such screw, or it is a pipe thread (1/8-27 NPT), whose name is not its diameter. ASME B1.1, B1.20.1.
std::optional<double> inch_thread(double size, double threads_per_inch);
/// M8: is there such a thread? ISO 261. (M29 is none: it is a code, rigid tapping.)
bool is_metric_thread(double diameter);

}  // namespace kadr
