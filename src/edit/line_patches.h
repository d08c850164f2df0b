#pragma once
// LinePatches: lines that an edit writes as a whole, and lines that it adds.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace kadr {

struct LinePatches {
  std::map<std::uint32_t, std::string> instead;             // by line: the text that replaces it, UTF-8
  std::map<std::uint32_t, std::vector<std::string>> after;  // by line: the lines that follow it, UTF-8
};

}  // namespace kadr
