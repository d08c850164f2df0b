// The legend of a plot, in two rows: line styles and symbols. Used by out/picture/plot/plot_page.

#include "out/picture/plot/plot_legend.h"

#include <fmt/format.h>

#include "out/picture/legend_row.h"
#include "out/picture/plot/plot_view.h"
#include "out/text/limit_text.h"

namespace kadr {
namespace {

struct LegendWords {
  const char *rapid, *feed, *arc, *plunge, *contour, *beside, *zero, *start, *end, *stop, *stop_line, *stop_file, *thinned, *cropped, *tool;
  const char *speed, *limits;
};
constexpr LegendWords english_legend = {"rapid",
                                        "feed",
                                        "arc",
                                        "plunge",
                                        "contour as programmed",
                                        "(the tool's path: with its radius compensated)",
                                        "work zero",
                                        "start",
                                        "end",
                                        "stopped",
                                        "stopped by an alarm: line {}",
                                        "stopped by an alarm: line {} of {}",
                                        "thinned: of {} points, those closer than {} {} are left out",
                                        "rapid motion goes on beyond the picture",
                                        "tool",
                                        "speed (least time), {}:",
                                        "limited (least time) by"};
constexpr LegendWords russian_legend = {"быстрый ход",
                                        "рабочая подача",
                                        "дуга",
                                        "врезание",
                                        "контур по УП",
                                        "(траектория инструмента: с коррекцией на радиус)",
                                        "нуль детали",
                                        "начало",
                                        "конец",
                                        "останов",
                                        "останов по ошибке: строка {}",
                                        "останов по ошибке: строка {} файла {}",
                                        "прорежено: из {} точек не показаны те, что ближе {} {}",
                                        "быстрый ход продолжается за пределами рисунка",
                                        "инструмент",
                                        "скорость (мин. время), {}:",
                                        "ограничение (мин. время):"};

/// A legend row that also shows the strokes of a path.
class Row : public LegendRow {
 public:
  using LegendRow::LegendRow;

  void stroke(Stroke stroke, const char* name, double behind = between) {
    const StrokeStyle line = style_of(stroke, 0);
    if (line.dashed) canvas_.dashes(5, 4);
    if (stroke == Stroke::plunge) canvas_.ring({x_ + swatch / 2, y_ - 4}, 4, line.ink, line.width);
    else canvas_.line({x_, y_ - 4}, {x_ + swatch, y_ - 4}, line.ink, stroke == Stroke::contour ? line.width : line.dashed ? 1.2 : 2.2);
    canvas_.solid();
    x_ += swatch + after_swatch;
    words(name, behind);
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

void draw_strokes_row(Row& row, const PlotScene& scene, const LegendWords& w) {
  const ShadeScale& shades = scene.shades;
  row.stroke(Stroke::rapid, w.rapid);
  if (shades.by() == PlotColour::stroke) {
    row.stroke(Stroke::feed, w.feed);
    row.stroke(Stroke::arc, w.arc);
    row.stroke(Stroke::plunge, w.plunge);
  } else if (shades.by() == PlotColour::limit) {
    row.words(w.limits, 16);
    for (std::size_t step = 0; step < shades.steps(); ++step)
      if (shades.occurs(step)) row.sample(shades.ink(step), limit_name(static_cast<Limit>(step), scene.title.lang));
  } else {
    row.words(fmt::format(fmt::runtime(w.speed), speed_unit_name(scene.title.unit, scene.title.lang)), 22);
    row.speeds(shades, mm_of(scene.title.unit));
  }
  if (!scene.tools.empty()) row.sample(tool_ink, w.tool);
  if (scene.contour.points().empty()) return;
  row.stroke(Stroke::contour, w.contour, Row::after_swatch);
  if (shades.by() == PlotColour::stroke) row.words(w.beside);
}

std::string stop_text(const PlotScene& scene, const ProgramLine& line, const LegendWords& w) {
  if (line.line == 0) return w.stop;
  if (line.file == 0) return fmt::format(fmt::runtime(w.stop_line), line.line);
  return fmt::format(fmt::runtime(w.stop_file), line.line, scene.title.file_of(line));
}

}  // namespace

void draw_legend(Canvas& canvas, const PlotScene& scene, double left, double right, double y, bool cropped) {
  const LegendWords& w = scene.title.lang == Lang::ru ? russian_legend : english_legend;
  canvas.begin("legend");
  Row strokes(canvas, left, y - legend_row_height);
  draw_strokes_row(strokes, scene, w);
  Row signs(canvas, left, y);
  if (!scene.zeros.empty()) signs.zero(w.zero);
  for (const PlotMark& mark : scene.marks) {
    if (mark.what == PlotMark::What::stop) signs.mark(mark.what, stop_text(scene, mark.line, w));
    else signs.mark(mark.what, mark.what == PlotMark::What::start ? w.start : w.end);
  }
  std::string note = cropped ? w.cropped : "";
  if (const double tolerance = scene.path.tolerance(); tolerance > 0) {
    if (cropped) note += ";  ";
    note += fmt::format(fmt::runtime(w.thinned), scene.path.seen(), length_text(tolerance, scene.title.unit),
                        unit_name(scene.title.unit, scene.title.lang));
  }
  canvas.text({right, y}, note, {13, colour(0xB04A00), Align::right, false});
  canvas.end();
}

}  // namespace kadr
