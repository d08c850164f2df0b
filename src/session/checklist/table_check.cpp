// Compares the tool and offset tables with the program. This file is used by session/checklist and tested by tests/checklist.py.

#include "session/checklist/table_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "path/compensation/nose_tip.h"

namespace kadr {
namespace {

using Calls = std::map<std::uint32_t, Origin>;  // tool number → location of the first call of the tool

Calls calls_of(const ProgramUse& use) {
  Calls calls;
  for (const Use& one : use.all())
    if (one.kind == UseKind::tool && one.number != 0) calls.try_emplace(one.number, one.origin);
  return calls;
}

const Origin& first_of(const Calls& calls) {
  return std::min_element(calls.begin(), calls.end(), [](const auto& a, const auto& b) { return a.second.number < b.second.number; })
      ->second;
}

/// Formats a list of numbers, of which at most four are shown: "T7, T9, T12, T14 +3".
std::string list_of(const std::vector<std::uint32_t>& numbers, const char* letter) {
  constexpr std::size_t most = 4;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, numbers.size()); ++i) list += fmt::format("{}{}{}", i == 0 ? "" : ", ", letter, numbers[i]);
  return numbers.size() > most ? fmt::format("{} +{}", list, numbers.size() - most) : list;
}

/// True if the table belongs to this program only. A table with more unused rows than used rows describes a tool magazine or a whole
/// workshop.
bool is_of_program(std::size_t used, std::size_t unused) { return unused > 0 && unused <= used; }

void judge_missing(const ToolTable& table, const Calls& calls, Advices& to) {
  const auto is_there = [&](const Calls::value_type& call) { return table.tools.find(call.first) != nullptr; };
  const auto there = static_cast<std::size_t>(std::count_if(calls.begin(), calls.end(), is_there));
  // a common table that contains fewer than half of the called tools belongs to other programs, so it is not compared
  if (table.kind == ToolTable::Kind::common && 2 * there < calls.size()) return;
  for (const auto& call : calls)
    if (!is_there(call)) to.add(AlarmId::tool_not_in_table, call.second, 'T', double(call.first), std::string_view(table.file));
}

/// True if the program contains the number `n`. On controls with two numbers in one word, T0405 names tool 4 or tool 5.
bool names(const std::set<std::uint32_t>& numbers, std::uint32_t n) {
  constexpr std::uint32_t two_digits = 100;
  return std::any_of(numbers.begin(), numbers.end(),
                     [n](std::uint32_t m) { return m == n || (m >= two_digits && (m / two_digits == n || m % two_digits == n)); });
}

void judge_unused(const ToolTable& table, const Calls& calls, const NamedInText& named, const Setup& setup, Advices& to) {
  if (table.kind == ToolTable::Kind::common || named.tools_by_value) return;
  std::vector<std::uint32_t> unused;
  std::size_t used = 0;
  for (const ToolGeometry& tool : table.tools.tools) {
    const bool is_used =
        calls.contains(tool.number) || names(named.tools, tool.number) || tool.number == 0 || int(tool.number) == setup.tool;
    if (is_used) ++used;
    else unused.push_back(tool.number);
  }
  if (!is_of_program(used, unused.size())) return;
  std::sort(unused.begin(), unused.end());
  to.add(AlarmId::table_tools_unused, first_of(calls), 0, std::string_view(list_of(unused, "T")), std::string_view(table.file));
}

/// Reports a row without values that the program uses, if another row has values but is not used. Then the row numbers are probably
/// mistaken. Unused rows alone are not reported.
void judge_rows(const Calls& tools, const NamedInText& named, const Setup& setup, const ProgramUse& use, Advices& to) {
  const Use* empty = nullptr;
  std::set<std::uint32_t> used;
  for (const Use& one : use.all()) {
    if ((one.kind != UseKind::length && one.kind != UseKind::radius) || one.number == 0) continue;
    used.insert(one.number);
    if (empty == nullptr && one.zero && !setup.offsets.contains(int(one.number))) empty = &one;
  }
  if (empty == nullptr || named.rows_by_value) return;
  std::vector<std::uint32_t> unused;
  for (const auto& [number, values] : setup.offsets) {
    const auto n = static_cast<std::uint32_t>(number);
    const bool is_called = used.contains(n) || tools.contains(n) || names(named.rows, n) || names(named.tools, n) || number == setup.tool;
    if (values != ToolOffset{} && !is_called) unused.push_back(n);
  }
  if (!is_of_program(used.size(), unused.size())) return;
  to.add(AlarmId::offset_row_unused, empty->origin, 0, double(empty->number), std::string_view(list_of(unused, "")));
}

/// Reports a wear that moves the tip of a turning tool away from the material. An insert that wears recedes, so its wear moves the tip in
/// the direction in which the tip points (spec/fanuc-t 4, 7.1). A wear up to `least` adjusts a size. Each row is reported once, at its
/// first use.
void judge_wear(const Setup& setup, const ProgramUse& use, Advices& to) {
  constexpr double least = 0.05;  // mm
  for (const Use& one : use.all()) {
    const auto row = setup.offsets.find(int(one.number));
    if (one.kind != UseKind::length || row == setup.offsets.end()) continue;
    const ToolOffset& values = row->second;
    const Vec2 direction = nose_vector(static_cast<std::uint8_t>(values.tip_position), 1);
    const auto judge = [&](char axis, double wear, double points) {
      if (std::fabs(wear) > least && wear * points < 0) to.add(AlarmId::wear_sign, one.origin, 0, double(one.number), axis, wear);
    };
    judge('X', values.length_x_wear, direction.y);
    judge('Z', values.length_wear, direction.x);
  }
}

}  // namespace

void check_tables(const ChecklistBasis& basis, const NamedInText& named, const Setup& setup, const ProgramUse& use, Advices& to) {
  const Calls tools = calls_of(use);
  if (basis.tools && !tools.empty()) {
    judge_missing(*basis.tools, tools, to);
    if (basis.own_tools) judge_unused(*basis.tools, tools, named, setup, to);
  }
  if (basis.own_setup) {
    judge_rows(tools, named, setup, use, to);
    judge_wear(setup, use, to);
  }
}

}  // namespace kadr
