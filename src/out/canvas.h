#pragma once
// Canvas: the few strokes and texts that a plot needs, over Cairo.

#include <string>
#include <string_view>

#include "base/vec.h"
#include "out/cairo_library.h"

namespace kadr {

struct Colour {
  double red, green, blue;
  double alpha = 1;
};

/// 0xRRGGBB
constexpr Colour colour(unsigned rgb, double alpha = 1) {
  return {double(rgb >> 16 & 0xFF) / 255, double(rgb >> 8 & 0xFF) / 255, double(rgb & 0xFF) / 255, alpha};
}

/// Rectangle of the page, y downwards.
struct Area {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

enum class Align { left, centre, right };

struct TextStyle {
  double size = 13;
  Colour ink = colour(0x20262E);
  Align align = Align::left;
  bool bold = false;
};

/// Draws on a surface that it does not own.
class Canvas {
 public:
  Canvas(const Cairo& library, cairo_surface_t* surface) : lib_(library), cairo_(lib_.create(surface)) {}
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  ~Canvas() { lib_.destroy(cairo_); }

  void fill(const Area& area, Colour ink);
  void frame(const Area& area, Colour ink, double width = 1);
  void line(Vec2 a, Vec2 b, Colour ink, double width = 1);
  void dashes(double on, double off);
  void solid() { lib_.set_dash(cairo_, nullptr, 0, 0); }
  void text(Vec2 at, std::string_view text, const TextStyle& style);
  double text_width(std::string_view text, const TextStyle& style);
  void ring(Vec2 centre, double radius, Colour ink, double width);
  void zero_mark(Vec2 centre, double radius, Colour ink);
  void arrow(Vec2 from, Vec2 to, Colour ink, double width);

  void clip(const Area& area);
  void unclip() { lib_.restore(cairo_); }

  void pen(Colour ink, double width);
  void move_to(Vec2 p) { lib_.move_to(cairo_, p.x, p.y); }
  void line_to(Vec2 p) { lib_.line_to(cairo_, p.x, p.y); }
  /// Closes the path and fills it.
  void fill_path() { lib_.fill(cairo_); }
  void stroke() { lib_.stroke(cairo_); }

 private:
  void font(const TextStyle& style);
  const Cairo& lib_;
  cairo_t* cairo_;
};

}  // namespace kadr
