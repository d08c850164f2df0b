// Draws the legend of a plot, in two rows: line styles and symbols. This file is used by out/picture/plot/plot_page.

#include "out/picture/plot/plot_legend.h"

#include "out/picture/legend_row.h"
#include "out/picture/plot/plot_view.h"
#include "out/text/limit_text.h"
#include "texts/picture.h"
#include "texts/plot_legend.h"

namespace kadr {
namespace {

/// A row of the legend that can also contain samples of the strokes of a path.
class Row : public LegendRow {
 public:
  using LegendRow::LegendRow;

  void stroke(Stroke stroke, const char* name, double gap_after = between) {
    const StrokeStyle line = style_of(stroke, 0);
    if (line.dashed) canvas_.dashes(5, 4);
    if (stroke == Stroke::plunge) canvas_.ring({x_ + swatch / 2, y_ - 4}, 4, line.ink, line.width);
    else canvas_.line({x_, y_ - 4}, {x_ + swatch, y_ - 4}, line.ink, stroke == Stroke::contour ? line.width : line.dashed ? 1.2 : 2.2);
    canvas_.solid();
    x_ += swatch + after_swatch;
    words(name, gap_after);
  }
  void speeds(const ShadeScale& shades, double per_unit) {
    constexpr double step_width = 14, ticks = 4, bar = 9;
    const TextStyle number{12, legend_style.ink, Align::centre, false};
    const double width = step_width * double(shades.steps());
    for (std::size_t step = 0; step < shades.steps(); ++step)
      canvas_.fill({x_ + double(step) * step_width, y_ - 18, step_width + 0.5, bar}, shades.ink(step));
    for (double tick = 0; tick <= ticks; ++tick)
      canvas_.text({x_ + width * tick / ticks, y_ + 5}, number_text(shades.top() / per_unit * tick / ticks, per_unit > 1 ? 1 : 0), number);
    x_ += width + 40;
  }
};

void draw_strokes_row(Row& row, const PlotScene& scene) {
  const Lang lang = scene.title.lang;
  const ShadeScale& shades = scene.shades;
  row.stroke(Stroke::rapid, plain_text(texts::picture::rapid, lang));
  if (shades.by() == PlotColour::stroke) {
    row.stroke(Stroke::feed, plain_text(texts::picture::feed, lang));
    row.stroke(Stroke::arc, plain_text(texts::plot_legend::arc, lang));
    if (!scene.lathe) row.stroke(Stroke::plunge, plain_text(texts::plot_legend::plunge, lang));
  } else if (shades.by() == PlotColour::limit) {
    row.words(plain_text(texts::plot_legend::limited_by, lang), 16);
    for (std::size_t step = 0; step < shades.steps(); ++step)
      if (shades.occurs(step)) row.sample(shades.ink(step), limit_name(static_cast<Limit>(step), lang));
  } else {
    row.words(translated_in(lang, texts::plot_legend::speed, speed_unit_name(scene.title.unit, lang)), 22);
    row.speeds(shades, mm_of(scene.title.unit));
  }
  if (!scene.tools.empty()) row.sample(tool_ink, plain_text(texts::plot_legend::tool, lang));
  if (scene.contour.points().empty()) return;
  row.stroke(Stroke::contour, plain_text(texts::plot_legend::programmed_contour, lang), Row::after_swatch);
  if (shades.by() == PlotColour::stroke) row.words(plain_text(texts::plot_legend::path_with_compensation, lang));
}

std::string stop_text(const PlotScene& scene, const ProgramLine& line) {
  const Lang lang = scene.title.lang;
  if (line.line == 0) return plain_text(texts::plot_legend::stopped, lang);
  if (line.file == 0) return translated_in(lang, texts::plot_legend::stopped_in_line, line.line);
  return translated_in(lang, texts::plot_legend::stopped_in_line_of_file, line.line, scene.title.file_of(line));
}

}  // namespace

void draw_legend(Canvas& canvas, const PlotScene& scene, double left, double right, double y, bool cropped) {
  const Lang lang = scene.title.lang;
  canvas.begin("legend");
  Row strokes(canvas, left, y - legend_row_height);
  draw_strokes_row(strokes, scene);
  Row signs(canvas, left, y);
  if (!scene.zeros.empty()) signs.zero(plain_text(texts::picture::work_zero, lang));
  for (const PlotMark& mark : scene.marks) {
    if (mark.what == PlotMark::What::stop) signs.mark(mark.what, stop_text(scene, mark.line));
    else signs.mark(mark.what, plain_text(mark.what == PlotMark::What::start ? texts::picture::start : texts::picture::end, lang));
  }
  std::string note = cropped ? plain_text(texts::plot_legend::rapid_goes_on, lang) : "";
  if (const double tolerance = scene.path.tolerance(); tolerance > 0) {
    if (cropped) note += ";  ";
    note += translated_in(lang, texts::plot_legend::thinned, scene.path.seen(), length_text(tolerance, scene.title.unit),
                          unit_name(scene.title.unit, lang));
  }
  canvas.text({right, y}, note, {13, colour(0xB04A00), Align::right, false});
  canvas.end();
}

}  // namespace kadr
