#pragma once
// The O lines (flow control and calls, such as `o10 call`) of the files of a run, and the labels in use (spec/linuxcnc 6). Each file is
// read once. Each label gets a number, so that later only numbers are compared, not texts.

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

/// The number of a label. Labels are numbered in the order in which they first occur.
using Label = std::int32_t;
inline constexpr Label no_label = -1;

/// Returns the label that a number means, as text. The number is, for example, the value of the expression in O[#1+1].
std::string label_of_number(double number);

/// One O line of a file.
struct OLine {
  Position at, position_after;  // position of the O line, and position of the line after the O line
  Label label = no_label;       // number of the label; no_label if `expression` gives the label
  std::string expression;       // text of the expression that gives the label: O[…] or O#…
  OWord word = OWord::label;
  std::int32_t sub = -1;   // index of the O line that starts the subprogram around this line; -1: the line is in the main program
  std::int32_t next = -1;  // index of the next O line with the same label in the same subprogram; -1: there is no such line
  // label of the subprogram that was being executed when `mark` was determined; -2: `mark` has not been determined yet
  Label mark_of = -2;
  std::uint32_t mark = 0;  // index, in the table of Marks, of the state of this line's label; valid only if `mark_of` is not -2
};

/// The O lines of one file.
struct OFile {
  std::vector<OLine> lines;
  std::unordered_map<std::uint64_t, std::int32_t> by_offset;
  bool all = true;      // false: the file has more than max_lines O lines, and the rest is missing here
  bool closed = false;  // the file ends before its last line, at a second line with only % (spec/linuxcnc 2.1)
};

/// The state of a label that is in use: the line where its loop or branch starts, and the progress of the loop or branch.
struct Mark {
  bool used = false;
  OWord word = OWord::label;
  Position at;  // position of the O line that starts the loop or branch
  std::uint16_t reader = 0;
  double left = 0;     // remaining passes of a repeat loop
  bool taken = false;  // one of the branches of the `if` has been executed, so no other branch is executed
};

/// The place in the files where a subprogram is defined. The place is known when the run has passed the definition, or when a call has
/// found it.
struct PassedSub {
  bool known = false;
  std::uint16_t reader = 0;
  Position at;
};

class FlowTable {
 public:
  static constexpr std::size_t max_lines = 200'000;  // greatest number of O lines that are stored for a file

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

  Label defining = no_label;  // label of the subprogram whose definition is being skipped; no_label: no definition is being skipped
  std::string refused;        // text of a fault that is reported at the line to which a call has jumped
  std::vector<Label> calls;   // labels of the open subprograms
  std::vector<bool> by_m98;   // for each open subprogram, outermost first: true if M98 has called it

  // `continue` in a do loop and `break` in a while loop set these flags, but the loop does not clear them. The next loop that ends acts as
  // if it had executed the statement itself. This is a fault of LinuxCNC 2.9 (doing_continue and doing_break of LinuxCNC's source).
  bool continue_left = false, break_left = false;
  bool warned_again = false, warned_early = false;  // the warning about continue_left or break_left has been reported

  // ---- the part of the table that a snapshot stores; labels are texts in it, because another run numbers labels differently
  struct Memory {
    std::map<std::pair<std::string, std::string>, Mark> marks;  // key: {subprogram, label}, as texts
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

  std::vector<std::unique_ptr<OFile>> files_;  // O lines of each file, by file number
  std::vector<std::string> texts_;             // by label
  std::map<std::string, Label, std::less<>> labels_;
  std::vector<PassedSub> passed_;  // places where subprograms are defined, by label of the subprogram
  std::vector<Mark> marks_;
  std::map<std::pair<Label, Label>, std::uint32_t> places_;  // key: {label of the subprogram, label}; value: index in marks_
};

}  // namespace kadr::linuxcnc
