#pragma once
// Numbers of variables with names that the program makes up, `#<depth of cut>` (spec/linuxcnc 4.2): so that an expression holds a number.

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// The number of the first of them, far beyond any that a program can write.
inline constexpr double first_named_variable = 1e9;

/// Names of all programs that one control reads; they stay, so that a number means the same name for ever. Any thread may ask.
class VariableNames {
 public:
  static constexpr std::size_t most = 1'000'000;  // names; of as many characters as a line has

  /// As the control compares them: small letters, no blanks.
  static std::string plain(std::string_view written);
  /// Number of the name, `written` in any way; nothing: there are too many.
  std::optional<double> number_of(std::string_view written);
  std::string name_of(double number) const;
  static bool is_named(double number) { return number >= first_named_variable; }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, double, std::less<>> numbers_;
  std::vector<std::string> names_;
};

}  // namespace kadr
