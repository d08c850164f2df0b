// The O lines of the files of a run. For control/linuxcnc/flow.

#include "control/linuxcnc/flow_table.h"

#include <fmt/format.h>

#include "control/flow/program_file.h"
#include "control/interpreter.h"

namespace kadr::linuxcnc {

std::string label_of_number(double number) { return fmt::format("{:.0f}", number); }

/// The label of a block that is an O line, where its text says it; else "".
std::string written_label(const Block& block) {
  const Statement& s = block.statement;
  if (s.text.end > s.text.begin) return VariableNames::plain(block.text_of(s.text));
  const bool constant = s.value.end == s.value.begin + 1 && block.code[s.value.begin].op == Op::number;
  return constant ? label_of_number(block.code[s.value.begin].number) : std::string();
}

namespace {

/// The O lines of one file, and which of them belong together.
OFile read_o_lines(const ProgramFile& file) {
  OFile all;
  BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
  auto block = std::make_unique<Block>();
  std::int32_t sub = -1;
  std::map<std::pair<std::int32_t, std::string>, std::int32_t> last;
  for (;;) {
    const auto got = reader.next(*block);
    if (got && *got == BlockReader::Got::end) break;
    if (block->statement.kind != StatementKind::o_word) continue;
    if (all.lines.size() == FlowTable::most_lines) {
      all.all = false;
      break;
    }
    OLine row;
    row.at = block->position;
    row.behind = reader.position();
    row.word = block->statement.o_word;
    row.label = written_label(*block);
    if (row.label.empty()) row.expression = block->text_of(block->statement.label_where).substr(1);
    const auto index = static_cast<std::int32_t>(all.lines.size());
    if (row.word == OWord::sub && sub < 0) sub = index;
    row.sub = sub;
    if (!row.label.empty()) {
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

}  // namespace

const OFile& FlowTable::of(Interpreter& m) { return of(m, m.flow.reader()); }

const OFile& FlowTable::of(Interpreter& m, std::uint16_t reader) {
  const auto known = files.find(reader);
  if (known != files.end()) return known->second;
  return files.emplace(reader, read_o_lines(m.flow.file(reader))).first->second;
}

}  // namespace kadr::linuxcnc
