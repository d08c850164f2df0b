// Sizes of drills, screws and threads that are given by a name or number, not by their value. Used by lang/text/tool_comment; tested by
// tests/lang/drill_sizes_test.cpp.

#include "lang/text/drill_sizes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"

namespace kadr {
namespace {

/// Drill diameters by number, in inches, from #1 on (ASME B94.11M).
constexpr std::array<double, 80> numbered = {
    0.2280, 0.2210, 0.2130, 0.2090, 0.2055, 0.2040, 0.2010, 0.1990, 0.1960, 0.1935, 0.1910, 0.1890, 0.1850, 0.1820, 0.1800, 0.1770,
    0.1730, 0.1695, 0.1660, 0.1610, 0.1590, 0.1570, 0.1540, 0.1520, 0.1495, 0.1470, 0.1440, 0.1405, 0.1360, 0.1285, 0.1200, 0.1160,
    0.1130, 0.1110, 0.1100, 0.1065, 0.1040, 0.1015, 0.0995, 0.0980, 0.0960, 0.0935, 0.0890, 0.0860, 0.0820, 0.0810, 0.0785, 0.0760,
    0.0730, 0.0700, 0.0670, 0.0635, 0.0595, 0.0550, 0.0520, 0.0465, 0.0430, 0.0420, 0.0410, 0.0400, 0.0390, 0.0380, 0.0370, 0.0360,
    0.0350, 0.0330, 0.0320, 0.0310, 0.0292, 0.0280, 0.0260, 0.0250, 0.0240, 0.0225, 0.0210, 0.0200, 0.0180, 0.0160, 0.0145, 0.0135,
};

/// Drill diameters by letter, in inches, from A on (ASME B94.11M).
constexpr std::array<double, 26> lettered = {
    0.2340, 0.2380, 0.2420, 0.2460, 0.2500, 0.2570, 0.2610, 0.2660, 0.2720, 0.2770, 0.2810, 0.2900, 0.2950,
    0.3020, 0.3160, 0.3230, 0.3320, 0.3390, 0.3480, 0.3580, 0.3680, 0.3770, 0.3860, 0.3970, 0.4040, 0.4130,
};
static_assert(numbered[0] < lettered[0]);  // drill #1 is a little smaller than drill A, so the two series do not overlap

/// Screws by number. The major diameter is 0.060 in plus 0.013 in per number. The threads per inch are those of the series UNC, UNF, UNEF
/// (0: the series lacks the screw).
struct Screw {
  int number;
  double inch;
  std::array<int, 3> threads;
};
constexpr std::array<Screw, 10> screws = {{
    // the columns are the number of the screw, its diameter in inches, and its threads per inch of UNC, UNF, UNEF (ASME B1.1)
    {0, 0.060, {0, 80, 0}},
    {1, 0.073, {64, 72, 0}},
    {2, 0.086, {56, 64, 0}},
    {3, 0.099, {48, 56, 0}},
    {4, 0.112, {40, 48, 0}},
    {5, 0.125, {40, 44, 0}},
    {6, 0.138, {32, 40, 0}},
    {8, 0.164, {32, 36, 0}},
    {10, 0.190, {24, 32, 0}},
    {12, 0.216, {24, 28, 32}},
}};

/// Pipe threads: size in inches, and threads per inch (ASME B1.20.1). None of these pairs of numbers is a unified thread.
struct Pipe {
  double size, threads;
};
constexpr std::array<Pipe, 8> pipes = {{{0.0625, 27}, {0.125, 27}, {0.25, 18}, {0.375, 18}, {0.5, 14}, {0.75, 14}, {1, 11.5}, {2, 11.5}}};

/// Nominal diameters of metric threads by ISO 261, mm.
constexpr std::array<double, 46> metric = {1,  1.1, 1.2, 1.4, 1.6, 1.8, 2,  2.2, 2.5, 3,  3.5, 4,  4.5, 5,  5.5, 6,
                                           7,  8,   9,   10,  11,  12,  14, 15,  16,  17, 18,  20, 22,  24, 25,  26,
                                           27, 28,  30,  32,  33,  35,  36, 38,  39,  42, 45,  48, 52,  56};

// Limits of a size in inches: screw #0, and the largest tap that a spindle drives.
constexpr double smallest_by_inches = 0.06, largest_by_inches = 4;
constexpr double least_threads = 4, max_threads = 80;  // limits of the number of threads per inch

}  // namespace

std::optional<double> numbered_drill(std::uint32_t number) {
  if (number < 1 || number > numbered.size()) return std::nullopt;
  return numbered[number - 1] * mm_per_inch;
}

std::optional<double> lettered_drill(char letter) {
  if (letter < 'A' || letter > 'Z') return std::nullopt;
  return lettered[static_cast<std::size_t>(letter - 'A')] * mm_per_inch;
}

std::optional<double> inch_thread(double size, double threads_per_inch) {
  for (const Screw& screw : screws)
    if (screw.number == size)
      for (const int threads : screw.threads)
        if (threads != 0 && threads == threads_per_inch) return screw.inch * mm_per_inch;
  const bool is_pipe =
      std::any_of(pipes.begin(), pipes.end(), [&](const Pipe& p) { return p.size == size && p.threads == threads_per_inch; });
  const bool is_likely =
      size >= smallest_by_inches && size <= largest_by_inches && threads_per_inch >= least_threads && threads_per_inch <= max_threads;
  // 2-4.5 UNC is the only thread whose number per inch is not whole.
  const bool whole_pitch = threads_per_inch == std::floor(threads_per_inch) || threads_per_inch == 4.5;
  const bool too_fine = size >= 1 && threads_per_inch > 20;  // 1-20 UNEF is the finest thread from one inch on
  if (is_pipe || !is_likely || !whole_pitch || too_fine) return std::nullopt;
  return size * mm_per_inch;
}

bool is_metric_thread(double diameter) { return std::find(metric.begin(), metric.end(), diameter) != metric.end(); }

}  // namespace kadr
