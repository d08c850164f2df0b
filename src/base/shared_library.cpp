// Opens shared libraries while the program runs. Used by out/picture/cairo_library, stock/bodies/bodies_library, stock/mesh/loaded_library;
// tested by tests/base/shared_library_test.cpp.

#include "base/shared_library.h"

#include <dlfcn.h>

namespace kadr {

#ifdef __EMSCRIPTEN__  // a call of dlopen() would end the whole program there
void* open_library(const char*, bool) { return nullptr; }
void* function_in(void*, const char*) { return nullptr; }
void close_library(void*) {}
#else
void* open_library(const char* file, bool whole) { return dlopen(file, (whole ? RTLD_NOW : RTLD_LAZY) | RTLD_LOCAL); }
void* function_in(void* library, const char* name) { return dlsym(library, name); }
void close_library(void* library) { dlclose(library); }
#endif

}  // namespace kadr
