// Reads and writes the file that stores LinuxCNC's parameters between runs.

#include "control/linuxcnc/files/parameter_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>

namespace kadr::linuxcnc {
namespace {

constexpr int beyond_parameters = 5602;
constexpr std::size_t longest_line = 255;  // greatest length of a line in characters; LinuxCNC reads what follows as another line

/// Returns the parameters that the file must have: 5161…5169, 5181…5189, 5210…5220, and those of the nine work systems and their rotations.
std::set<std::uint32_t> needed() {
  std::set<std::uint32_t> all;
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t n = from; n <= to; ++n) all.insert(n);
  };
  add(5161, 5169);
  add(5181, 5189);
  add(5210, 5220);
  for (std::uint32_t first = 5221; first <= 5381; first += 20) add(first, first + 9);
  return all;
}

}  // namespace

tl::expected<StoredParameters, std::string> read_parameters(std::string_view text) {
  StoredParameters all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min({text.find('\n', at), text.size(), at + longest_line});
    const std::string line(text.substr(at, end - at));
    at = end < text.size() && text[end] == '\n' ? end + 1 : end;
    int number = 0;
    double value = 0;
    if (std::sscanf(line.c_str(), "%d %lf", &number, &value) != 2) continue;
    if (number <= 0 || number >= beyond_parameters) return tl::unexpected(std::string("Parameter number out of range"));
    const auto n = static_cast<std::uint32_t>(number);
    if (!all.empty() && n <= all.rbegin()->first) return tl::unexpected(std::string("Parameter file out of order"));
    all.emplace(n, value);
  }
  return all;
}

std::string parameters_text(const StoredParameters& before, const std::function<double(std::uint32_t)>& value) {
  std::set<std::uint32_t> numbers = needed();
  for (const auto& [number, old] : before) numbers.insert(number);
  std::string text;
  for (const std::uint32_t n : numbers) text += fmt::format("{}\t{:.6f}\n", n, value(n));
  return text;
}

}  // namespace kadr::linuxcnc
