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
  length,  // the length of a tool offset comes into force, by H or (2С42) by D
  radius,  // the radius of a tool offset comes into force
  // a work offset comes into force; the number is its row in the table, whose name work_systems() of config/setup/setup_names returns
  work_zero,
  corrector,  // a corrector (offset value) of an axis, or of a tool's radius, is used
  tool,       // a tool is called by T
  variable,   // variable #n is read before it is written; if the control has no vacant variables, this is recorded only after watch()
  // one of the parameters R0 … R9 is read before it is written; if the control has no vacant variables, this is recorded only after watch()
  parameter,
  skip_switch,    // the state of a block skip switch decides, at a block with the mark / or /n
  optional_stop,  // the state of the optional stop switch decides, at M1
  count
};

struct Use {
  UseKind kind = UseKind::count;
  std::uint32_t number = 0;
  Origin origin;           // location of the first use
  bool zero = false;       // the value in the set-up was 0 at the first use
  std::uint32_t tool = 0;  // number of the tool in the spindle at the first use
};

class ProgramUse {
 public:
  /// Records the first use of a number of this kind (of a tool, an offset, a variable …); later uses are ignored. A use by words of the
  /// set-up, which have no line, is not recorded.
  void note(UseKind kind, std::uint32_t number, const Origin& origin, bool zero = false);
  const std::vector<Use>& all() const { return all_; }
  /// Records which tool is in the spindle. If this function is never called, the tool of the last T counts as being in the spindle.
  void change_to(std::uint32_t tool) { in_spindle_ = tool; }

  /// Starts to record uses of variables and executed lines too. This recording takes time, so it is off otherwise.
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
