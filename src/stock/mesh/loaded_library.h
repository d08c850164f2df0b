#pragma once
// Loads a C library on demand. The result is a struct of pointers to the functions that this program calls, found by their names.
//
//   #define KADR_THING(X) X(thing_open) X(thing_close)
//   struct Thing { KADR_THING(KADR_LIBRARY_FUNCTION) };
//   opened_library<Thing>("libthing.so.1", [](Thing& library, const auto& find) { KADR_THING(KADR_LIBRARY_FIND) });

#include <dlfcn.h>

#include <optional>
#include <type_traits>

namespace kadr {

#define KADR_LIBRARY_FUNCTION(name) decltype(&::name) name = nullptr;
#define KADR_LIBRARY_FIND(name) find(library.name, #name);

/// Loads the library `file`. `fill(library, find)` must call `find(function, name)` for each member of the struct.
///   returns  nullopt if the library is not installed, or lacks one of the functions
template <class Library, class Fill>
std::optional<Library> opened_library(const char* file, const Fill& fill) {
  void* const handle = dlopen(file, RTLD_LAZY | RTLD_LOCAL);
  if (handle == nullptr) return std::nullopt;
  Library library;
  bool whole = true;
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
    whole = whole && function != nullptr;
  };
  fill(library, find);
  return whole ? std::optional(library) : std::nullopt;
}

}  // namespace kadr
