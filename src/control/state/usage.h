#pragma once
// What a program uses that a set-up states: offsets, work zeros, correctors, tools, variables, switches; and where first. The control
// tells it (Control::use()), for the note `not_stated` and for `kadr setup`.

#include <array>
#include <cstdint>
#include <vector>

#include "action/action.h"

namespace kadr {

class BlockContext;

enum class UseKind : std::uint8_t {
  length,         // an offset's length in force: H, or D of the 2С42
  radius,         // its radius
  work_zero,      // by the row of its table: work_systems() of config/setup_names tells the names
  corrector,      // of an axis, or of a tool's radius
  tool,           // T
  variable,       // #n read before anything was written to it; of a control without vacant variables only where it is watched
  parameter,      // R0 … R9, the same
  skip_switch,    // of /, /n
  optional_stop,  // M1
  count
};

struct Use {
  UseKind kind = UseKind::count;
  std::uint32_t number = 0;
  Origin origin;           // of the first time
  bool zero = false;       // what it names was 0 then
  std::uint32_t tool = 0;  // in the spindle then
};

class ProgramUse {
 public:
  /// Keeps the first use of each number. From a set-up's own words (no line) nothing is used.
  void note(UseKind kind, std::uint32_t number, const Origin& origin, bool zero = false);
  const std::vector<Use>& all() const { return all_; }
  /// A tool has come into the spindle; where none ever does, the last T counts.
  void change_to(std::uint32_t tool) { in_spindle_ = tool; }

  /// Variables and lines are looked at too; costs time.
  void watch() { watches_ = true; }
  bool watches() const { return watches_; }
  /// A line of the program itself has been carried out.
  void pass(const Origin& origin);
  bool passed(std::uint32_t line) const { return line < lines_.size() && lines_[line]; }

 private:
  std::vector<Use> all_;
  std::array<std::vector<bool>, static_cast<std::size_t>(UseKind::count)> seen_;
  std::vector<bool> lines_;
  std::uint32_t in_spindle_ = 0, called_ = 0;
  bool watches_ = false;
};

/// A code has put the work zero in force.
void note_work_zero(BlockContext& m, std::uint32_t row);
/// #number, R`index` is about to be read.
void note_read(BlockContext& m, double number);
void note_read_parameter(BlockContext& m, int index);

}  // namespace kadr
