// Keeps the words of lines that a loop executes again (word_lines.h). Used by control/sinumerik/blocks.

#include "control/sinumerik/word_lines.h"

#include <algorithm>
#include <utility>

#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {

std::uint64_t WordLines::key_of(const BlockContext& m) {
  constexpr unsigned bits_of_offset = 48;
  return std::uint64_t{m.program().reader()} << bits_of_offset | m.block->position.offset;
}

Block* WordLines::words_of(const BlockContext& m) {
  const auto found = lines_.find(key_of(m));
  if (found == lines_.end() || found->second == nullptr) return nullptr;
  Line& line = *found->second;
  for (const std::uint32_t name : line.names)
    if (calculation_.variable(name) != nullptr) return nullptr;
  for (const Computed& each : line.values) {
    Number value;
    if (!calculation_.value(each.value, value)) return nullptr;
    Word& w = line.words[each.word];
    if (w.address == 'F' && !(value.value > 0)) return nullptr;
    w.value = value.value;
  }
  std::copy(line.words.begin(), line.words.end(), line.block.words.begin());
  line.block.letters = line.letters;
  line.block.altered = false;
  line.block.text = m.block->text;
  own_.words.forms = line.forms;
  return &line.block;
}

bool WordLines::compile(const BlockContext& m, const NamedBlock& read, Line& line) {
  const std::uint64_t values =
      (m.letters.axes & ~own_.missing_axes) | letter_bit('I') | letter_bit('J') | letter_bit('K') | letter_bit('F');
  for (std::uint32_t i = 0; i < read.items.size(); ++i) {
    const NamedItem& item = read.items[i];
    if (item.kind != NamedItem::Kind::word || item.name.size() != 1 || item.extension >= 0 || !item.arguments.empty()) return false;
    const char letter = item.name[0];
    if (letter == 'G' && !item.has_equals && !is_own_code(item.number)) continue;
    if (letter < 'A' || letter > 'Z' || (values & letter_bit(letter)) == 0) return false;
    if (!item.has_equals) continue;
    const auto value = calculation_.compiled(read, item.value);
    if (!value) return false;
    line.values.push_back({i, *value});
    line.names.push_back(calculation_.slot_of(item.name));
  }
  return true;
}

void WordLines::keep(const BlockContext& m, const NamedBlock& read, const Block& made) {
  if (lines_.size() >= most_lines) return;
  const auto [found, added] = lines_.try_emplace(key_of(m));
  if (!added || made.word_count != read.items.size()) return;
  auto line = std::make_unique<Line>();
  if (!compile(m, read, *line)) return;
  line->block = made;
  line->block.altered = line->block.codes_vary = false;
  line->block.repeated = true;  // its plan is kept, too
  line->letters = made.letters;
  line->words.assign(made.words.begin(), made.words.begin() + made.word_count);
  line->forms = own_.words.forms;
  found->second = std::move(line);
}

}  // namespace kadr::sinumerik
