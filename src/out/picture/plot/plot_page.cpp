// Draws the page of a plot: the title at the top, a large isometric view on the left, the planes on the right, the legend at the bottom;
// of a lathe one view with Z to the right and X upwards.
// This file is used by cli and out.

#include "out/picture/plot/plot_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "out/picture/plot/plot_differences.h"
#include "out/picture/plot/plot_legend.h"
#include "out/picture/plot/plot_strokes.h"
#include "out/picture/plot/plot_view.h"
#include "out/text/page_file.h"
#include "texts/picture.h"
#include "texts/plot_legend.h"

namespace kadr {
namespace {

constexpr double page_width = 1600, page_height = 1082, margin = 28, gap = 26;
constexpr double title_height = 70, legend_height = 56;
constexpr double planes_width = 560;
// If far rapids are not shown completely, a view shows them up to this distance from the cutting, as a fraction of the size of the cutting.
constexpr double near_reach = 0.25;
constexpr double least_size = 1;  // least size of the box that a view shows, mm
// Two limits, for the isometric view and for the views of a plane: all rapid motion is shown if the size of the whole path is at most this
// many times the size of the cutting. With a greater ratio the part would be drawn too small.
constexpr double max_isometric = 4, most_plane = 1.5;

std::string control_line(const PlotTitle& title) { return translated_in(title.lang, texts::picture::control, title.control); }

void draw_title(Canvas& canvas, const PlotScene& scene) {
  const PlotTitle& title = scene.title;
  canvas.text({margin, 42}, name_of_file(title.file), {24, colour(0x20262E), Align::left, true});
  canvas.text({margin, 64}, control_line(title) + (title.extents.empty() ? "" : "     ") + title.extents,
              {14, colour(0x5B6775), Align::left, false});
  canvas.text({page_width - margin, 42}, "Kadr", {20, colour(0xA9B4C0), Align::right, true});
}

bool holds(const Box& box, const Box& inner) {
  const auto within = [&](double Vec3::*c) { return box.least.*c <= inner.least.*c && inner.most.*c <= box.most.*c; };
  return inner.empty || (within(&Vec3::x) && within(&Vec3::y) && within(&Vec3::z));
}

void draw_all(Canvas& canvas, const PlotScene& scene) {
  canvas.fill({0, 0, page_width, page_height}, colour(0xFFFFFF));
  draw_title(canvas, scene);
  const bool moves = !scene.path.box().empty;
  const Box whole = moves ? shown_box(scene, max_isometric) : Box(), near = moves ? shown_box(scene, most_plane) : Box();
  draw_legend(canvas, scene, margin + 4, page_width - margin, page_height - margin / 2 - 6, moves && !holds(near, scene.path.box()));
  const double top = title_height + 12, bottom = page_height - margin - legend_height + 8;
  const Area large{margin, top, page_width - 2 * margin - gap - planes_width, bottom - top};
  if (!moves) {
    canvas.text({page_width / 2, page_height / 2}, plain_text(texts::picture::no_motion, scene.title.lang),
                {22, colour(0x5B6775), Align::centre, false});
    return;
  }
  if (scene.lathe) return draw_plane(canvas, {margin, top, page_width - 2 * margin, bottom - top + 24}, View::zx, scene, near);
  draw_isometric(canvas, large, scene, whole);
  // The height is divided between the three flat views according to their needs. The plan view gets most of it.
  const double left = large.right() + gap;
  const double height = bottom - top + 24, plan = height * 0.46, side = (height - plan - 2 * 8) / 2;
  draw_plane(canvas, {left, top, planes_width, plan}, View::xy, scene, near);
  draw_plane(canvas, {left, top + plan + 8, planes_width, side}, View::xz, scene, near);
  draw_plane(canvas, {left, top + plan + side + 16, planes_width, side}, View::yz, scene, near);
}

}  // namespace

std::vector<const PlotPath*> paths_of(const PlotScene& scene) {
  std::vector<const PlotPath*> paths = {&scene.path, &scene.contour};
  if (const PlotDifferences* const d = scene.differences) paths.insert(paths.end(), {&d->changed, &d->a, &d->b});
  return paths;
}

std::string name_of_file(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

Box shown_box(const PlotScene& scene, double max_times) {
  const Box& all = scene.path.box();
  Box box = scene.path.cutting_box();
  box.take(scene.contour.box());
  if (box.empty) box = all;
  const Vec3 size = box.most - box.least;
  const double most = std::max({size.x, size.y, size.z, least_size});
  const auto room = [most](double part) { return part * most * Vec3{1, 1, 1}; };
  const Box core = box, near{core.least - room(near_reach), core.most + room(near_reach), false};
  for (const Vec3 zero : scene.zeros)
    if (holds(near, {zero, zero, false})) box.take(zero);
  const auto widen = [&](double Vec3::*c) {
    const bool whole = all.most.*c - all.least.*c <= max_times * most;
    box.least.*c = std::min(box.least.*c, whole ? all.least.*c : std::max(all.least.*c, near.least.*c));
    box.most.*c = std::max(box.most.*c, whole ? all.most.*c : std::min(all.most.*c, near.most.*c));
    if (const double lack = 0.02 * near_reach * most - (box.most.*c - box.least.*c); lack > 0) {
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
  const PlotTitle& title = scene.title;
  const std::string extents = title.extents.empty() ? "" : title.extents + ". ";
  const PlainText about_lines = lines_are_tagged(scene) ? texts::plot_legend::strokes_have_lines : texts::plot_legend::too_many_strokes;
  const PageText page_text{name_of_file(title.file),
                           fmt::format("{}. {}{}", control_line(title), extents, plain_text(about_lines, title.lang)), title.lang};
  return write_page(file, page_width, page_height, page_text, [&](Canvas& canvas) { draw_all(canvas, scene); });
}

}  // namespace kadr
