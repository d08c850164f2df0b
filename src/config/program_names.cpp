// Recognises part programs by their file names. Used by cli/job/program_files, view/served_folder; tested by tests/run_check.py and
// tests/view/served_folder_test.cpp.

#include "config/program_names.h"

#include <fnmatch.h>

#include <algorithm>
#include <iterator>

#include "base/ascii.h"

namespace kadr {
namespace {

constexpr std::string_view program_endings[] = {"nc",  "ngc", "tap", "txt", "iso",  "prg", "nct", "gcode", "gc",  "g",   "cnc", "mpf",
                                                "spf", "up",  "eia", "ptp", "tape", "min", "pim", "fnc",   "sub", "mac", "fan", "hnc"};

/// Returns the ending of a file name without the dot, in lower case; empty if the name has no ending.
std::string ending_of(std::string_view name) {
  // Removes the folders; if the name has no '/', npos + 1 is 0, so the whole name remains
  name = name.substr(name.find_last_of('/') + 1);
  const std::size_t dot = name.rfind('.');
  std::string ending(dot == std::string_view::npos || dot == 0 ? std::string_view() : name.substr(dot + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(), to_lower);
  return ending;
}

}  // namespace

NameVerdict judge_name(std::string_view name) {
  const std::string ending = ending_of(name);
  if (std::all_of(ending.begin(), ending.end(), is_digit)) return NameVerdict::nothing;
  if (ending == "h") return NameVerdict::nothing;  // a conversational program, or a header of C
  return std::find(std::begin(program_endings), std::end(program_endings), ending) == std::end(program_endings) ? NameVerdict::other
                                                                                                                : NameVerdict::program;
}

bool is_number_name(std::string_view name) {
  constexpr std::size_t max_letters = 2;
  name = name.substr(name.find_last_of('/') + 1);
  const std::size_t first = std::min(name.find_first_of("0123456789"), name.size());
  if (first > max_letters || first == name.size()) return false;
  const bool letters = std::all_of(name.begin(), name.begin() + std::ptrdiff_t(first), [](char c) { return is_letter(c) || c == '%'; });
  return letters && name.find_first_not_of("0123456789.", first) == std::string_view::npos;
}

bool is_like(const std::string& path, const std::string& pattern) {
  const std::size_t slash = path.rfind('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  return ::fnmatch(pattern.c_str(), path.c_str(), 0) == 0 || ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

}  // namespace kadr
