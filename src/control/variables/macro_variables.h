#pragma once
// MacroVariables: #1 … #33 of each call level, and #100 … #999 (spec/nct/23 23.1.3, 23.1.4). A variable is vacant until it is written.

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "control/state/journal.h"
#include "lang/expression/expression.h"

namespace kadr {

inline constexpr std::size_t max_locals = 33;
inline constexpr int first_common = 100, last_common = 999, first_permanent = 500;

using Locals = std::array<double, max_locals + 1>;  // values of the local variables #1 … #33, indexed by number; [0] is unused
Locals no_locals();

/// The common variables #100 … #999, by number.
struct Commons {
  std::array<double, last_common + 1> values;
  Commons() { values.fill(vacant); }
};

class MacroVariables {
 public:
  /// `shared`: the common variables of the machine. Its channels share the first `shared_100` variables from #100 on and the first
  /// `shared_500` from #500 on.
  MacroVariables(std::shared_ptr<Commons> shared, int shared_100, int shared_500);

  /// Reads #0, a local or a common variable into `value`. Returns false for any other variable number.
  bool known(double number, double& value) const {
    if (!(number >= 0 && number <= last_common)) return false;
    const int n = static_cast<int>(number);
    if (n >= first_common) {
      value = common(n);
      return true;
    }
    if (n > static_cast<int>(max_locals)) return false;
    value = n == 0 ? vacant : levels_.back()[static_cast<std::size_t>(n)];
    return true;
  }
  double common(int n) const { return *commons_[static_cast<std::size_t>(n - first_common)]; }
  void set_common(int n, double value) {
    *commons_[static_cast<std::size_t>(n - first_common)] = value;
    if (n >= first_permanent && !is_changed_[static_cast<std::size_t>(n - first_permanent)]) {
      is_changed_[static_cast<std::size_t>(n - first_permanent)] = true;
      changed_.push_back(static_cast<std::uint16_t>(n));
    }
  }
  /// Returns the value of a common variable above #999 (spec/fanuc 5.1: from #900000; spec/haas 2.4: from #10000).
  double further(std::uint32_t n) const {
    const auto found = further_.find(n);
    return found == further_.end() ? vacant : found->second;
  }
  void set_further(std::uint32_t n, double value) {
    further_[n] = value;
    further_changed_.insert(n);
  }
  /// Returns the numbers of the common variables above #999 that were written since the last call.
  std::set<std::uint32_t> take_changed_further() { return std::exchange(further_changed_, {}); }
  const std::map<std::uint32_t, double>& all_further() const { return further_; }

  /// Records the value of #n in the journal before a block writes the variable, so that an alarm can restore the value.
  void keep_common(Journal& journal, int n) { journal.keep(*commons_[static_cast<std::size_t>(n - first_common)]); }
  Locals& locals() { return levels_.back(); }
  const Locals& locals() const { return levels_.back(); }

  void open_level(const Locals& arguments) { levels_.push_back(arguments); }
  void close_level() {
    if (levels_.size() > 1) levels_.pop_back();
  }
  /// Called at the end of the program: deletes the local variables of all levels except the main program, and makes those of the main
  /// program vacant (23.1.3).
  void close_levels() { levels_.assign(1, no_locals()); }
  std::size_t depth() const { return levels_.size(); }
  const std::vector<Locals>& levels() const { return levels_; }

  /// The state in a snapshot, including the values of the shared common variables.
  struct Memory {
    std::vector<double> commons;  // values from #first_common on
    std::vector<Locals> levels;
    std::map<std::uint32_t, double> further;
  };
  Memory memory() const;
  void resume_from(const Memory& memory);

  /// Returns the numbers of common variables that survive power-off and were written since the last call.
  std::vector<std::uint16_t> take_changed();
  /// Makes the variables vacant that do not survive power-off: #100 … #499 and the local variables.
  void power_off();

 private:
  std::shared_ptr<Commons> shared_;
  std::unique_ptr<Commons> own_;
  std::array<double*, last_common - first_common + 1> commons_{};
  std::vector<Locals> levels_;
  std::map<std::uint32_t, double> further_;
  std::set<std::uint32_t> further_changed_;
  std::vector<std::uint16_t> changed_;
  std::array<bool, last_common - first_permanent + 1> is_changed_{};
};

}  // namespace kadr
