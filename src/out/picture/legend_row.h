#pragma once
// LegendRow: draws the entries of a legend from left to right.

#include <string_view>

#include "out/picture/plot/plot_differences.h"

namespace kadr {

const TextStyle legend_style{13, colour(0x20262E), Align::left, false};

class LegendRow {
 public:
  static constexpr double swatch = 32, after_swatch = 8, between = 26;

  LegendRow(Canvas& canvas, double x, double y) : canvas_(canvas), x_(x), y_(y) {}

  /// Draws a short line in this style as a sample, followed by its name.
  void sample(const PathStyle& style, std::string_view name);
  void sample(Colour of, std::string_view name) { sample({of, 3}, name); }
  void words(std::string_view text, double gap_after = between);
  void zero(std::string_view name);
  void mark(PlotMark::What what, std::string_view name);
  void ring(Colour ink, std::string_view name);

 protected:
  Canvas& canvas_;
  double x_, y_;
};

}  // namespace kadr
