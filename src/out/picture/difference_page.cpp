// Draws the page that compares two programs. This file is used by compare/difference_plot and tested by tests/diff_plot.py.

#include "out/picture/difference_page.h"

#include <algorithm>

#include "out/picture/legend_row.h"
#include "out/picture/text_width.h"
#include "out/text/page_file.h"
#include "out/text/source_line.h"
#include "texts/difference_page.h"
#include "texts/picture.h"

namespace kadr {
namespace {

constexpr double page_wide = 1600, views_height = 1082, edge_room = 28, room_between = 26;
constexpr double head_height = 70, key_height = 56, key_row = 24, right_width = 560;
constexpr double line_height = 21, line_size = 13, caption_room = 24;
// Two limits, for the isometric view and for the flat views: all rapids are shown if the size of the whole path is at most this many times
// the size of the path at feed.
constexpr double most_large = 4, most_flat = 1.5;
constexpr std::size_t few_lines = 5;  // greatest number of text lines below the picture that are written in a single column
constexpr std::size_t max_line_length = 300;
constexpr Colour faint = colour(0x5B6775), fine = colour(0x1A7F37), warns = colour(0xB04A00);

std::string text_on(const DifferencePage& page, PlainText text) { return translated_in(page.scene.title.lang, text); }

std::size_t rows_of(const DifferencePage& page) { return page.lines.size() <= few_lines ? page.lines.size() : (page.lines.size() + 1) / 2; }

double height_of(const DifferencePage& page) { return views_height + (page.lines.empty() ? 0 : double(rows_of(page)) * line_height + 16); }

// Two values: the ratio of the width of bold text to that of normal text, and the greatest width of a program name, units of the page.
constexpr double bold = 1.16, max_name = 420;

/// Shortens the text so that it fits into the width. The beginning of the text remains.
std::string fitting(std::string text, double width, double size) {
  text = shortened_line(text, max_line_length);
  if (text_width(text, size) <= width) return text;
  while (!text.empty() && text_width(text + "…", size) > width) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
    if (!text.empty()) text.pop_back();
  }
  return text + "…";
}

void draw_head(Canvas& canvas, const DifferencePage& page) {
  const PlotTitle& title = page.scene.title;
  const double room = page_wide - 2 * edge_room - 90;
  canvas.text({edge_room, 42}, fitting(title.file, room, 24 * bold), {24, colour(0x20262E), Align::left, true});
  canvas.text({page_wide - edge_room, 42}, "Kadr", {20, colour(0xA9B4C0), Align::right, true});
  const std::string control = translated_in(title.lang, texts::picture::control, title.control);
  canvas.text({edge_room, 64}, page.summary, {14, page.equal ? fine : warns, Align::left, true});
  canvas.text({page_wide - edge_room, 64}, control, {14, faint, Align::right, false});
}

void draw_key(Canvas& canvas, const DifferencePage& page, double y) {
  const PlotScene& scene = page.scene;
  canvas.begin("legend");
  LegendRow strokes(canvas, edge_room + 4, y - key_row);
  if (const PlotDifferences& d = *scene.differences; !d.a.points().empty() || !d.b.points().empty()) {
    strokes.sample(path_of_a, fitting(page.a, max_name, line_size));
    strokes.sample({path_of_b.ink, 2}, fitting(page.b, max_name, line_size));
  }
  strokes.sample({same_path.ink, 1.4}, text_on(page, texts::difference_page::both));
  if (!scene.differences->changed.points().empty()) strokes.sample(changed_path, text_on(page, texts::difference_page::both_changed));
  LegendRow signs(canvas, edge_room + 4, y);
  canvas.dashes(5, 4);
  signs.sample({same_path.ink, 1.2}, text_on(page, texts::picture::rapid));
  canvas.solid();
  if (!scene.zeros.empty()) signs.zero(text_on(page, texts::picture::work_zero));
  for (const PlotMark& mark : scene.marks) {
    if (mark.what == PlotMark::What::stop)
      signs.mark(mark.what,
                 translated_in(scene.title.lang, texts::difference_page::stopped, scene.title.file_of(mark.line), mark.line.line));
    else signs.mark(mark.what, text_on(page, mark.what == PlotMark::What::start ? texts::picture::start : texts::picture::end));
  }
  const auto stands = [](const PlotNumber& number) { return number.stands; };
  if (const auto& numbers = scene.differences->numbers; std::any_of(numbers.begin(), numbers.end(), stands))
    signs.ring(number_ink, text_on(page, texts::difference_page::between_motions));
  if (const double tolerance = scene.path.tolerance(); tolerance > 0)
    canvas.text({page_wide - edge_room, y},
                translated_in(scene.title.lang, texts::difference_page::thinned, length_text(tolerance, LengthUnit::mm)),
                {13, warns, Align::right, false});
  canvas.end();
}

/// Draws the flat views: the plan, the close-ups and, if the space suffices, the side views.
void draw_right(Canvas& canvas, const DifferencePage& page, const Area& area, const Box& box) {
  constexpr double gap = 8;
  const double plan = area.height * (page.closeups.empty() ? 0.46 : 0.36), side = (area.height - plan - 2 * gap) / 2;
  draw_plane(canvas, {area.x, area.y, area.width, plan}, View::xy, page.scene, box);
  for (std::size_t i = 0; i < 2; ++i) {
    const Area at{area.x, area.y + plan + gap + double(i) * (side + gap), area.width, side};
    if (i >= page.closeups.size()) {
      draw_plane(canvas, at, i == 0 || !page.closeups.empty() ? View::xz : View::yz, page.scene, box);
      continue;
    }
    const DifferenceCloseup& closeup = page.closeups[i];
    canvas.begin(i == 0 ? "closeup-1" : "closeup-2");
    canvas.text({at.x + 48, at.y + caption_room - 7}, fitting(closeup.caption, at.width - 48, line_size * bold),
                {line_size, colour(0x20262E), Align::left, true});
    draw_field(canvas, {at.x, at.y + caption_room, at.width, at.height - caption_room}, closeup.view, closeup.scene, closeup.box);
    canvas.end();
  }
}

void draw_lines_of(Canvas& canvas, const DifferencePage& page) {
  constexpr double number_room = 34;
  const std::size_t rows = rows_of(page);
  const double columns = page.lines.size() > rows ? 2 : 1, width = (page_wide - 2 * edge_room - (columns - 1) * room_between) / columns;
  canvas.begin("differences");
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const DifferenceLine& line = page.lines[i];
    const Vec2 at{edge_room + double(i / rows) * (width + room_between), views_height + 8 + double(i % rows) * line_height};
    if (line.number > 0)
      canvas.text({at.x + number_room - 10, at.y}, std::to_string(line.number), {line_size, number_ink, Align::right, true});
    canvas.text({at.x + number_room, at.y}, fitting(line.text, width - number_room, line_size), legend_style);
  }
  canvas.end();
}

