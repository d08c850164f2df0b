// The outline of a program. Used by view/page and lsp/outline; tested by tests/view/outline_test.cpp.

#include "view/structure/outline.h"

#include <algorithm>

#include "base/ascii.h"
#include "config/control/control_names.h"

namespace kadr {
namespace {

constexpr std::size_t heading_distance = 2;  // lines between a comment and the tool that it names

bool is_readable(const std::string& heading) {
  return std::any_of(heading.begin(), heading.end(), [](char c) { return is_capital(to_upper(c)) || static_cast<unsigned char>(c) > 127; });
}

std::string in_capitals(std::string name) {
  for (char& c : name) c = to_upper(c);
  return name;
}

/// Returns the comment after the words of a line; empty if there is none with letters.
std::string remark_in(const std::vector<NamedPlace>& names) {
  const auto found = std::find_if(names.begin(), names.end(), [](const NamedPlace& one) { return one.kind == NameKind::remark; });
  return found == names.end() || !is_readable(found->name) ? std::string() : found->name;
}

std::string with_remark(const std::string& name, const std::string& remark) { return remark.empty() ? name : name + ' ' + remark; }

/// True if the last two digits of a T word are those of the offset.
bool has_offset_in_tool(const ControlDef& def) { return def.behaviour.lathe != Lathe::none || def.behaviour.tool_and_corrector; }

/// Returns the name under which the control's file explains a cycle: "CYCL200" for CYCL DEF 200 DRILLING, else the code itself.
std::string cycle_key(const std::string& name) {
  const std::size_t number = name.find("DEF ");
  if (number == std::string::npos) return name;
  const std::size_t begin = std::min(name.find_first_not_of(' ', number + 4), name.size());
  return "CYCL" + name.substr(begin, name.find_first_not_of("0123456789", begin) - begin);
}

/// Ends the last entry, and all that are last in it, before the line.
void end_before(std::vector<OutlineEntry>& entries, std::size_t line) {
  if (entries.empty()) return;
  OutlineEntry& last = entries.back();
  last.last = std::max(last.first, line == 0 ? 0 : line - 1);
  end_before(last.inside, line);
}

}  // namespace

std::string_view name_of(OutlineKind kind) {
  switch (kind) {
    case OutlineKind::program: return "program";
    case OutlineKind::subprogram: return "subprogram";
    case OutlineKind::tool: return "tool";
    case OutlineKind::cycle: return "cycle";
    case OutlineKind::label: return "label";
    case OutlineKind::section: break;
  }
  return "section";
}

std::string shown_name(const NamedPlace& place) {
  if (place.name.empty() || is_digit(place.name.front()) || place.kind == NameKind::label) return "O" + place.name;
  return in_capitals(place.name);
}

OutlineEntry& Outliner::program() {
  if (programs_.empty()) programs_.push_back({}), ++count_;
  return programs_.back();
}

/// Returns the list to which cycles, labels and structure blocks are added: that of the tool, or of the program before its first tool.
std::vector<OutlineEntry>& Outliner::leaves() {
  OutlineEntry& of = program();
  return !of.inside.empty() && of.inside.back().kind == OutlineKind::tool ? of.inside.back().inside : of.inside;
}

void Outliner::add_leaf(OutlineEntry entry) {
  std::vector<OutlineEntry>& to = leaves();
  end_before(to, entry.first);
  to.push_back(std::move(entry));
  ++count_;
}

void Outliner::take(std::size_t line, const std::vector<NamedPlace>& names) {
  if (full()) return;
  take_tool(line, names);
  for (const NamedPlace& place : names) switch (place.kind) {
      case NameKind::program:
        if (place.defines) begin_program(line, place, remark_in(names));
        break;
      case NameKind::label:
        if (place.defines && def_.grammar.klartext_blocks)
          add_leaf({OutlineKind::label, "LBL " + place.name, {}, line, line, place.where, {}});
        else if (place.defines) begin_program(line, place, remark_in(names));
        break;
      case NameKind::mark:
        if (place.defines) add_leaf({OutlineKind::label, in_capitals(place.name), place.name, line, line, place.where, {}});
        else called_.insert(place.name);
        break;
      case NameKind::heading:
      case NameKind::section:
        if (is_readable(place.name)) begin_heading(line, place);
        break;
      case NameKind::cycle: take_cycle(line, place); break;
      case NameKind::no_cycle: cycle_.clear(); break;
      default: break;
    }
}

void Outliner::begin_program(std::size_t line, const NamedPlace& place, const std::string& remark) {
  end_before(programs_, line);
  const OutlineKind kind = place.kind == NameKind::label ? OutlineKind::subprogram : OutlineKind::program;
  programs_.push_back({kind, with_remark(shown_name(place), remark), {}, line, line, place.where, {}});
  heading_.name.clear();
  cycle_.clear();
  ++count_;
}

/// Keeps a comment for the tool that may follow. A structure block is an entry of its own until a tool takes its name.
void Outliner::begin_heading(std::size_t line, const NamedPlace& place) {
  heading_ = place, heading_line_ = line;
  if (place.kind == NameKind::section) add_leaf({OutlineKind::section, place.name, {}, line, line, place.where, {}});
}

/// Begins a tool where the control changes it: at the code that changes tools, or at the T word of a control, or of a program, without such
/// a code. A T word alone in a program with such codes only gets the tool ready.
void Outliner::take_tool(std::size_t line, const std::vector<NamedPlace>& names) {
  bool changes = false, stated = false;
  for (const NamedPlace& place : names) {
    changes = changes || place.kind == NameKind::change;
    if (place.kind != NameKind::tool || place.defines || is_no_tool(place.name)) continue;  // TOOL DEF 5 is no change
    stated = true;
    tool_ = place;
  }
  if (changes ? !tool_.name.empty() : stated && !by_change_) begin_tool(line, remark_in(names));
  by_change_ = by_change_ || changes;
}

/// True for T0, and for a T word that cancels the offset of a tool: T0100.
bool Outliner::is_no_tool(const std::string& name) const {
  return name == "0" || (has_offset_in_tool(def_) && name.size() > 2 && name.ends_with("00"));
}

/// Returns the tool as it is written: T5; with its offset T0101; by its name DRILL_8.
std::string Outliner::tool_key() const {
  const std::string& name = tool_.name;
  if (name.find_first_not_of("0123456789") != std::string::npos) return name;
  return (has_offset_in_tool(def_) && name.size() == 3 ? "T0" : "T") + name;
}

void Outliner::begin_tool(std::size_t line, const std::string& remark) {
  OutlineEntry& of = program();
  const std::string key = tool_key();
  std::vector<OutlineEntry>& tools = of.inside;
  if (!tools.empty() && tools.back().kind == OutlineKind::tool && tools.back().key == key) return;
  const bool named = !heading_.name.empty() && line - heading_line_ <= heading_distance;
  const std::size_t first = named ? heading_line_ : line;
  if (named && heading_.kind == NameKind::section) {  // the tool takes its place
    std::vector<OutlineEntry>& before = leaves();
    if (!before.empty() && before.back().kind == OutlineKind::section && before.back().first == first) before.pop_back(), --count_;
  }
  end_before(tools, first);
  std::string name = with_remark(key, named ? heading_.name : remark);
  tools.push_back({OutlineKind::tool, std::move(name), key, first, line, tool_.where, {}});
  heading_.name.clear();
  cycle_.clear();
  ++count_;
}

/// Adds a cycle; of a mode, which is in force until it is cancelled, only the first block.
void Outliner::take_cycle(std::size_t line, const NamedPlace& place) {
  if (!place.defines && place.name == cycle_) return;
  if (!place.defines) cycle_ = place.name;
  add_leaf({OutlineKind::cycle, place.name, cycle_key(place.name), line, line, place.where, {}});
}

std::vector<OutlineEntry> Outliner::finish(std::size_t lines) {
  end_before(programs_, lines);
  for (OutlineEntry& program : programs_) {
    keep_called(program.inside);
    for (OutlineEntry& tool : program.inside) keep_called(tool.inside);
  }
  return std::move(programs_);
}

/// Removes the labels to which no jump leads; the lines of such a label belong to the entry before it.
void Outliner::keep_called(std::vector<OutlineEntry>& entries) const {
  std::vector<OutlineEntry> kept;
  for (OutlineEntry& one : entries) {
    const bool is_called = one.kind != OutlineKind::label || one.key.empty() || called_.contains(one.key);
    if (is_called) kept.push_back(std::move(one));
    else if (!kept.empty()) kept.back().last = one.last;
  }
  entries = std::move(kept);
}

const Text* meaning_of(const ControlDef& def, const OutlineEntry& entry) {
  if (entry.kind != OutlineKind::cycle) return nullptr;
  if (const NameRow* const row = named_row(def, entry.key)) return &row->text;
  const auto found = std::find_if(def.codes.begin(), def.codes.end(), [&](const CodeRow& row) { return row.code == entry.key; });
  return found == def.codes.end() ? nullptr : &found->text;
}

}  // namespace kadr
