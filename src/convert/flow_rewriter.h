#pragma once
// FlowRewriter: rewrites the loops, conditions, subprograms and calls of RS274/NGC (O lines, spec/linuxcnc 6) as macro statements
// (spec/fanuc 5, nct 23), and named variables as numbered ones.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "convert/block_maker.h"
#include "convert/section_numbers.h"
#include "convert/variable_numbers.h"
#include "lang/block/block.h"

namespace kadr {

/// The argument letters of a macro call for #1, #2 …, in this order (spec/fanuc 9.3); '\0': the variable has no argument letter.
inline constexpr std::string_view argument_letters = std::string_view("ABCIJKDEF\0H\0M\0\0\0QRSTUVWXYZ", 26);

class FlowRewriter {
 public:
  ///   to  the target control; if the program has O lines, this control must have macros, or at least subprograms with labels
  FlowRewriter(const ControlDef& from, const ControlDef& to) : from_(from), to_(to), numbers_(from, to), sections_(to) {}

  /// Sets the variable numbers that the program itself uses, so that names get other numbers.
  void set_used(std::set<std::uint32_t> used) { used_ = std::move(used); }
  /// Rewrites an O line.
  ///   alarms  function_has_no_code
  Status write(const Block& block, BlockMaker& out);
  /// Rewrites an expression, an assignment or a word that contains an expression. System variables get the numbers of the target control.
  /// Names become numbers if the target control has no named variables.
  ///   alarms  function_has_no_code if no free number is left
  Result<std::string> expression(std::string_view text);
  /// begins_subprogram() returns true if the line begins a subprogram; ends_subprogram() returns true if the line ends a subprogram.
  static bool begins_subprogram(const Block& block);
  static bool ends_subprogram(const Block& block);

  /// True if the target control has its subprograms in a section before the main program.
  bool has_sections() const { return sections_.are_there(); }
  /// Begins the subprogram with this label. For a target control that has its subprograms in a section.
  ///   alarms  function_has_no_code if no free number is left
  Status begin_section(const std::string& label, BlockMaker& out);
  /// Rewrites a call such as M98 P2 L5 as the word L0205.
  ///   alarms  function_has_no_code if the block has other words
  Status call_in_section(const Block& block, BlockMaker& out);

 private:
  Status call_in_section(const std::string& label, std::uint32_t times, BlockMaker& out);
  struct Open {
    OWord word;
    int loop = 0;                // m of the loop's macro statement DOm
    std::uint32_t variable = 0;  // number of the variable that counts the repetitions
    // Block numbers N. next: of the next branch or repetition; over: of the block after the loop. 0: the number is not needed yet
    std::uint32_t next = 0, over = 0;
  };
  Status begin_loop(Open open, std::string_view condition, BlockMaker& out);
  Status branch(OWord word, std::string_view condition, BlockMaker& out);
  Status end_loop(std::string_view condition, BlockMaker& out);
  Status leave(bool goes_on, BlockMaker& out);
  Status call(std::string_view label, std::string_view arguments, BlockMaker& out);
  Status line(const std::string& text, BlockMaker& out) const;
  Status label_line(std::uint32_t label, BlockMaker& out) const;
  Result<std::string> not_that(std::string_view condition);
  std::uint32_t number_of(std::string_view label);
  Result<std::uint32_t> variable_of(std::string_view name);
  std::uint32_t free_variable(std::uint32_t from, std::uint32_t to, int step);

  const ControlDef& from_;
  const ControlDef& to_;
  const VariableNumbers numbers_;
  SectionNumbers sections_;
  std::vector<Open> open_;
  std::map<std::string, std::uint32_t> labels_;     // label of each named subprogram → the block number that is assigned to it
  std::map<std::string, std::uint32_t> variables_;  // scope and name of each named variable → the number that is assigned to it
  std::set<std::uint32_t> used_;
  std::string scope_;  // label of the subprogram that is being rewritten; the names of its local variables belong to this scope
  std::uint32_t next_label_ = 9000;
};

}  // namespace kadr
