#pragma once
// VariableNames: gives a number to each variable that a program names itself, such as `#<depth of cut>` (spec/linuxcnc 4.2). An expression
// then contains the number in place of the name.

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// The number of the first named variable. It is far above every number that a program can write.
inline constexpr double first_named_variable = 1e9;

/// The names of variables in all programs that one control reads. Names are never removed, so a number always means the same name. All
/// functions may be called from any thread.
class VariableNames {
 public:
  static constexpr std::size_t most = 1'000'000;  // greatest number of names; a name is at most as long as a line of the program

  /// Returns the form in which the control compares names: in small letters, without blanks.
  static std::string plain(std::string_view written);
  /// Returns the number of a name; `written` may have any letter case and any blanks. Returns nullopt if there are too many names.
  std::optional<double> number_of(std::string_view written);
  std::string name_of(double number) const;
  static bool is_named(double number) { return number >= first_named_variable; }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, double, std::less<>> numbers_;
  std::vector<std::string> names_;
};

}  // namespace kadr
