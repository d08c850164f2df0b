#pragma once
// What nearly every file of Kadr includes, read once (KADR_PRECOMPILED in CMakeLists.txt). A file still includes what it uses: clang builds
// without it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <unordered_map>
#include <variant>
#include <vector>
