// Finds the G or M code with which a control commands a given function, e.g. rapid motion. This file is used by out/program/part_program
// and convert/block_maker.

#include "out/program/codes.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/tolerance.h"

namespace kadr {

std::string with_digits(const ControlDef& def, const CodeRow& row) {
  const std::size_t point = std::min(row.code.find('.'), row.code.size());
  const std::size_t least = def.grammar.word(row.letter).code_digits;
  std::string code = row.code;
  if (point - 1 < least) code.insert(1, least - (point - 1), '0');
  return code;
}

std::string machine_code_text(const ControlDef& def, std::uint32_t code) {
  return fmt::format("M{:0{}}", code, std::max<std::size_t>(def.grammar.word('M').code_digits, 1));
}

const CodeRow* row_that_does(const ControlDef& def, std::initializer_list<FunctionArg> functions) {
  for (const auto& [function, arg] : functions)
    for (const CodeRow& row : def.codes)
      if (row.function == function && (arg == any_argument || row.arg == arg) && row.works && row.cycle == 0) return &row;
  return nullptr;
}

std::optional<std::string> code_of(const ControlDef& def, std::initializer_list<FunctionArg> functions) {
  const CodeRow* const row = row_that_does(def, functions);
  return row == nullptr ? std::nullopt : std::optional(with_digits(def, *row));
}

std::optional<double> code_below(const std::map<std::int32_t, double>& codes, double limit) {
  std::optional<double> best;
  double most = 0;
  for (const auto& [code, value] : codes)
    if (value > most && value <= limit * (1 + tol::whole_number)) most = value, best = code;
  return best;
}

}  // namespace kadr
