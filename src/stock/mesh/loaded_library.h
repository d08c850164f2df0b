#pragma once
// Loads a C library on demand. The result is a struct of pointers to the functions that this program calls, found by their names.
//
//   #define KADR_THING(X) X(thing_open) X(thing_close)
//   struct Thing { KADR_THING(KADR_LIBRARY_FUNCTION) };
//   opened_library<Thing>("libthing.so.1", [](Thing& library, const auto& find) { KADR_THING(KADR_LIBRARY_FIND) });

#include <optional>
#include <type_traits>

#include "base/shared_library.h"

namespace kadr {

#define KADR_LIBRARY_FUNCTION(name) decltype(&::name) name = nullptr;
#ifdef __EMSCRIPTEN__  // the library is linked, as there is none to load
#define KADR_LIBRARY_FIND(name) library.name = &::name;
#else
#define KADR_LIBRARY_FIND(name) find(library.name, #name);
#endif

/// Loads the library `file`. `fill(library, find)` must call `find(function, name)` for each member of the struct.
///   returns  nullopt if the library is not installed, or lacks one of the functions
template <class Library, class Fill>
std::optional<Library> opened_library([[maybe_unused]] const char* file, const Fill& fill) {
  Library library;
  bool whole = true;
#ifdef __EMSCRIPTEN__
  fill(library, nullptr);
#else
  void* const handle = open_library(file);
  if (handle == nullptr) return std::nullopt;
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)> >(function_in(handle, name));
    whole = whole && function != nullptr;
  };
  fill(library, find);
#endif
  return whole ? std::optional(library) : std::nullopt;
}

}  // namespace kadr
