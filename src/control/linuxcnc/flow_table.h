#pragma once
// The O lines (flow control and calls, such as `o10 call`) of the files of a run, and the labels in use (spec/linuxcnc 6). Each file is
// read once. Each text of a label gets a number, so that later only numbers are compared.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lang/block/block.h"
#include "lang/text/line_reader.h"

namespace kadr {
class BlockContext;
class ProgramFile;
}  // namespace kadr

namespace kadr::linuxcnc {

/// The number of a label. Labels are numbered in the order in which their texts first occur.
using Label = std::int32_t;
inline constexpr Label no_label = -1;

/// Returns the label text that a number means, such as the value of the expression in O[#1+1].
std::string label_of_number(double number);

/// An O line of a file.
struct OLine {
  Position at, behind;     // position of the O line; position of the line after it
  Label label = no_label;  // no_label if the label is computed from `expression`
  std::string expression;  // text of a computed label, O[…] or O#…
  OWord word = OWord::label;
  std::int32_t sub = -1;   // index of the O line that starts the enclosing subprogram; -1: none
  std::int32_t next = -1;  // index of the next O line with the same label in the same subprogram; -1: none
  Label mark_of = -2;      // label of the subprogram for which `mark` is valid; -2: `mark` is not determined yet
  std::uint32_t mark = 0;  // index of this line's Mark, valid if `mark_of` is determined
};

/// The O lines of one file.
struct OFile {
  std::vector<OLine> lines;
  std::unordered_map<std::uint64_t, std::int32_t> by_offset;
  bool all = true;      // false: the file has more O lines than max_lines
  bool closed = false;  // a second line with only % ends the file (2.1)
};

/// The state of a label that is in use: the line where its loop or branch starts, and how far the loop or branch has been executed.
struct Mark {
  bool used = false;
  OWord word = OWord::label;
  Position at;  // position of the O line that starts the loop or branch
  std::uint16_t reader = 0;
  double left = 0;     // remaining passes of a repeat loop
  bool taken = false;  // one of the branches of the `if` has been executed
};

/// Where a subprogram is defined. Known when the run has passed the definition or a call has found it.
struct PassedSub {
  bool known = false;
  std::uint16_t reader = 0;
  Position at;
};

class FlowTable {
 public:
  static constexpr std::size_t max_lines = 200'000;  // greatest number of O lines that are stored per file

  /// Returns the O lines of the file being read. The first call for a file reads the whole file.
  OFile& of(BlockContext& m);
  OFile& of(BlockContext& m, std::uint16_t reader);

  // ---- labels
  Label label_of(std::string_view text);
  const std::string& text_of(Label label) const { return texts_[static_cast<std::size_t>(label)]; }

  /// Returns the index of the Mark of a label in a subprogram. `sub`: label of the subprogram; no_label: the main program.
  std::uint32_t mark_of(Label sub, Label label);
  Mark& mark(std::uint32_t place) { return marks_[place]; }
  PassedSub& passed(Label label) { return passed_[static_cast<std::size_t>(label)]; }

  Label defining = no_label;  // label of the subprogram whose definition is being skipped; no_label: none
  std::string refused;        // text of a fault at the line to which a call has jumped; reported there
  std::vector<Label> calls;   // labels of the open subprograms
  std::vector<bool> by_m98;   // by open subprogram: M98 has called it

  // Set by `continue` in a do loop and `break` in a while loop, and not cleared by that loop: the next loop that ends acts as if it had
  // executed the statement itself. This is a fault of LinuxCNC 2.9 (doing_continue and doing_break of the source).
  bool continue_left = false, break_left = false;
  bool warned_again = false, warned_early = false;  // the warning about the flags above has been reported

  // ---- the part of a snapshot; it has the texts of labels, because another run numbers labels differently
  struct Memory {
    std::map<std::pair<std::string, std::string>, Mark> marks;  // {subprogram, label}
    std::map<std::string, PassedSub> passed;
    std::string defining;
    std::string refused;
    std::vector<std::string> calls;
    std::vector<bool> by_m98;
    bool continue_left = false, break_left = false;
  };
  Memory memory() const;
  void resume_from(const Memory& memory);

 private:
  OFile read_o_lines(const ProgramFile& file);
  std::string text_or_none(Label label) const { return label == no_label ? std::string() : text_of(label); }
  Label label_or_none(const std::string& text) { return text.empty() ? no_label : label_of(text); }

  std::vector<std::unique_ptr<OFile>> files_;  // by number of the file
  std::vector<std::string> texts_;             // by label
  std::map<std::string, Label, std::less<>> labels_;
  std::vector<PassedSub> passed_;  // by label of the subprogram
  std::vector<Mark> marks_;
  std::map<std::pair<Label, Label>, std::uint32_t> places_;  // {label of the subprogram, label} → index in marks_
};

}  // namespace kadr::linuxcnc
