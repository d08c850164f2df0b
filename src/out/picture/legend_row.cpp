// LegendRow: draws the entries of a legend from left to right. It is used by out/picture/plot/plot_legend and out/picture/difference_page.

#include "out/picture/legend_row.h"

#include "out/picture/plot/plot_marks.h"
#include "out/picture/text_width.h"

namespace kadr {

void LegendRow::sample(const PathStyle& style, std::string_view name) {
  canvas_.line({x_, y_ - 4}, {x_ + swatch, y_ - 4}, style.ink, style.width);
  x_ += swatch + after_swatch;
  words(name);
}

void LegendRow::words(std::string_view text, double gap_after) {
  canvas_.text({x_, y_}, text, legend_style);
  x_ += text_width(text, legend_style.size) + gap_after;
}

void LegendRow::zero(std::string_view name) {
  canvas_.zero_mark({x_ + 10, y_ - 4}, 6, legend_style.ink);
  x_ += 24;
  words(name);
}

void LegendRow::mark(PlotMark::What what, std::string_view name) {
  draw_mark(canvas_, what, {x_ + 10, y_ - 4});
  x_ += 27;
  words(name);
}

void LegendRow::ring(Colour ink, std::string_view name) {
  canvas_.ring({x_ + 10, y_ - 4}, 5, ink, 2);
  x_ += 27;
  words(name);
}

}  // namespace kadr
