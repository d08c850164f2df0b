// Builds the table of the O lines in the files of a run. Used by control/linuxcnc/o_line_flow.

#include "control/linuxcnc/flow_table.h"

#include <fmt/format.h>

#include "control/block_context.h"
#include "control/flow/program_file.h"

namespace kadr::linuxcnc {

std::string label_of_number(double number) { return fmt::format("{:.0f}", number); }

namespace {

/// Returns the label of an O line as written; an empty text if an expression gives the label.
std::string written_label(const Block& block) {
  const Statement& s = block.statement;
  if (s.text.end > s.text.begin) return VariableNames::plain(block.text_of(s.text));
  const bool constant = s.value.end == s.value.begin + 1 && block.code[s.value.begin].op == Op::number;
  return constant ? label_of_number(block.code[s.value.begin].number) : std::string();
}

}  // namespace

/// Reads the O lines of a file. Each O line is linked to the next O line with the same label in the same subprogram.
OFile FlowTable::read_o_lines(const ProgramFile& file) {
  OFile all;
  BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
  auto block = std::make_unique<Block>();
  std::int32_t sub = -1;
  std::map<std::pair<std::int32_t, Label>, std::int32_t> last;
  bool opened = false, began = false;
  for (;;) {
    const auto got = reader.next(*block);
    if (got && *got == BlockReader::Got::end) break;
    if (block->marker == Marker::program_start && block->word_count == 0) {
      if (opened) all.closed = true;
      if (opened) break;
      opened = !began;
    }
    began = began || !block->empty() || !block->comments.empty();
    if (block->statement.kind != StatementKind::o_word) continue;
    if (all.lines.size() == max_lines) {
      all.all = false;
      break;
    }
    OLine row;
    row.at = block->position;
    row.position_after = reader.position();
    row.word = block->statement.o_word;
    row.label = label_or_none(written_label(*block));
    if (row.label == no_label) {
      const auto written = block->text_of(block->statement.label_where);
      if (written.empty()) continue;  // the line is faulty: its label could not be read
      row.expression = written.substr(1);
    }
    const auto index = static_cast<std::int32_t>(all.lines.size());
    if (row.word == OWord::sub && sub < 0) sub = index;
    row.sub = sub;
    if (row.label != no_label) {
      const auto [place, is_new] = last.try_emplace({sub, row.label}, index);
      if (!is_new) all.lines[static_cast<std::size_t>(place->second)].next = index;
      place->second = index;
    }
    const bool ends = row.word == OWord::endsub && sub >= 0 && all.lines[static_cast<std::size_t>(sub)].label == row.label;
    all.by_offset.emplace(row.at.offset, index);
    all.lines.push_back(std::move(row));
    if (ends) sub = -1;
  }
  return all;
}

OFile& FlowTable::of(BlockContext& m) { return of(m, m.program().reader()); }

OFile& FlowTable::of(BlockContext& m, std::uint16_t reader) {
  if (files_.size() <= reader) files_.resize(reader + 1U);
  // The operator has entered a new line (MDI), so the table of the previous one is outdated.
  if (!files_[reader] || (m.program().in_entered() && reader == m.program().reader()))
    files_[reader] = std::make_unique<OFile>(read_o_lines(m.program().file(reader)));
  return *files_[reader];
}

Label FlowTable::label_of(std::string_view text) {
  if (const auto known = labels_.find(text); known != labels_.end()) return known->second;
  const auto label = static_cast<Label>(texts_.size());
  texts_.emplace_back(text);
  labels_.emplace(text, label);
  passed_.emplace_back();
  return label;
}

std::uint32_t FlowTable::mark_of(Label sub, Label label) {
  const auto [place, is_new] = places_.try_emplace({sub, label}, static_cast<std::uint32_t>(marks_.size()));
  if (is_new) marks_.emplace_back();
  return place->second;
}

FlowTable::Memory FlowTable::memory() const {
  Memory all;
  for (const auto& [of, place] : places_)
    if (marks_[place].used) all.marks.emplace(std::pair{text_or_none(of.first), text_of(of.second)}, marks_[place]);
  for (std::size_t i = 0; i < passed_.size(); ++i)
    if (passed_[i].known) all.passed.emplace(texts_[i], passed_[i]);
  all.defining = text_or_none(defining);
  all.refused = refused;
  for (const Label label : calls) all.calls.push_back(text_of(label));
  all.by_m98 = by_m98;
  all.continue_left = continue_left;
  all.break_left = break_left;
  return all;
}

void FlowTable::resume_from(const Memory& memory) {
  for (Mark& mark : marks_) mark = {};
  for (PassedSub& sub : passed_) sub = {};
  for (const auto& [of, kept] : memory.marks) mark(mark_of(label_or_none(of.first), label_of(of.second))) = kept;
  for (const auto& [text, sub] : memory.passed) passed(label_of(text)) = sub;
  defining = label_or_none(memory.defining);
  refused = memory.refused;
  calls.clear();
  for (const std::string& text : memory.calls) calls.push_back(label_of(text));
  by_m98 = memory.by_m98;
  continue_left = memory.continue_left;
  break_left = memory.break_left;
}

}  // namespace kadr::linuxcnc
