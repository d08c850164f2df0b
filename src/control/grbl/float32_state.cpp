// Updates Grbl's 32-bit values after each block. The numbers are added in the order in which Grbl adds them (gcode.c, steps 19 and 20).
// Used by control/grbl/dialect.

#include "control/grbl/float32_state.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "control/block_context.h"
#include "control/grbl/block_check.h"
#include "lang/block/line_word_reader.h"

namespace kadr::grbl {
namespace {

constexpr std::size_t z_axis = 2;  // axis of the tool length

}  // namespace

void Float32Point::follow(const Axes& now) {
  for (std::size_t a = 0; a < axes; ++a)
    if (exact[a] != now[a]) take(a, now[a], static_cast<float>(now[a]));
}

void Float32Point::take(std::size_t axis, double now, float by_words) {
  exact[axis] = now;
  single[axis] = by_words;
}

/// Converts the text of a word, usually a letter and a number, to a 32-bit value. Blanks and comments inside the word are removed first.
float single_of(const Block& block, const Word& word) {
  const std::string_view text = block.text_of(word.where).substr(1);
  if (size_of_number(text) == text.size()) return float32_of_digits(text);
  std::vector<std::uint32_t> place;
  return float32_of_digits(filtered(text, place));
}

void Float32State::read_lines(std::size_t system) {
  for (std::size_t a = 0; a < axes; ++a)
    if (Unread& word = unread[a]; word.size != 0) {
      position.single[a] = target(a, float32_of_digits({word.text.data(), word.size}), system, true);
      word.size = 0;
    }
}

void Float32State::follow(const BlockContext& m, double tool_length) {
  read_lines(m.modal.work_zero);
  position.follow(m.position.machine);
  shift.follow(m.set_position);
  for (std::size_t i = 1; i < zeros.size(); ++i) zeros[i].follow(m.tables.zeros[i]);
  for (std::size_t i = 1; i < reference.size(); ++i) reference[i].follow(m.tables.reference[i]);
  if (exact_length == tool_length) return;
  exact_length = tool_length;
  length = static_cast<float>(tool_length);
}

float Float32State::target(std::size_t axis, float word, std::size_t system, bool absolute) const {
  if (!absolute) return word + position.single[axis];
  const float placed = word + (zeros[system].single[axis] + shift.single[axis]);
  return axis == z_axis ? placed + length : placed;
}

void Float32State::note(const BlockContext& m, const CheckedBlock& block, double tool_length) {
  constexpr float mm = static_cast<float>(mm_per_inch);
  const auto each_word = [&](auto use) {
    for (std::size_t a = 0; a < axes; ++a)
      if (const Word* const w = m.word(m.letters.axis_letter[a]); w != nullptr)
        use(a, block.inch ? single_of(*m.block, *w) * mm : single_of(*m.block, *w));
  };
  const std::size_t system = m.modal.work_zero;
  const auto tool = [this](std::size_t axis) { return axis == z_axis ? length : 0.0F; };
  if (block.axis_command == AxisCommand::length && tool_length != 0)
    each_word([&](std::size_t, float v) {
      length = v;
      exact_length = tool_length;
    });
  if (block.non_modal == 100) {
    const auto number = static_cast<std::size_t>(byte_of(m.value('P')));
    const std::size_t row = number == 0 ? system : number;
    const bool by_position = byte_of(m.value('L')) == 20;
    each_word([&](std::size_t a, float v) {
      const float zero = by_position ? position.single[a] - shift.single[a] - v : v;
      zeros[row].take(a, m.tables.zeros[row][a], by_position ? zero - tool(a) : zero);
    });
  } else if (block.non_modal == 920) {
    each_word(
        [&](std::size_t a, float v) { shift.take(a, m.set_position[a], position.single[a] - zeros[system].single[a] - v - tool(a)); });
  } else if (block.non_modal == 281 || block.non_modal == 301) {
    reference[block.non_modal == 281 ? 1 : 2] = position;
  } else if (block.non_modal == 280 || block.non_modal == 300) {
    const Float32Point& point = reference[block.non_modal == 280 ? 1 : 2];
    for (std::size_t a = 0; a < axes; ++a)
      if (!block.has_axis || m.has(m.letters.axis_letter[a])) position.take(a, m.position.machine[a], point.single[a]);
  }
  const bool probes = block.motion > 380 && block.motion < 390;
  if (block.moves && !probes)
    for (std::size_t a = 0; a < axes; ++a) position.take(a, m.position.machine[a], block.single_target[a]);
  follow(m, tool_length);
}

void Float32State::note_line(const BlockContext& m) {
  for (std::size_t a = 0; a < axes; ++a) {
    const Word* const w = m.word(m.letters.axis_letter[a]);
    if (w == nullptr) continue;
    const std::string_view text = m.block->text_of(w->where).substr(1);
    const bool waits = m.modal.absolute && text.size() <= unread[a].text.size() && text.find_first_of(" \t(") == std::string_view::npos;
    position.exact[a] = m.position.machine[a];
    unread[a].size = 0;
    if (waits) {
      std::copy(text.begin(), text.end(), unread[a].text.begin());
      unread[a].size = static_cast<std::uint8_t>(text.size());
    } else {
      position.single[a] = target(a, single_of(*m.block, *w), m.modal.work_zero, m.modal.absolute);
    }
  }
}

}  // namespace kadr::grbl
