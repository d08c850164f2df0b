#pragma once
// Loads the Cairo library when the first pixel picture is drawn. If the library were loaded at the start of the program, Cairo and the
// fifteen libraries that Cairo needs would take a fifth of the start-up time of every command.

#include <cairo.h>

namespace kadr {

// clang-format off
#define KADR_CAIRO(X)                                                                                                         \
  X(arc) X(clip) X(create) X(destroy) X(fill) X(image_surface_create) X(image_surface_create_for_data) X(paint) X(scale) X(translate) X(set_source_surface) X(line_to) X(move_to) X(new_path) X(new_sub_path)       \
  X(rectangle) X(restore) X(save) X(select_font_face) X(set_dash) X(set_font_size) X(set_line_cap) X(set_line_join)           \
  X(set_line_width) X(set_source_rgba) X(show_text) X(status) X(status_to_string) X(stroke) X(surface_destroy)                \
  X(surface_set_device_scale) X(surface_status) X(surface_write_to_png_stream) X(text_extents)
// clang-format on

/// The functions of Cairo that Kadr calls. The name of each member is the name of the function without its prefix `cairo_`.
struct Cairo {
#define KADR_CAIRO_FUNCTION(name) decltype(&::cairo_##name) name = nullptr;
  KADR_CAIRO(KADR_CAIRO_FUNCTION)
#undef KADR_CAIRO_FUNCTION
};

/// Returns the library, or nullptr if this computer has no Cairo. The first call loads the library, which then remains loaded.
const Cairo* cairo_library();

}  // namespace kadr
