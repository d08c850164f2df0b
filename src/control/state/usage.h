#pragma once
// ProgramUse: which data of a set-up a program uses (offsets, work offsets, correctors, tools, variables, switches), and the first use of
// each. The control provides it (Control::use()), for the note `not_stated` and for `kadr setup`.

#include <array>
#include <cstdint>
#include <vector>

#include "action/action.h"

namespace kadr {

class BlockContext;

enum class UseKind : std::uint8_t {
  length,     // the length of an offset comes into force, by H or (2С42) by D
  radius,     // the radius of an offset comes into force
  work_zero,  // a work offset, by its row in the table; work_systems() of config/setup/setup_names returns the names
  corrector,  // corrector (offset value) of an axis, or of a tool's radius
  tool,       // a tool, by T
  variable,   // #n is read before it is written; if the control has no vacant variables, this is recorded only after watch()
  parameter,  // one of R0 … R9 is read before it is written; if the control has no vacant variables, this is recorded only after watch()
  skip_switch,    // the switch of a skip mark /, /n
  optional_stop,  // the switch of M1
  count
};

struct Use {
  UseKind kind = UseKind::count;
  std::uint32_t number = 0;
  Origin origin;           // location of the first use
  bool zero = false;       // the value was 0 at that time
  std::uint32_t tool = 0;  // number of the tool in the spindle at that time
};

class ProgramUse {
 public:
  /// Records the first use of each number. A use by words of the set-up, which have no line, is not recorded.
  void note(UseKind kind, std::uint32_t number, const Origin& origin, bool zero = false);
  const std::vector<Use>& all() const { return all_; }
  /// Records that a tool is in the spindle. If this function is never called, the tool of the last T counts.
  void change_to(std::uint32_t tool) { in_spindle_ = tool; }

  /// Starts to record variables and lines too. This recording takes time, so it is off otherwise.
  void watch() { watches_ = true; }
  bool watches() const { return watches_; }
  /// Records that a line of the program itself has been executed.
  void pass(const Origin& origin);
  bool passed(std::uint32_t line) const { return line < lines_.size() && lines_[line]; }

 private:
  std::vector<Use> all_;
  std::array<std::vector<bool>, static_cast<std::size_t>(UseKind::count)> seen_;
  std::vector<bool> lines_;
  std::uint32_t in_spindle_ = 0, called_ = 0;
  bool watches_ = false;
};

/// Records that a code has put a work offset in force.
void note_work_offset(BlockContext& m, std::uint32_t row);
/// Records that variable #`number`, or parameter R`index`, is about to be read.
void note_read(BlockContext& m, double number);
void note_read_parameter(BlockContext& m, int index);

}  // namespace kadr
