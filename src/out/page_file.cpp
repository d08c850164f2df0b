// For out/plot_page, out/speed_page, out/mill_picture; tests/out/plot_test.cpp.

#include "out/page_file.h"

#include <cstdio>
#include <memory>

#include "config/told.h"
#include "out/canvas.h"

namespace kadr {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(Cairo::surface_destroy)>;

bool is_svg(const std::string& file) { return file.ends_with(".svg") || file.ends_with(".SVG"); }
bool is_png(const std::string& file) { return file.ends_with(".png") || file.ends_with(".PNG"); }

/// Cairo's bytes into the file.
cairo_status_t write_bytes(void* file, const unsigned char* bytes, unsigned count) {
  return std::fwrite(bytes, 1, count, static_cast<std::FILE*>(file)) == count ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

}  // namespace

bool is_page_name(const std::string& file) { return is_svg(file) || is_png(file); }

std::string page_fault(const std::string& file) {
  if (!is_page_name(file)) return file + told(": a plot is .svg or .png", ": картинка — файл .svg или .png");
  if (cairo_library() == nullptr)
    return file + told(": pictures need the library libcairo.so.2; this machine has none",
                       ": для картинок нужна библиотека libcairo.so.2, а её здесь нет");
  return {};
}

tl::expected<void, std::string> write_page(const ResultFile& file, double width, double height, const std::function<void(Canvas&)>& draw) {
  if (std::string fault = page_fault(file.name()); !fault.empty()) return tl::unexpected(fault);
  const Cairo* const cairo = cairo_library();
  const bool svg = is_svg(file.name());
  constexpr double sharp = 1.5;  // pixels a unit of the page
  const Surface surface(svg ? cairo->svg_surface_create_for_stream(write_bytes, file.get(), width, height)
                            : cairo->image_surface_create(CAIRO_FORMAT_RGB24, int(width * sharp), int(height * sharp)),
                        cairo->surface_destroy);
  if (!svg) cairo->surface_set_device_scale(surface.get(), sharp, sharp);
  {
    Canvas canvas(*cairo, surface.get());
    draw(canvas);
  }
  cairo_status_t status = cairo->surface_status(surface.get());
  if (status == CAIRO_STATUS_SUCCESS && !svg) status = cairo->surface_write_to_png_stream(surface.get(), write_bytes, file.get());
  if (svg) cairo->surface_finish(surface.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo->surface_status(surface.get());
  if (status == CAIRO_STATUS_SUCCESS) return {};
  return tl::unexpected(file.name() + ": " + told(cairo->status_to_string(status), "картинка не записана"));
}

}  // namespace kadr
