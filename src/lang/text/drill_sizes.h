#pragma once
// Sizes that are given by a name, not by their value: drills by number and letter, screws by number, metric and pipe threads.

#include <cstdint>
#include <optional>

namespace kadr {

/// Returns the diameter in mm of the drill with the number 1 … 80: #7 is 0.2010 in (ASME B94.11M).
std::optional<double> numbered_drill(std::uint32_t number);
/// Returns the diameter in mm of the drill with the letter A … Z: F is 0.2570 in (ASME B94.11M).
std::optional<double> lettered_drill(char letter);

/// Returns the major diameter of a thread in mm: (0.25, 20) is the thread 1/4-20, (8, 32) is 8-32. `size`: inches, or the number of the
/// screw. Returns nullopt if there is no screw with these numbers, or for a pipe thread (1/8-27 NPT), because the name of a pipe thread is
/// not its diameter (ASME B1.1, B1.20.1).
std::optional<double> inch_thread(double size, double threads_per_inch);
/// Returns true if ISO 261 has a metric thread with this nominal diameter in mm: 8 for M8. M29 is not a thread, but the code of rigid
/// tapping.
bool is_metric_thread(double diameter);

}  // namespace kadr
