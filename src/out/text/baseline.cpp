// Baseline: reads a list of known findings. It is used by cli/check and tested by tests/run_check.py.

#include "out/text/baseline.h"

#include <nlohmann/json.hpp>

#include "config/json_text.h"
#include "texts/baseline.h"

namespace kadr {
namespace {

/// Returns the key of a finding. The key does not contain the sentence of the finding, since that sentence depends on the language and its
/// numbers change when other lines change.
std::string key_of(const std::string& file, std::string_view id, const std::string& line) {
  std::string key = file;
  for (const std::string_view part : {id, std::string_view(line)}) (key += '\n') += part;
  return key;
}

}  // namespace

tl::expected<Baseline, std::string> Baseline::read(std::string_view json) {
  const auto list = json_of(json);
  if (!list.is_array()) return tl::unexpected(translated(texts::baseline::not_a_list));
  Baseline baseline;
  for (const auto& entry : list) {
    const auto text = [&](const char* key) {
      const auto found = entry.is_object() ? entry.find(key) : entry.end();
      return entry.is_object() && found != entry.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    if (text("id").empty() || text("file").empty()) return tl::unexpected(translated(texts::baseline::incomplete_entry));
    ++baseline.known_[key_of(text("file"), text("id"), text("line_text"))];
  }
  return baseline;
}

bool Baseline::has(const Finding& finding) {
  const auto known = known_.find(key_of(finding.file, name_of(finding.id), finding.line_text));
  if (known == known_.end() || known->second == 0) return false;
  --known->second;
  ++found_;
  return true;
}

}  // namespace kadr
