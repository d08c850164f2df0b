// zlib, opened at need. For stock/mesh/zip_read and zip_write.

#include "stock/mesh/zlib_library.h"

#include <dlfcn.h>

#include <optional>
#include <type_traits>

namespace kadr {
namespace {

std::optional<Zlib> opened_zlib() {
  void* const library = dlopen("libz.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return std::nullopt;
  Zlib zlib;
  bool whole = true;
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    whole = whole && function != nullptr;
  };
#define KADR_ZLIB_FIND(name) find(zlib.name, #name);
  KADR_ZLIB(KADR_ZLIB_FIND)
#undef KADR_ZLIB_FIND
  return whole ? std::optional(zlib) : std::nullopt;
}

}  // namespace

const Zlib* zlib_library() {
  static const std::optional<Zlib> library = opened_zlib();
  return library ? &*library : nullptr;
}

}  // namespace kadr
