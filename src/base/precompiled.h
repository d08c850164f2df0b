#pragma once
// Precompiled header (KADR_PRECOMPILED in CMakeLists.txt) with the headers that nearly every file includes. A source file still includes
// every header that it uses, because builds with clang do without the precompiled header.

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
