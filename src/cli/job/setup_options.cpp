// --tool, --zero, --corrector: set-up data from the command line, which are added to the set-up file or override it. This file is used by
// cli/job/job.

#include "cli/job/setup_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/ascii.h"
#include "config/setup/setup_names.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

using Json = nlohmann::json;

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_whole(std::string_view text) { return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos; }

/// A name with a number, e.g. "r8", "X-400", "X=-400".
struct Named {
  std::string name;
  double value = 0;
};

std::optional<std::vector<Named>> list_of(std::string_view text) {
  std::vector<Named> list;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view item = text.substr(0, comma);
    std::size_t letters = 0;
    while (letters < item.size() && is_letter(item[letters])) ++letters;
    const std::size_t equals = letters < item.size() && item[letters] == '=' ? 1 : 0;
    const auto value = number_of(item.substr(letters + equals));
    if (letters == 0 || !value) return std::nullopt;
    list.push_back({std::string(item.substr(0, letters)), *value});
    if (comma + 1 == text.size()) return std::nullopt;  // a comma at the end of the text is an error
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  if (list.empty()) return std::nullopt;
  return list;
}

/// Splits the text at its first `at`, which is ':' or '='.
std::pair<std::string, std::string_view> cut(std::string_view text, char at) {
  const std::size_t place = std::min(text.find(at), text.size());
  return {std::string(text.substr(0, place)), text.substr(std::min(place + 1, text.size()))};
}

// The letters of --tool and the keys of the set-up; x, y, z, t are those of a turning tool.
constexpr std::pair<std::string_view, const char*> tool_keys[] = {
    {"r", "radius"}, {"l", "length"}, {"rw", "radius_wear"}, {"lw", "length_wear"}, {"x", "X"},      {"y", "Y"},
    {"z", "Z"},      {"t", "tip"},    {"xw", "X_wear"},      {"yw", "Y_wear"},      {"zw", "Z_wear"}};

std::optional<Json> tool(const std::string& text) {
  const auto [number, values] = cut(text, ':');
  const auto list = list_of(values);
  if (!is_whole(number) || !list) return std::nullopt;
  Json row = Json::object();
  for (const Named& item : *list) {
    const auto key = std::find_if(std::begin(tool_keys), std::end(tool_keys), [&](const auto& k) { return k.first == item.name; });
    if (key == std::end(tool_keys) || row.contains(key->second)) return std::nullopt;
    row[key->second] = item.value;
  }
  return Json{{"offsets", {{number, row}}}};
}

/// Returns the table of the set-up that contains a work offset, and the name of the offset in that table. For example, "G54.1P2" becomes
/// "G54.1 P2". On a control with numbered work offsets, the name is the number.
std::pair<const char*, std::string> zero_name(std::string name, const ControlDef& def) {
  if (has(def, SetupNeeds::zeros)) {
    for (const WorkSystem& system : work_systems(def))
      if (system.name == name) name = std::to_string(system.row);
    return {"zeros", name};
  }
  if (is_whole(name)) return {"zeros", name};  // a control without numbered work offsets reports the name as an error later
  if (const std::size_t p = name.find('P'); p != std::string::npos && p > 0 && name[p - 1] != ' ') name.insert(p, 1, ' ');
  return {"work_offsets", name};
}

std::optional<Json> zero(const std::string& text, const ControlDef& def) {
  const auto [name, values] = cut(text, '=');
  const auto list = list_of(values);
  if (name.empty() || !list) return std::nullopt;
  Json axes = Json::object();
  for (const auto& [axis, value] : *list) {
    if (axes.contains(axis)) return std::nullopt;
    axes[axis] = value;
  }
  const auto [table, row] = zero_name(name, def);
  return Json{{table, {{row, axes}}}};
}

std::optional<Json> corrector(const std::string& text) {
  const auto [number, value] = cut(text, '=');
  const auto mm = number_of(value);
  if (!is_whole(number) || !mm) return std::nullopt;
  return Json{{"correctors", {{number, *mm}}}};
}

}  // namespace

tl::expected<std::vector<SetupSource>, std::string> setup_of_options(const Options& options, const ControlDef& def, Lang lang) {
  std::vector<SetupSource> sources;
  std::string wrong;
  const auto add = [&](const char* option, TextId<1> form_wanted, const std::string& text, const std::optional<Json>& json) {
    if (!json && wrong.empty()) wrong = translated_in(lang, form_wanted, text);
    if (json) sources.push_back({fmt::format("{} {}", option, text), json->dump()});
  };
  for (const std::string& text : options.tools) add("--tool", texts::job::tool_form_wanted, text, tool(text));
  for (const std::string& text : options.zeros) add("--zero", texts::job::zero_form_wanted, text, zero(text, def));
  for (const std::string& text : options.correctors) add("--corrector", texts::job::corrector_form_wanted, text, corrector(text));
  if (!wrong.empty()) return tl::unexpected(wrong);
  return sources;
}

}  // namespace kadr::cli
