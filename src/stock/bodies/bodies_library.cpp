// Loads the module for solid bodies on demand. Used by stock/bodies/body_world.

#include "stock/bodies/bodies_library.h"

#ifndef __EMSCRIPTEN__
#include <dlfcn.h>
#endif

#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "base/shared_library.h"

namespace kadr {
namespace {

constexpr const char* bodies_file = "kadr-bodies.so";
// The folders in which the module is searched for. The first two are relative to the folder of the program, the next two to the folder of
// libkadr.so, the last to the folder of the tests in a build.
constexpr const char* bodies_folders[] = {"", "../lib/kadr/modules/", "kadr/modules/", "../kadr/modules/", "../"};

/// Returns the folder of the program or library that contains this code, with a final `/`; empty if unknown.
std::string folder_of_this() {
#ifdef __EMSCRIPTEN__
  return "";
#else
  static const char here = 0;
  Dl_info info{};
  if (dladdr(&here, &info) == 0 || info.dli_fname == nullptr) return "";
  // dladdr may return the program's name as the user typed it, without a folder; in this case /proc/self/exe leads to the file.
  const char* const name = std::string_view(info.dli_fname).find('/') == std::string_view::npos ? "/proc/self/exe" : info.dli_fname;
  const std::unique_ptr<char, void (*)(void*)> whole(realpath(name, nullptr), std::free);
  if (!whole) return "";
  const std::string path = whole.get();
  return path.substr(0, path.rfind('/') + 1);
#endif
}

const KadrBodiesInterface* opened_bodies() {
  const std::string folder = folder_of_this();
  if (folder.empty()) return nullptr;
  for (const char* const under : bodies_folders) {
    void* const library = open_library((folder + under + bodies_file).c_str(), true);
    if (library == nullptr) continue;
    const auto entry = reinterpret_cast<KadrBodiesEntry>(function_in(library, kadr_bodies_entry));
    const KadrBodiesInterface* const door = entry == nullptr ? nullptr : entry();
    if (door != nullptr && door->version == kadr_bodies_version) return door;
    close_library(library);
  }
  return nullptr;
}

}  // namespace

const KadrBodiesInterface* bodies_library() {
  static const KadrBodiesInterface* const door = opened_bodies();
  return door;
}

}  // namespace kadr
