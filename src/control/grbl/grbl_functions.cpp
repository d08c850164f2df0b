// Executes G10, G28, G28.1, G43.1, G49, G53 of Grbl (spec/grbl 4.8, 4.13 to 4.15; execution steps of gcode.c).

#include <cmath>

#include "control/functions/functions.h"
#include "control/grbl/grbl.h"

namespace kadr {
namespace {

/// Returns the table row `row`, so that the caller can change it. The old values of the row are recorded first, so that an alarm can
/// restore them.
Axes& to_write(BlockContext& m, Axes& row) {
  m.journal.on_undo([&row, before = row] { row = before; });
  return row;
}

template <class Use>
void each_length(const BlockContext& m, Use use) {
  for (std::size_t a = 0; a < grbl::axes; ++a)
    if (const char letter = m.letters.axis_letter[a]; m.has(letter)) use(a, m.length_value(letter));
}

void take_length(Emitter& m, double length) {
  grbl::grbl_of(m).state.length = length;
  m.change_frames();
}

}  // namespace

namespace functions {

/// G53: the axis words of the block's G0 or G1 are machine coordinates. G53 without axis words has no effect.
Status machine_block(Emitter& m, const Call&) {
  m.block_machine_coordinates = true;
  return {};
}

/// G10 L2, L20: sets a work offset. The words of L2 give the offset in machine coordinates. L20 sets the offset so that the present
/// position has the coordinates of the words.
Status stored_offsets(Emitter& m, const Call&) {
  const auto number = static_cast<std::size_t>(grbl::byte_of(m.value('P')));
  Axes& zero = to_write(m, m.tables.zeros[number == 0 ? m.modal.work_zero : number]);
  const bool by_position = grbl::byte_of(m.value('L')) == 20;
  each_length(
      m, [&](std::size_t a, double v) { zero[a] = by_position ? m.position.machine[a] - m.set_position[a] - m.frames.length[a] - v : v; });
  m.change_frames();
  return {};
}

/// G28, G30 (arg 1, 2): moves the axes that have a word first to the point of the words, then to the stored position. Without axis words
/// all axes move directly to the stored position.
Status stored_move(Emitter& m, const Call& call) {
  const Axes stored = m.tables.reference[static_cast<std::size_t>(call.row->arg)];
  AxisMask named = 0;
  Axes through;
  KADR_TRY(m.target(through, named));
  if (named != 0) KADR_TRY(m.straight(MotionKind::rapid, through, named));
  else named = (AxisMask{1} << grbl::axes) - 1;
  return m.to_machine(MotionKind::rapid, stored, named, 0, call.row->arg == 2 ? EndReference::reference_2 : EndReference::reference_1);
}

/// G28.1, G30.1 (arg 1, 2): stores the present position.
Status stored_position(Emitter& m, const Call& call) {
  to_write(m, m.tables.reference[static_cast<std::size_t>(call.row->arg)]) = m.position.machine;
  return {};
}

/// G43.1: the word Z is the tool length.
Status length_by_word(Emitter& m, const Call&) {
  take_length(m, m.length_value('Z'));
  return {};
}

/// G49: the tool length is 0. Axis words in a block with G49 have no effect.
Status length_by_word_off(Emitter& m, const Call&) {
  take_length(m, 0);
  return {};
}

}  // namespace functions
}  // namespace kadr
