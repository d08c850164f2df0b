// VariableNumbers: matches variables of two controls by their meaning. Used by convert/flow_rewriter; tested by tests/convert.

#include "convert/variable_numbers.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

namespace kadr {
namespace {

/// A variable, by the table row that contains it and the position of its number in this row.
struct VariablePlace {
  const VariableRow* row;
  std::uint32_t repeat, index;
};

/// The row for the last probed point of RS274/NGC. The control's file has no row for it, because its dialect supports it (spec/linuxcnc
/// 4.1).
const VariableRow& probe_row() {
  static const VariableRow row = [] {
    VariableRow made;
    made.kind = VariableKind::probe_point;
    made.ranges = {{5061, 9, 0, 1}};
    return made;
  }();
  return row;
}

std::vector<const VariableRow*> rows_of(const ControlDef& def) {
  std::vector<const VariableRow*> rows;
  for (const VariableRow& row : def.variables) rows.push_back(&row);
  if (def.has_parameter_file()) rows.push_back(&probe_row());
  return rows;
}

std::optional<VariablePlace> place_of(const ControlDef& def, std::uint32_t number) {
  for (const VariableRow* const row : rows_of(def))
    for (const VariableRange& range : row->ranges)
      for (std::uint32_t repeat = 0; repeat < range.repeat; ++repeat) {
        const std::uint32_t first = range.from + repeat * range.stride;
        if (number >= first && number - first < range.count && row->bit < 0) return VariablePlace{row, repeat, number - first};
      }
  return std::nullopt;
}

/// Returns one kind for kinds of variables that mean the same in both families of controls: the probed point in work coordinates, and the
/// work offsets.
VariableKind kind_of(VariableKind kind) {
  if (kind == VariableKind::probe_position) return VariableKind::probe_point;
  return kind == VariableKind::zero ? VariableKind::fixture : kind;
}

/// Returns the number of the variable among the variables of the same kind. One family of controls has all work offsets in one table row,
/// the other family has a row for each.
std::uint32_t place_in_kind(const VariablePlace& place) {
  constexpr std::uint32_t a_system = 1000;
  const bool row_each = place.row->kind == VariableKind::zero;
  const std::uint32_t nth =
      row_each ? static_cast<std::uint32_t>(place.row->arg > 0 ? place.row->arg - 1 : 0) + place.repeat : place.repeat;
  return nth * a_system + place.index;
}

/// True for the local and common variables of macros, which have no row in the control's table (nct 23, spec/fanuc 5).
bool is_plain(const ControlDef& def, std::uint32_t number) {
  constexpr std::uint32_t last_local = 33, first_common = 100, last_common = 999;
  return !def.grammar.has_vacant_variables() || (number >= 1 && number <= last_local) || (number >= first_common && number <= last_common);
}

bool is_written(const ControlDef& def, std::uint32_t number) {
  const auto place = place_of(def, number);
  return !place || place->row->write;
}

bool has_symbol(const ControlDef& def, std::string_view name) {
  const std::string_view symbol = name.substr(0, name.find('['));
  return std::any_of(def.grammar.symbols.begin(), def.grammar.symbols.end(), [&](const VariableName& one) { return one.text == symbol; });
}

}  // namespace

std::optional<std::string> VariableNumbers::given(const std::string& name) const {
  if (name.starts_with("#_")) return has_symbol(to_, std::string_view(name).substr(2)) ? std::optional(name) : std::nullopt;
  std::uint32_t number = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + std::min<std::size_t>(1, name.size()), end, number);
  // The text of a variable that is not a number is the name of a named parameter.
  if (!name.starts_with('#') || read.ec != std::errc() || read.ptr != end) return name;
  const auto there = of(number);
  return there && is_written(to_, *there) ? std::optional("#" + std::to_string(*there)) : std::nullopt;
}

std::optional<std::uint32_t> VariableNumbers::of(std::uint32_t number) const {
  if (const auto found = known_.find(number); found != known_.end()) return found->second;
  std::optional<std::uint32_t>& answer = known_[number];
  const auto here = place_of(from_, number), there = place_of(to_, number);
  const auto is_free = [](const std::optional<VariablePlace>& place) { return !place || place->row->kind == VariableKind::free; };
  if (is_free(here)) return answer = is_free(there) && (there || is_plain(to_, number)) ? std::optional(number) : std::nullopt;
  if (there && there->row->kind == here->row->kind && there->row->arg == here->row->arg && there->index == here->index)
    return answer = number;
  for (const VariableRow* const one : rows_of(to_)) {
    const VariableRow& row = *one;
    if (kind_of(row.kind) != kind_of(here->row->kind) || row.ranges.empty() || row.bit >= 0) continue;
    const VariableRange& range = row.ranges.front();
    for (std::uint32_t repeat = 0; repeat < range.repeat; ++repeat)
      if (const std::uint32_t wanted = place_in_kind(*here), first = place_in_kind({&row, repeat, 0});
          wanted >= first && wanted - first < range.count)
        return answer = range.from + repeat * range.stride + (wanted - first);
  }
  return answer;
}

}  // namespace kadr
