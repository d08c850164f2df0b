#pragma once
// The O lines of the files of a run, found by one reading of each, and the labels that are in use (spec/linuxcnc 6). Labels are numbers
// here: each text is compared once.

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

/// Number of a label's text, in the order in which they were first met.
using Label = std::int32_t;
inline constexpr Label no_label = -1;

/// A number as a label is compared.
std::string label_of_number(double number);

/// One O line.
struct OLine {
  Position at, behind;     // the line; the next one
  Label label = no_label;  // none: `expression` says it when it is asked for
  std::string expression;  // of O[…], O#…
  OWord word = OWord::label;
  std::int32_t sub = -1;   // the line of the subprogram that it stands in, -1: none
  std::int32_t next = -1;  // the next line of the same label in the same subprogram, -1: none
  Label mark_of = -2;      // subprogram for which `mark` is the label's; -2: not looked for yet
  std::uint32_t mark = 0;
};

/// Those of one file.
struct OFile {
  std::vector<OLine> lines;
  std::unordered_map<std::uint64_t, std::int32_t> by_offset;
  bool all = true;      // false: it has more than are kept
  bool closed = false;  // a line of nothing but % ends it (2.1)
};

/// A label in use: what it stands for, and how far that is.
struct Mark {
  bool used = false;
  OWord word = OWord::label;
  Position at;  // its line
  std::uint16_t reader = 0;
  double left = 0;     // passes of a repetition that are to come
  bool taken = false;  // a branch of the `if` has been
};

/// A subprogram that has been passed or found: its line.
struct PassedSub {
  bool known = false;
  std::uint16_t reader = 0;
  Position at;
};

class FlowTable {
 public:
  static constexpr std::size_t most_lines = 200'000;  // of a file

  /// The O lines of the file being read; read when they are first asked for.
  OFile& of(BlockContext& m);
  OFile& of(BlockContext& m, std::uint16_t reader);

  // ---- labels
  Label label_of(std::string_view text);
  const std::string& text_of(Label label) const { return texts_[static_cast<std::size_t>(label)]; }

  /// The place for what a label stands for in a subprogram (no_label: the main program).
  std::uint32_t mark_of(Label sub, Label label);
  Mark& mark(std::uint32_t place) { return marks_[place]; }
  PassedSub& passed(Label label) { return passed_[static_cast<std::size_t>(label)]; }

  Label defining = no_label;  // label of the definition being passed over
  std::string refused;        // what is said at the line that has been jumped to
  std::vector<Label> calls;   // subprograms that are open
  std::vector<bool> by_m98;   // … and how each was called

  // Left over by `continue` of a do loop and `break` of a while loop: what ends next takes it for its own (a fault of LinuxCNC 2.9,
  // doing_continue and doing_break of the source).
  bool continue_left = false, break_left = false;
  bool told_again = false, told_early = false;  // … have been warned of

  // ---- what a snapshot holds: texts, for another control numbers its labels anew
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
  void remember(const Memory& memory);

 private:
  OFile read_o_lines(const ProgramFile& file);
  std::string text_or_none(Label label) const { return label == no_label ? std::string() : text_of(label); }
  Label label_or_none(const std::string& text) { return text.empty() ? no_label : label_of(text); }

  std::vector<std::unique_ptr<OFile>> files_;  // by reader
  std::vector<std::string> texts_;             // by label
  std::map<std::string, Label, std::less<>> labels_;
  std::vector<PassedSub> passed_;  // by label
  std::vector<Mark> marks_;
  std::map<std::pair<Label, Label>, std::uint32_t> places_;  // of marks: {subprogram, label}
};

}  // namespace kadr::linuxcnc
