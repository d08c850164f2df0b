// Draws a page to a file or to memory. This file is used by out/picture/plot/plot_page, out/picture/speed_page and
// out/picture/mill_picture, and tested by tests/out/plot_test.cpp.

#include "out/text/page_file.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "config/read_file.h"
#include "out/picture/cairo_canvas.h"
#include "texts/picture.h"

namespace kadr {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(Cairo::surface_destroy)>;

bool is_svg(const std::string& file) { return file.ends_with(".svg") || file.ends_with(".SVG"); }
bool is_png(const std::string& file) { return file.ends_with(".png") || file.ends_with(".PNG"); }

/// Writes PNG data to the file. Cairo calls this function.
cairo_status_t write_bytes(void* file, const unsigned char* bytes, unsigned count) {
  return std::fwrite(bytes, 1, count, static_cast<std::FILE*>(file)) == count ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

tl::expected<void, std::string> write_svg(const ResultFile& file, double width, double height, const PageText& page_text,
                                          const std::function<void(Canvas&)>& draw) {
  SvgCanvas canvas(file.get(), width, height, page_text);
  draw(canvas);
  if (const int error = canvas.finish(); error != 0) return tl::unexpected(file.name() + ": " + errno_message(error));
  return {};
}

tl::expected<void, std::string> write_png(const ResultFile& file, double width, double height, const std::function<void(Canvas&)>& draw) {
  const Cairo* const cairo = cairo_library();
  constexpr double sharp = 1.5;  // number of pixels per unit of the page
  const Surface surface(cairo->image_surface_create(CAIRO_FORMAT_RGB24, int(width * sharp), int(height * sharp)), cairo->surface_destroy);
  cairo->surface_set_device_scale(surface.get(), sharp, sharp);
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  {
    CairoCanvas canvas(*cairo, surface.get());
    draw(canvas);
    status = canvas.status();
  }
  if (status == CAIRO_STATUS_SUCCESS) status = cairo->surface_status(surface.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo->surface_write_to_png_stream(surface.get(), write_bytes, file.get());
  if (status == CAIRO_STATUS_SUCCESS) return {};
  // Cairo's own messages are only available in English.
  const Lang lang = thread_language();
  return tl::unexpected(file.name() + ": " +
                        (lang == Lang::en ? cairo->status_to_string(status) : plain_text(texts::picture::not_written)));
}

}  // namespace

std::string svg_page(double width, double height, const PageText& page_text, const std::function<void(Canvas&)>& draw) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* const file = ::open_memstream(&text, &size);
  if (file == nullptr) return {};
  int error = 0;
  {
    SvgCanvas canvas(file, width, height, page_text);
    draw(canvas);
    error = canvas.finish();
  }
  const bool closed = std::fclose(file) == 0;
  const std::unique_ptr<char, decltype(&std::free)> its(text, std::free);
  return error == 0 && closed ? std::string(text, size) : std::string();
}

bool is_page_name(const std::string& file) { return is_svg(file) || is_png(file); }

std::string page_fault(const std::string& file) {
  if (!is_page_name(file)) return translated(texts::picture::not_svg_or_png, file);
  if (is_png(file) && cairo_library() == nullptr) return translated(texts::picture::no_cairo, file);
  return {};
}

tl::expected<void, std::string> write_page(const ResultFile& file, double width, double height, const PageText& page_text,
                                           const std::function<void(Canvas&)>& draw) {
  if (std::string fault = page_fault(file.name()); !fault.empty()) return tl::unexpected(fault);
  return is_svg(file.name()) ? write_svg(file, width, height, page_text, draw) : write_png(file, width, height, draw);
}

}  // namespace kadr
