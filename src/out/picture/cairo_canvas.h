#pragma once
// CairoCanvas: an implementation of Canvas that draws a page as pixels with the Cairo library.

#include "out/picture/cairo_library.h"
#include "out/picture/canvas.h"

namespace kadr {

/// Draws on a Cairo surface that the caller owns.
class CairoCanvas final : public Canvas {
 public:
  CairoCanvas(const Cairo& library, cairo_surface_t* surface) : lib_(library), cairo_(lib_.create(surface)) {}
  ~CairoCanvas() override { lib_.destroy(cairo_); }

  void fill(const Area& area, Colour ink) override;
  void ring(Vec2 centre, double radius, Colour ink, double width) override;
  void pixels(const Area& area, const Pixels& picture) override;
  void clip(const Area& area) override;
  void unclip() override { lib_.restore(cairo_); }
  void pen(Colour ink, double width) override;
  void dashes(double on, double off) override;
  void move_to(Vec2 p) override { lib_.move_to(cairo_, p.x, p.y); }
  void line_to(Vec2 p) override { lib_.line_to(cairo_, p.x, p.y); }
  void fill_path() override { lib_.fill(cairo_); }
  void stroke() override { lib_.stroke(cairo_); }
  /// Returns the first error of Cairo since the drawing began, or its status "success".
  cairo_status_t status() const { return lib_.status(cairo_); }

 private:
  void put_text(Vec2 at, const std::string& text, const TextStyle& style) override;

  const Cairo& lib_;
  cairo_t* cairo_;
};

/// Returns the picture as a PNG file. The result is empty if Cairo is not available.
std::string png_of(const Pixels& picture);

}  // namespace kadr
