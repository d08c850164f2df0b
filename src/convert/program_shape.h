#pragma once
// ProgramShape: where the loops and subprograms of a program are and who calls them, as far as its text shows it. A range to be written out
// grows along these: from a line to its loop, from a subprogram to its calls.

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/stop.h"
#include "config/control_def.h"
#include "convert/o_line_rewriter.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// The lines from `first` to `last`.
struct TextLines {
  std::uint32_t first = 0, last = 0;
  bool holds(std::uint32_t line) const { return first <= line && line <= last; }
  friend bool operator==(const TextLines&, const TextLines&) = default;
};

/// Tools, letters and speeds that a program names.
struct ProgramNames {
  std::set<std::uint32_t> tools;
  std::uint64_t letters = 0;  // of its words: bit (address - 'A')
  double most_speed = 0;      // S, rev/min
};

class ProgramShape {
 public:
  ProgramShape(std::shared_ptr<ByteSource> source, const ControlDef& def, const StopToken& stop = {});

  /// Returns the smallest loop that contains these lines and more; nullopt if there is none.
  std::optional<TextLines> loop_around(TextLines lines) const;
  /// Returns the subprogram that a line belongs to.
  std::optional<TextLines> subprogram_of(std::uint32_t line) const;
  /// Returns the lines that call this subprogram.
  std::vector<std::uint32_t> callers_of(TextLines subprogram) const;
  /// Returns the line of the block before the block of this line; 0: none.
  std::uint32_t block_before(std::uint32_t line) const;
  /// True if the line begins a subprogram or returns from it.
  bool is_edge(std::uint32_t line) const { return std::binary_search(edges_.begin(), edges_.end(), line); }
  /// Lines that rotate, mirror or scale what follows, or that end it.
  const std::vector<std::uint32_t>& transforms() const { return transforms_; }
  /// Ranges from a block with G41 or G42 to the block with G40.
  const std::vector<TextLines>& contours() const { return contours_; }
  /// Returns the lines that call other files.
  std::vector<std::uint32_t> calls_outside() const;
  /// Codes of exact stop, smoothing and the like that the program names, as indices in ControlDef::codes.
  const std::set<std::size_t>& path_modes() const { return path_modes_; }
  /// True if the program allows a tolerance at its corners: G64 P.
  bool rounds_corners() const { return rounds_corners_; }
  /// True if the program may contain arcs; false if all that it names moves along lines.
  bool has_arcs() const { return has_arcs_ || !contours_.empty() || !calls_outside().empty(); }
  /// Returns the jumps back, and the subprograms that are called with arguments.
  MacroShape macros() const;
  const ProgramNames& names() const { return names_of_words_; }
  /// Variables that the text names by number.
  const std::set<std::uint32_t>& variables() const { return variables_; }
  /// True if everything after that line is executed once: nothing leads back to it or to lines before it.
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

  std::vector<TextLines> blocks_;  // lines with blocks, consecutive ones joined
  std::vector<std::uint32_t> edges_, transforms_;
  std::vector<TextLines> loops_, contours_;
  std::map<std::uint32_t, TextLines> subprograms_;       // by label
  std::multimap<std::uint32_t, std::uint32_t> callers_;  // label → line
  std::set<std::uint32_t> variables_;
  std::set<std::size_t> path_modes_;
  bool rounds_corners_ = false;
  bool has_arcs_ = false;
  ProgramNames names_of_words_;
  std::map<std::uint32_t, std::uint32_t> numbers_;              // N → line; only in macro programs that are not too long
  std::vector<std::pair<std::uint32_t, std::uint32_t>> jumps_;  // line, N
  std::set<std::uint32_t> leaves_;
  std::set<std::uint32_t> macro_labels_;  // called by G65
  // while the text is read
  std::map<std::string, std::uint32_t> names_;                     // of subprograms → label
  std::vector<std::pair<std::uint32_t, std::string>> open_loops_;  // line, label of an O line
  std::uint32_t contour_ = 0;                                      // line where the contour begins
  std::uint32_t label_ = 0, labelled_ = 0, last_block_ = 0;
  bool has_jumps_ = false;  // the control has GOTO
  bool main_over_ = false, in_section_ = false;
  bool has_flow_ = false;        // something calls, repeats or jumps
  std::uint32_t last_turn_ = 0;  // the last line with more than motions and modes
  std::uint32_t lines_ = 0;
  std::uint64_t plain_letters_ = 0;  // of words that do not matter here
};

}  // namespace kadr
