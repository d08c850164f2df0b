// Loads the Cairo library when the first pixel picture is drawn. If the library were loaded at the start of the program, Cairo and the
// fifteen libraries that Cairo needs would take a fifth of the start-up time of every command. This file is used by
// out/picture/cairo_canvas.

#include "out/picture/cairo_library.h"

#include <optional>

#include "base/shared_library.h"

namespace kadr {
namespace {

std::optional<Cairo> opened() {
  void* const library = open_library("libcairo.so.2");
  if (library == nullptr) return std::nullopt;
  Cairo cairo;
  bool whole = true;
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(function_in(library, name));
    whole = whole && function != nullptr;
  };
#define KADR_CAIRO_FIND(name) find(cairo.name, "cairo_" #name);
  KADR_CAIRO(KADR_CAIRO_FIND)
#undef KADR_CAIRO_FIND
  return whole ? std::optional(cairo) : std::nullopt;
}

}  // namespace

const Cairo* cairo_library() {
  static const std::optional<Cairo> library = opened();
  return library ? &*library : nullptr;
}

}  // namespace kadr
