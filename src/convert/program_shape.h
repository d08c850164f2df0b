#pragma once
// ProgramShape: the loops and subprograms of a program and their callers, found from the text alone. If a range of lines must be expanded,
// the range grows along this structure: from a line to its loop, from a subprogram to its calls.

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/stop_token.h"
#include "config/control/control_def.h"
#include "convert/o_line_rewriter.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// A range of lines, from `first` to `last`, both included.
struct TextLines {
  std::uint32_t first = 0, last = 0;
  bool holds(std::uint32_t line) const { return first <= line && line <= last; }
  friend bool operator==(const TextLines&, const TextLines&) = default;
};

/// The tools, address letters and speeds that occur in a program.
struct ProgramNames {
  std::set<std::uint32_t> tools;
  std::uint64_t letters = 0;  // address letters of the program's words, one bit each: bit (address - 'A')
  double most_speed = 0;      // greatest S, rev/min
};

class ProgramShape {
 public:
  ProgramShape(std::shared_ptr<ByteSource> source, const ControlDef& def, const StopToken& stop = {});

  /// Returns the smallest loop that contains these lines and at least one more line; nullopt if there is no such loop.
  std::optional<TextLines> loop_around(TextLines lines) const;
  /// Returns the lines of the subprogram that contains this line; nullopt if no subprogram does.
  std::optional<TextLines> subprogram_of(std::uint32_t line) const;
  /// Returns the lines that call this subprogram.
  std::vector<std::uint32_t> callers_of(TextLines subprogram) const;
  /// Returns the line of the block that precedes the block in this line; 0 if there is no such block.
  std::uint32_t block_before(std::uint32_t line) const;
  /// True if the line begins a subprogram, or returns from a subprogram.
  bool is_edge(std::uint32_t line) const { return std::binary_search(edges_.begin(), edges_.end(), line); }
  /// Returns the lines that switch a rotation, mirroring or scaling of the coordinates on or off.
  const std::vector<std::uint32_t>& transforms() const { return transforms_; }
  /// Returns the contours: ranges from a block with G41 or G42 to the block with G40.
  const std::vector<TextLines>& contours() const { return contours_; }
  /// Returns the lines that call programs in other files.
  std::vector<std::uint32_t> calls_outside() const;
  /// Returns the codes of the program for exact stop, smoothing and the like, as indices in ControlDef::codes.
  const std::set<std::size_t>& path_modes() const { return path_modes_; }
  /// True if the program contains G64 P, which permits a path tolerance at corners.
  bool rounds_corners() const { return rounds_corners_; }
  /// True if the program may contain arcs; false if certainly all its motions are straight.
  bool has_arcs() const { return has_arcs_ || !contours_.empty() || !calls_outside().empty(); }
  /// Returns the backward jumps of a macro program, the jumps out of its loops, and its subprograms that are called with arguments.
  MacroShape macros() const;
  const ProgramNames& names() const { return names_of_words_; }
  /// Returns the numbers of the variables that occur in the text.
  const std::set<std::uint32_t>& variables() const { return variables_; }
  /// True if everything after this line is executed only once, because no later line leads back to this line or to a line before it.
  bool goes_straight_on_after(std::uint32_t line) const { return !has_flow_ && edges_.empty() && callers_.empty() && line >= last_turn_; }
  std::uint32_t lines() const { return lines_; }

 private:
  void note_block(std::uint32_t line);
  bool take_plain(const Block& block);
  void take(const Block& block, const ControlDef& def);
  void note_flow(Function function, std::uint32_t line);
  void take_section(const Block& block);
  void take_side(const CodeRow& row, std::uint32_t line);
  void take_o_line(const Block& block);
  void take_variables(std::string_view text);
  void take_number(const Block& block);
  void take_jump(const Block& block, const ControlDef& def);
  std::uint32_t last_return(TextLines lines) const;
  void close_subprogram();
  void take_calls(const Block& block, const ControlDef& def);

  std::vector<TextLines> blocks_;  // ranges of lines with blocks; adjacent ranges are joined
  std::vector<std::uint32_t> edges_, transforms_;
  std::vector<TextLines> loops_, contours_;
  std::map<std::uint32_t, TextLines> subprograms_;       // range of lines of each subprogram, by label
  std::multimap<std::uint32_t, std::uint32_t> callers_;  // label of a subprogram → line of a call
  std::set<std::uint32_t> variables_;
  std::set<std::size_t> path_modes_;
  bool rounds_corners_ = false;
  bool has_arcs_ = false;
  ProgramNames names_of_words_;
  std::map<std::uint32_t, std::uint32_t> numbers_;  // block number N → line of the block; only for macro programs of limited length
  std::vector<std::pair<std::uint32_t, std::uint32_t>> jumps_;  // line of a GOTO, and the block number N that it jumps to
  std::set<std::uint32_t> leaves_;
  std::set<std::uint32_t> macro_labels_;  // labels of subprograms called by G65
  // The members from here on are used only while the text is read.
  std::map<std::string, std::uint32_t> names_;                     // name of a subprogram → the label that it gets
  std::vector<std::pair<std::uint32_t, std::string>> open_loops_;  // line of an open loop, and the label of its O line
  std::uint32_t contour_ = 0;                                      // line where the open contour (G41, G42) begins
  std::uint32_t label_ = 0, labelled_ = 0, last_block_ = 0;
  bool has_jumps_ = false;  // the control has GOTO
  bool main_over_ = false, in_section_ = false;
  bool has_flow_ = false;        // the program contains calls, repetitions or jumps
  std::uint32_t last_turn_ = 0;  // the last line whose block contains a function other than motions and modes
  std::uint32_t lines_ = 0;
  std::uint64_t plain_letters_ = 0;  // letters (one bit each) of words that cannot belong to loops, subprograms or calls
};

}  // namespace kadr
