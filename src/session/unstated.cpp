// unstated: finds values that a program has used although the set-up does not state them. It is used by cli and view, and tested by
// tests/setup_command.py.

#include "session/unstated.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "texts/session.h"

namespace kadr {
namespace {

bool is_stated(const Use& use, const UsedKey& used, const std::set<std::string>& stated) {
  if (stated.contains(used.key)) return true;
  // on a lathe the key is a row of the table, which is stated if any of its values is
  const auto cell = stated.lower_bound(used.key + ".");
  if (cell != stated.end() && cell->starts_with(used.key + ".")) return true;
  if (use.kind == UseKind::length || use.kind == UseKind::radius) return stated.contains(used.key + "_wear");
  return use.kind == UseKind::corrector && stated.contains(fmt::format("offsets.{}.radius", use.number));
}

}  // namespace

std::optional<AlarmReport> unstated(const Control& control, const ControlDef& def, const Setup& setup,
                                    const std::set<std::string>& stated) {
  const std::vector<AlarmId>& disabled = setup.disabled;
  if (std::find(disabled.begin(), disabled.end(), AlarmId::not_stated) != disabled.end()) return std::nullopt;
  const auto counts = [](UseKind kind) {
    return kind == UseKind::length || kind == UseKind::radius || kind == UseKind::work_zero || kind == UseKind::corrector ||
           kind == UseKind::variable;
  };
  const Use* first = nullptr;
  std::string list;
  std::set<std::string> words;
  for (const Use& use : control.use().all()) {
    if (!counts(use.kind) || !use.zero) continue;
    const UsedKey used = used_key(use, def);
    if (is_stated(use, used, stated)) continue;
    if (first == nullptr) first = &use;
    // The same word is in the list already. On the 2С42, for example, the word D names both a length offset and a radius offset.
    if (!words.insert(used.word).second) continue;
    if (!list.empty()) list += ", ";
    if (use.kind == UseKind::variable) list += translated(texts::session::variable_vacant, used.word, use.origin.line);
    else list += fmt::format("{} ({})", used.word, use.origin.line);
  }
  if (first == nullptr) return std::nullopt;
  AlarmReport report;
  report.alarm = note(AlarmId::not_stated, {}, std::string_view(list));
  report.file = control.file_name(first->origin.file);
  report.origin = first->origin;
  report.own_text = list;
  auto lines = control.texts_of({first->origin.line}, first->origin.file);
  if (const auto line = lines.find(first->origin.line); line != lines.end()) {
    report.line_text = line->second;
    report.alarm.where = {0, static_cast<std::uint32_t>(report.line_text.size())};
  }
  return report;
}

}  // namespace kadr
