// CairoCanvas: draws a page as pixels. It is used by out/text/page_file.

#include "out/picture/cairo_canvas.h"

#include <array>

namespace kadr {
namespace {

/// Creates a Cairo surface from the pixels of an image. The image must outlive the surface. Cairo reads the pixels but does not change
/// them.
cairo_surface_t* surface_of(const Cairo& lib, const Pixels& picture) {
  auto* const data = reinterpret_cast<unsigned char*>(const_cast<std::uint32_t*>(picture.argb.data()));
  return lib.image_surface_create_for_data(data, CAIRO_FORMAT_ARGB32, picture.width, picture.height, picture.width * 4);
}

}  // namespace

void CairoCanvas::pen(Colour ink, double width) {
  lib_.set_source_rgba(cairo_, ink.red, ink.green, ink.blue, ink.alpha);
  lib_.set_line_width(cairo_, width);
  lib_.set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  lib_.set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
}

void CairoCanvas::fill(const Area& area, Colour ink) {
  pen(ink, 1);
  lib_.rectangle(cairo_, area.x, area.y, area.width, area.height);
  lib_.fill(cairo_);
}

void CairoCanvas::dashes(double on, double off) {
  const std::array<double, 2> lengths = {on, off};
  lib_.set_dash(cairo_, lengths.data(), on > 0 ? 2 : 0, 0);
}

void CairoCanvas::put_text(Vec2 at, const std::string& text, const TextStyle& style) {
  lib_.select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  lib_.set_font_size(cairo_, style.size);
  cairo_text_extents_t extents;
  lib_.text_extents(cairo_, text.c_str(), &extents);
  const double width = extents.x_advance;
  const double left = style.align == Align::left ? at.x : style.align == Align::centre ? at.x - width / 2 : at.x - width;
  lib_.set_source_rgba(cairo_, style.ink.red, style.ink.green, style.ink.blue, style.ink.alpha);
  lib_.move_to(cairo_, left, at.y);
  lib_.show_text(cairo_, text.c_str());
  lib_.new_path(cairo_);
}

void CairoCanvas::ring(Vec2 centre, double radius, Colour ink, double width) {
  pen(ink, width);
  lib_.new_sub_path(cairo_);
  lib_.arc(cairo_, centre.x, centre.y, radius, 0, 2 * pi);
  lib_.stroke(cairo_);
}

void CairoCanvas::pixels(const Area& area, const Pixels& picture) {
  cairo_surface_t* const surface = surface_of(lib_, picture);
  lib_.save(cairo_);
  lib_.translate(cairo_, area.x, area.y);
  lib_.scale(cairo_, area.width / picture.width, area.height / picture.height);
  lib_.set_source_surface(cairo_, surface, 0, 0);
  lib_.paint(cairo_);
  lib_.restore(cairo_);
  lib_.surface_destroy(surface);
}

std::string png_of(const Pixels& picture) {
  const Cairo* const cairo = cairo_library();
  if (cairo == nullptr) return {};
  std::string bytes;
  cairo_surface_t* const surface = surface_of(*cairo, picture);
  cairo->surface_write_to_png_stream(
      surface,
      [](void* to, const unsigned char* data, unsigned count) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), count);
        return CAIRO_STATUS_SUCCESS;
      },
      &bytes);
  cairo->surface_destroy(surface);
  return bytes;
}

void CairoCanvas::clip(const Area& area) {
  lib_.save(cairo_);
  lib_.rectangle(cairo_, area.x, area.y, area.width, area.height);
  lib_.clip(cairo_);
}

}  // namespace kadr
