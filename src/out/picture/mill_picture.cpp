// Draws a milled area in plan view, as SVG or PNG: its contours and the path of the tool centre. This file is used by cli/mill and
// view/page/page_making.

#include "out/picture/mill_picture.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "out/picture/canvas.h"
#include "out/picture/text_width.h"
#include "out/text/page_file.h"
#include "path/pocketing/polygon.h"
#include "texts/picture.h"

namespace kadr {
namespace {

constexpr double mill_page_width = 1000, mill_page_margin = 30, mill_title_height = 64, mill_legend_height = 40, tallest = 1400,
                 least_mill_size = 1;
constexpr double mill_chord = 0.05;  // greatest distance of an arc from the straight lines that approximate it, units of the page
constexpr Colour contour = colour(0x20262E), open_side = colour(0xB04A00), cutting = colour(0x1F6FEB), swept_ink = colour(0xE2ECFB),
                 plunging = colour(0x1A9850), rapid = colour(0x8A949F);

class Drawing {
 public:
  Drawing(const MillPicture& picture) : picture_(picture) {
    for (const auto& zone : picture.zones)
      for (const auto& loop : zone.loops)
        for (const Edge& e : loop) box_.take(e);
    for (std::size_t i = 1; i < picture.moves.size(); ++i)
      if (picture.moves[i].kind != area::MoveKind::rapid) box_.take(Vec2{picture.moves[i].to.x, picture.moves[i].to.y});
    box_.take(box_.least - Vec2{picture.radius, picture.radius});
    box_.take(box_.most + Vec2{picture.radius, picture.radius});
    const Vec2 size = box_.most - box_.least;
    scale_ = std::min((mill_page_width - 2 * mill_page_margin) / std::max(size.x, least_mill_size),
                      (tallest - mill_title_height - mill_legend_height - mill_page_margin) / std::max(size.y, least_mill_size));
    height_ = mill_title_height + mill_legend_height + mill_page_margin + scale_ * size.y;
  }

  double height() const { return height_; }

  void draw(Canvas& canvas) const {
    canvas.fill({0, 0, mill_page_width, height_}, colour(0xFFFFFF));
    canvas.text({mill_page_margin, 36}, picture_.title, {22, contour, Align::left, true});
    canvas.text({mill_page_margin, 56}, picture_.subtitle, {13, colour(0x5B6775), Align::left, false});
    canvas.text({mill_page_width - mill_page_margin, 36}, "Kadr", {20, colour(0xA9B4C0), Align::right, true});
    path(canvas, swept_ink, 2 * picture_.radius * scale_, [&](const area::Move& m, double) { return m.kind == area::MoveKind::feed; });
    for (const auto& zone : picture_.zones)
      for (const auto& loop : zone.loops)
        for (const Edge& e : loop) edge(canvas, e, e.open ? open_side : contour, 2.2, e.open);
    path(
        canvas, rapid, 1, [&](const area::Move& m, double) { return m.kind == area::MoveKind::rapid; }, true);
    path(canvas, cutting, 1.4, [&](const area::Move& m, double) { return m.kind == area::MoveKind::feed; });
    path(canvas, plunging, 1.6, [&](const area::Move& m, double) { return m.kind == area::MoveKind::plunge; });
    arrows(canvas);
    marks(canvas);
    legend(canvas);
  }

 private:
  Vec2 page(Vec2 p) const {
    const double left = (mill_page_width - scale_ * (box_.most.x - box_.least.x)) / 2;
    return {left + scale_ * (p.x - box_.least.x), mill_title_height + scale_ * (box_.most.y - p.y)};
  }

  void edge(Canvas& canvas, const Edge& e, Colour ink, double width, bool dashed) const {
    if (dashed) canvas.dashes(8, 5);
    canvas.pen(ink, width);
    canvas.move_to(page(e.from));
    for (const Vec2 p : area::flattened({e}, mill_chord / scale_)) canvas.line_to(page(p));
    canvas.line_to(page(e.to));
    canvas.stroke();
    canvas.solid();
  }

