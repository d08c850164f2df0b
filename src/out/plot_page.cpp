#include "out/plot_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "out/limit_text.h"
#include "out/page_file.h"
#include "out/plot_view.h"

namespace kadr {
namespace {

constexpr double page_width = 1600, page_height = 1060, margin = 28, gap = 26;
constexpr double title_height = 70, legend_height = 34;
constexpr double planes_width = 560;
constexpr double reach = 0.25;    // rapid motion is shown as far as this part of the cutting's size
constexpr double least_size = 1;  // mm

struct Words {
  const char *control, *nothing, *rapid, *feed, *arc, *plunge, *contour, *zero, *thinned, *size, *unit, *speed, *limits;
};
constexpr Words english = {"control",
                           "no motion",
                           "rapid",
                           "feed",
                           "arc",
                           "plunge",
                           "contour",
                           "work zero",
                           "thinned: of {} points, those closer than {} mm are left out",
                           "cutting",
                           "mm",
                           "speed (least time), mm/min:",
                           "limited (least time) by"};
constexpr Words russian = {"УЧПУ",
                           "нет движений",
                           "быстрый ход",
                           "рабочая подача",
                           "дуга",
                           "врезание",
                           "контур",
                           "нуль детали",
                           "прорежено: из {} точек не показаны те, что ближе {} мм",
                           "резание",
                           "мм",
                           "скорость (мин. время), мм/мин:",
                           "ограничение (мин. время):"};

const Words& words(Lang lang) { return lang == Lang::ru ? russian : english; }

void draw_title(Canvas& canvas, const PlotScene& scene) {
  const Words& w = words(scene.title.lang);
  canvas.text({margin, 42}, name_of_file(scene.title.file), {24, colour(0x20262E), Align::left, true});
  std::string line = fmt::format("{}: {}", w.control, scene.title.control);
  if (const Box& box = scene.path.cutting_box(); !box.empty) {
    const Vec3 size = box.most - box.least;
    line += fmt::format("     {}: {} × {} × {} {}", w.size, number_text(size.x, 3), number_text(size.y, 3), number_text(size.z, 3), w.unit);
  }
  canvas.text({margin, 64}, line, {14, colour(0x5B6775), Align::left, false});
  canvas.text({page_width - margin, 42}, "Kadr", {20, colour(0xA9B4C0), Align::right, true});
}

/// The scale of speeds, or the limits that occur; from x on.
///   returns  where it ends
double draw_shade_legend(Canvas& canvas, const PlotScene& scene, double x, double y) {
  const TextStyle style{13, colour(0x20262E), Align::left, false}, number{12, colour(0x20262E), Align::centre, false};
  const ShadeScale& shades = scene.shades;
  if (shades.by() == PlotColour::limit) {
    canvas.text({x, y}, words(scene.title.lang).limits, style);
    x += canvas.text_width(words(scene.title.lang).limits, style) + 16;
    for (std::size_t step = 0; step < shades.steps(); ++step) {
      if (!shades.occurs(step)) continue;
      const char* const name = limit_name(static_cast<Limit>(step), scene.title.lang);
      canvas.line({x, y - 4}, {x + 32, y - 4}, shades.ink(step), 3);
      canvas.text({x + 40, y}, name, style);
      x += 40 + canvas.text_width(name, style) + 26;
    }
    return x;
  }
  constexpr double step_width = 14, ticks = 4, bar = 9;
  const char* const name = words(scene.title.lang).speed;
  canvas.text({x, y}, name, style);
  x += canvas.text_width(name, style) + 22;
  const double width = step_width * double(shades.steps());
  for (std::size_t step = 0; step < shades.steps(); ++step)
    canvas.fill({x + double(step) * step_width, y - 18, step_width + 0.5, bar}, shades.ink(step));
  for (double tick = 0; tick <= ticks; ++tick)
    canvas.text({x + width * tick / ticks, y + 5}, number_text(shades.top() * tick / ticks, 0), number);
  return x + width + 40;
}

void draw_legend(Canvas& canvas, const PlotScene& scene) {
  const Words& w = words(scene.title.lang);
  const double y = page_height - margin / 2 - 6;
  const TextStyle style{13, colour(0x20262E), Align::left, false};
  double x = margin + 4;
  const auto entry = [&](Stroke stroke, const char* name) {
    const StrokeStyle line = style_of(stroke, 0);
    if (line.dashed) canvas.dashes(5, 4);
    if (stroke == Stroke::plunge) canvas.ring({x + 16, y - 4}, 4, line.ink, line.width);
    else canvas.line({x, y - 4}, {x + 32, y - 4}, line.ink, line.dashed ? 1.2 : 2.2);
    canvas.solid();
    canvas.text({x + 40, y}, name, style);
    x += 40 + canvas.text_width(name, style) + 26;
  };
  entry(Stroke::rapid, w.rapid);
  if (scene.shades.by() == PlotColour::stroke) {
    entry(Stroke::feed, w.feed);
    entry(Stroke::arc, w.arc);
    entry(Stroke::plunge, w.plunge);
  } else {
    x = draw_shade_legend(canvas, scene, x, y);
  }
  if (!scene.contour.points().empty()) entry(Stroke::contour, w.contour);
  canvas.zero_mark({x + 10, y - 4}, 6, style.ink);
  canvas.text({x + 24, y}, w.zero, style);
  if (scene.path.tolerance() > 0)
    canvas.text({page_width - margin, y}, fmt::format(fmt::runtime(w.thinned), scene.path.seen(), number_text(scene.path.tolerance(), 3)),
                {13, colour(0xB04A00), Align::right, false});
}

void draw_all(Canvas& canvas, const PlotScene& scene) {
  canvas.fill({0, 0, page_width, page_height}, colour(0xFFFFFF));
  draw_title(canvas, scene);
  draw_legend(canvas, scene);
  const double top = title_height + 12, bottom = page_height - margin - legend_height + 8;
  const Area large{margin, top, page_width - 2 * margin - gap - planes_width, bottom - top};
  if (scene.path.box().empty) {
    canvas.text({page_width / 2, page_height / 2}, words(scene.title.lang).nothing, {22, colour(0x5B6775), Align::centre, false});
    return;
  }
  const Box box = shown_box(scene);
  draw_isometric(canvas, large, scene, box);
  // The flatter views get what they need, the plan view the most.
  const double left = large.right() + gap;
  const double height = bottom - top + 24, plan = height * 0.46, side = (height - plan - 2 * 8) / 2;
  draw_plane(canvas, {left, top, planes_width, plan}, View::xy, scene, box);
  draw_plane(canvas, {left, top + plan + 8, planes_width, side}, View::xz, scene, box);
  draw_plane(canvas, {left, top + plan + side + 16, planes_width, side}, View::yz, scene, box);
}

}  // namespace

std::string name_of_file(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

Box shown_box(const PlotScene& scene) {
  const Box& all = scene.path.box();
  Box box = scene.path.cutting_box().empty ? all : scene.path.cutting_box();
  const Vec3 size = box.most - box.least;
  const double most = reach * std::max({size.x, size.y, size.z, least_size});
  const Vec3 room{most, most, most};
  const Box near{box.least - room, box.most + room, false};
  for (const Vec3 zero : scene.zeros) {
    const bool inside = zero.x >= near.least.x && zero.y >= near.least.y && zero.z >= near.least.z && zero.x <= near.most.x &&
                        zero.y <= near.most.y && zero.z <= near.most.z;
    if (inside) box.take(zero);
  }
  const auto widen = [&](double Vec3::*c) {
    box.least.*c = std::min(box.least.*c, std::max(all.least.*c, near.least.*c));
    box.most.*c = std::max(box.most.*c, std::min(all.most.*c, near.most.*c));
    if (const double lack = 0.02 * most - (box.most.*c - box.least.*c); lack > 0) {
      box.least.*c -= lack / 2;
      box.most.*c += lack / 2;
    }
  };
  widen(&Vec3::x);
  widen(&Vec3::y);
  widen(&Vec3::z);
  return box;
}

tl::expected<void, std::string> draw_page(const ResultFile& file, const PlotScene& scene) {
  return write_page(file, page_width, page_height, [&](Canvas& canvas) { draw_all(canvas, scene); });
}

}  // namespace kadr
