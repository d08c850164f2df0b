// What the program has used of a set-up and no set-up states. For the rest of cli.

#include "cli/unstated.h"

#include <fmt/core.h>

#include <algorithm>

namespace kadr::cli {
namespace {

std::string name_of_zero(std::uint32_t row, const ControlDef& def) {
  for (const WorkSystem& system : work_systems(def))
    if (system.row == row && system.works) return system.name;
  return std::to_string(row);
}

bool is_stated(const Use& use, const UsedKey& used, const std::set<std::string>& stated) {
  if (stated.contains(used.key)) return true;
  if (use.kind == UseKind::length || use.kind == UseKind::radius) return stated.contains(used.key + "_wear");
  return use.kind == UseKind::corrector && stated.contains(fmt::format("offsets.{}.radius", use.number));
}

}  // namespace

UsedKey used_key(const Use& use, const ControlDef& def) {
  const bool has_h = def.grammar.word('H').known && def.address('H').function != Function::repeat_word;
  switch (use.kind) {
    case UseKind::length: return {fmt::format("offsets.{}.length", use.number), fmt::format("{}{}", has_h ? 'H' : 'D', use.number)};
    case UseKind::radius: return {fmt::format("offsets.{}.radius", use.number), fmt::format("D{}", use.number)};
    case UseKind::work_zero: {
      const std::string name = name_of_zero(use.number, def);
      if (has(def, SetupNeeds::zeros)) return {fmt::format("zeros.{}", use.number), name};
      return {"work_offsets." + name, name};
    }
    case UseKind::corrector: return {fmt::format("correctors.{}", use.number), fmt::format("L{}", use.number)};
    case UseKind::tool: return {"", fmt::format("T{}", use.number)};
    case UseKind::variable: return {fmt::format("variables.#{}", use.number), fmt::format("#{}", use.number)};
    case UseKind::parameter: return {fmt::format("variables.R{}", use.number), fmt::format("R{}", use.number)};
    case UseKind::skip_switch: return {"skip", use.number == 1 ? "/" : fmt::format("/{}", use.number)};
    default: return {"optional_stop", "M1"};
  }
}

std::optional<AlarmReport> unstated(const Control& control, const Job& job) {
  const auto counts = [](UseKind kind) {
    return kind == UseKind::length || kind == UseKind::radius || kind == UseKind::work_zero || kind == UseKind::corrector;
  };
  const Use* first = nullptr;
  std::string list;
  std::set<std::string> told;
  for (const Use& use : control.use().all()) {
    if (!counts(use.kind) || !use.zero) continue;
    const UsedKey used = used_key(use, *job.def);
    if (is_stated(use, used, job.stated)) continue;
    if (first == nullptr) first = &use;
    if (!told.insert(used.word).second) continue;  // D of the 2С42: length and radius
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", used.word, use.origin.line);
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

}  // namespace kadr::cli
