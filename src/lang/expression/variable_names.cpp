// Gives numbers to named variables. Used by expression_compiler, o_word_reader; control/linuxcnc.

#include "lang/expression/variable_names.h"

#include "base/ascii.h"

namespace kadr {

std::string VariableNames::plain(std::string_view written) {
  std::string name;
  for (const char c : written)
    if (c != ' ' && c != '\t') name += is_capital(c) ? static_cast<char>(c | 0x20) : c;
  return name;
}

std::optional<double> VariableNames::number_of(std::string_view written) {
  std::string name = plain(written);
  const std::lock_guard lock(mutex_);
  if (const auto found = numbers_.find(name); found != numbers_.end()) return found->second;
  if (names_.size() == most) return std::nullopt;
  const double number = first_named_variable + static_cast<double>(names_.size());
  names_.push_back(name);
  numbers_.emplace(std::move(name), number);
  return number;
}

std::string VariableNames::name_of(double number) const {
  const std::lock_guard lock(mutex_);
  const auto index = static_cast<std::size_t>(number - first_named_variable);
  return is_named(number) && index < names_.size() ? names_[index] : std::string();
}

}  // namespace kadr
