#pragma once
// Sizes that have a name instead of a figure: drills by number and letter, screws by number, metric and pipe threads.

#include <cstdint>
#include <optional>

namespace kadr {

/// Diameter of drill 1 … 80, mm: #7 is 0.2010 in. ASME B94.11M.
std::optional<double> numbered_drill(std::uint32_t number);
/// Diameter of drill A … Z, mm: F is 0.2570 in. ASME B94.11M.
std::optional<double> lettered_drill(char letter);

/// Major diameter of a thread, mm, from its size in inches or the number of a screw, and its threads per inch: 0.25-20, 1-8, 8-32.
/// Returns nullopt if there is no such screw, or for a pipe thread (1/8-27 NPT), whose name is not its diameter. ASME B1.1, B1.20.1.
std::optional<double> inch_thread(double size, double threads_per_inch);
/// Returns true if there is such a metric thread (M8). ISO 261. (There is no M29: it is a code, rigid tapping.)
bool is_metric_thread(double diameter);

}  // namespace kadr