  /// Draws the segments of the moves for which the function `chosen` returns true.
  template <class Chosen>
  void path(Canvas& canvas, Colour ink, double width, Chosen chosen, bool dashed = false) const {
    canvas.pen(ink, width);
    if (dashed) canvas.dashes(5, 4);
    bool down = false;
    for (std::size_t i = 1; i < picture_.moves.size(); ++i) {
      const area::Move& m = picture_.moves[i];
      const Vec3 from = picture_.moves[i - 1].to;
      if (!chosen(m, from.z)) {
        if (down) canvas.stroke();
        down = false;
        continue;
      }
      const Edge e{{from.x, from.y}, {m.to.x, m.to.y}, m.bulge};
      if (!down) canvas.move_to(page(e.from));
      down = true;
      for (const Vec2 p : area::flattened({e}, mill_chord / scale_)) canvas.line_to(page(p));
      canvas.line_to(page(e.to));
    }
    if (down) canvas.stroke();
    canvas.solid();
  }

  /// Draws arrows in the direction of motion on the long segments.
  void arrows(Canvas& canvas) const {
    for (std::size_t i = 1; i < picture_.moves.size(); ++i) {
      const area::Move& m = picture_.moves[i];
      const Vec3 from = picture_.moves[i - 1].to;
      const Edge e{{from.x, from.y}, {m.to.x, m.to.y}, m.bulge};
      if (m.kind != area::MoveKind::feed || area::length_of(e) * scale_ < 60) continue;
      const Vec2 middle = page(area::at(e, 0.5)), direction = area::direction(e, 0.5);
      canvas.arrow(middle - Vec2{4 * direction.x, -4 * direction.y}, middle + Vec2{4 * direction.x, -4 * direction.y}, cutting, 1.2);
    }
  }

  /// Marks the points where the tool moves straight down, and the drilled holes.
  void marks(Canvas& canvas) const {
    for (std::size_t i = 1; i < picture_.moves.size(); ++i) {
      const Vec3 from = picture_.moves[i - 1].to, to = picture_.moves[i].to;
      if (picture_.moves[i].kind == area::MoveKind::plunge && length(Vec2{to.x - from.x, to.y - from.y}) < tol::same_point)
        canvas.ring(page({to.x, to.y}), 4.5, plunging, 1.8);
    }
    for (const Vec2 hole : picture_.holes) {
      canvas.ring(page(hole), std::max(6.0, picture_.radius * scale_), plunging, 1.2);
      canvas.zero_mark(page(hole), 5, plunging);
    }
  }

  void legend(Canvas& canvas) const {
    const double y = height_ - 16;
    double x = mill_page_margin;
    const auto entry = [&](Colour ink, double width, bool dashed, PlainText id) {
      const char* const name = plain_text(id, picture_.lang);
      if (dashed) canvas.dashes(6, 4);
      canvas.line({x, y - 4}, {x + 32, y - 4}, ink, width);
      canvas.solid();
      const TextStyle style{13, contour, Align::left, false};
      canvas.text({x + 40, y}, name, style);
      x += 40 + text_width(name, style.size) + 26;
    };
    entry(contour, 2.2, false, texts::picture::wall);
    entry(open_side, 2.2, true, texts::picture::open_side);
    entry(cutting, 1.4, false, texts::picture::feed);
    entry(plunging, 1.6, false, texts::picture::plunge_or_ramp);
    entry(rapid, 1, true, texts::picture::rapid);
  }

  const MillPicture& picture_;
  area::Bounds box_;
  double scale_ = 1, height_ = 0;
};

}  // namespace

tl::expected<void, std::string> draw_milling(const ResultFile& file, const MillPicture& picture) {
  const Drawing drawing(picture);
  return write_page(file, mill_page_width, drawing.height(), {picture.title, picture.subtitle, picture.lang},
                    [&](Canvas& canvas) { drawing.draw(canvas); });
}

std::string milling_svg(const MillPicture& picture) {
  const Drawing drawing(picture);
  return svg_page(mill_page_width, drawing.height(), {picture.title, picture.subtitle, picture.lang},
                  [&](Canvas& canvas) { drawing.draw(canvas); });
}

}  // namespace kadr
