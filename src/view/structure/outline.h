#pragma once
// The outline of a program: its programs, in each of them its tools, in these the cycles, labels and structure blocks. It is found in the
// text alone; nothing is executed. The page and editors show it (view/page, lsp/outline).
//
//   O1 (PLATE)            program O1
//   (FACE MILL)             tool T1 FACE MILL
//   T1 M6
//   G81 X5 Z-5 R2             cycle G81
//   X15
//   G80

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "view/structure/line_names.h"

namespace kadr {

enum class OutlineKind : std::uint8_t { program, subprogram, tool, cycle, label, section };

/// Returns the name of a program as people write it: O200, O<pocket>, PART.
std::string shown_name(const NamedPlace& place);

/// Returns the kind as messages name it: "program".
std::string_view name_of(OutlineKind kind);

struct OutlineEntry {
  OutlineKind kind = OutlineKind::program;
  std::string name;  // as people write it: "O200", "T1 FACE MILL", "CYCL DEF 200 DRILLING"; empty: the text has no program before it
  std::string key;   // of a tool or a cycle: without its comment, "T1"; of a label to which jumps may lead: in small letters
  std::size_t first = 0, last = 0;  // lines, counted from 0
  Span where;                       // bytes of the name in its line; {0, 0}: no name in the text
  std::vector<OutlineEntry> inside;
};

/// Makes the outline, line by line.
class Outliner {
 public:
  static constexpr std::size_t max_entries = 5000;

  explicit Outliner(const ControlDef& def) : def_(def) {}

  /// Takes the names of the line with this number, from 0; the lines come in their order.
  void take(std::size_t line, const std::vector<NamedPlace>& names);
  /// True when there are `max_entries`: what follows is left out.
  bool full() const { return count_ >= max_entries; }
  /// Returns the outline of a text with this number of lines. A label of a program with names is in it if a jump leads there.
  std::vector<OutlineEntry> finish(std::size_t lines);

 private:
  void begin_program(std::size_t line, const NamedPlace& place, const std::string& remark);
  void begin_heading(std::size_t line, const NamedPlace& place);
  void take_tool(std::size_t line, const std::vector<NamedPlace>& names);
  void begin_tool(std::size_t line, const std::string& remark);
  bool is_no_tool(const std::string& name) const;
  std::string tool_key() const;
  void take_cycle(std::size_t line, const NamedPlace& place);
  void add_leaf(OutlineEntry entry);
  OutlineEntry& program();
  std::vector<OutlineEntry>& leaves();
  void keep_called(std::vector<OutlineEntry>& entries) const;

  const ControlDef& def_;
  std::vector<OutlineEntry> programs_;
  std::size_t count_ = 0;
  NamedPlace heading_;            // the last comment alone in its line, or structure block
  std::size_t heading_line_ = 0;  // of `heading_`
  NamedPlace tool_;               // the last T word, which a change may put into the spindle
  bool by_change_ = false;        // an earlier line changes the tool by a code of its own, so that a T word alone only gets it ready
  std::string cycle_;             // the cycle in force; empty: none
  std::set<std::string> called_;  // labels to which a jump leads
};

/// Returns what the control's file says about the cycle of an entry; nullptr if it says nothing, or the name itself tells it.
const Text* meaning_of(const ControlDef& def, const OutlineEntry& entry);

}  // namespace kadr
