#pragma once
// Precompiled header (KADR_PRECOMPILED in CMakeLists.txt): what nearly every file includes. A file still includes what it uses, because
// clang builds without this header.

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