void draw_both(Canvas& canvas, const DifferencePage& page) {
  canvas.fill({0, 0, page_wide, height_of(page)}, colour(0xFFFFFF));
  draw_head(canvas, page);
  draw_lines_of(canvas, page);
  if (page.scene.path.box().empty)
    return canvas.text({page_wide / 2, views_height / 2}, text_on(page, texts::picture::no_motion), {22, faint, Align::centre, false});
  draw_key(canvas, page, views_height - edge_room / 2 - 6);
  const double top = head_height + 12, bottom = views_height - edge_room - key_height + 8;
  const Area large{edge_room, top, page_wide - 2 * edge_room - room_between - right_width, bottom - top};
  draw_isometric(canvas, large, page.scene, shown_box(page.scene, most_large));
  draw_right(canvas, page, {large.right() + room_between, top, right_width, bottom - top + 24}, shown_box(page.scene, most_flat));
}

}  // namespace

tl::expected<void, std::string> draw_difference_page(const ResultFile& file, const DifferencePage& page) {
  const PageText page_text{page.scene.title.file, page.summary + ". " + text_on(page, texts::difference_page::strokes_have_lines),
                           page.scene.title.lang};
  return write_page(file, page_wide, height_of(page), page_text, [&](Canvas& canvas) { draw_both(canvas, page); });
}

}  // namespace kadr
