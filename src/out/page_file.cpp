#include "out/page_file.h"

#include <memory>

#include "out/canvas.h"

namespace kadr {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(Cairo::surface_destroy)>;

bool is_svg(const std::string& file) { return file.ends_with(".svg") || file.ends_with(".SVG"); }
bool is_png(const std::string& file) { return file.ends_with(".png") || file.ends_with(".PNG"); }

}  // namespace

bool is_page_name(const std::string& file) { return is_svg(file) || is_png(file); }

tl::expected<void, std::string> write_page(const std::string& file, double width, double height, const std::function<void(Canvas&)>& draw) {
  const bool svg = is_svg(file), png = is_png(file);
  if (!svg && !png) return tl::unexpected(file + ": a plot is .svg or .png");
  const Cairo* const cairo = cairo_library();
  if (cairo == nullptr) return tl::unexpected(file + ": pictures need the library libcairo.so.2; this machine has none");
  constexpr double sharp = 1.5;  // pixels a unit of the page
  const Surface surface(svg ? cairo->svg_surface_create(file.c_str(), width, height)
                            : cairo->image_surface_create(CAIRO_FORMAT_RGB24, int(width * sharp), int(height * sharp)),
                        cairo->surface_destroy);
  if (png) cairo->surface_set_device_scale(surface.get(), sharp, sharp);
  {
    Canvas canvas(*cairo, surface.get());
    draw(canvas);
  }
  cairo_status_t status = cairo->surface_status(surface.get());
  if (status == CAIRO_STATUS_SUCCESS && png) status = cairo->surface_write_to_png(surface.get(), file.c_str());
  if (svg) cairo->surface_finish(surface.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo->surface_status(surface.get());
  return status == CAIRO_STATUS_SUCCESS ? tl::expected<void, std::string>() : tl::unexpected(file + ": " + cairo->status_to_string(status));
}

}  // namespace kadr
