// Datum shift, mirror image, rotation, scale: cycles 7, 8, 10, 11, 26, 247, TRANS DATUM (spec/heidenhain 11). Used by control/heidenhain.

#include <cmath>

#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {
namespace {

constexpr std::string_view axis_words[] = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};

}  // namespace

/// Puts shift, mirror image, rotation and scale in force: x = shift + mirror · rotation · scale · w. The tool does not move.
///   alarms  scale_zero
Status Heidenhain::set_frame(Emitter& m) {
  Transform made;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    if (memory.scale[a] == 0) return fail(alarm(AlarmId::scale_zero, m.block->where, std::string_view(m.axis_names[a])));
    made.scale[a] = memory.scale[a];
    made.scale_shift[a] = memory.scale_centre[a] * (1 - memory.scale[a]);
    made.mirror[a] = (memory.mirrored >> a & 1U) != 0 ? std::int8_t{-1} : std::int8_t{1};
    made.added[a] = memory.shift[a];
  }
  made.rotation = memory.rotation;
  made.first = static_cast<std::uint8_t>(m.modal.axes.first);
  made.second = static_cast<std::uint8_t>(m.modal.axes.second);
  made.refresh();
  m.transform = made;
  m.position.programmed = m.transform.to_programmed(m.position.work);
  memory.has_direction = false;
  return {};
}

void Heidenhain::reset_frames() {
  memory.shift = memory.scale_centre = {};
  memory.mirrored = 0;
  memory.rotation = 0;
  for (double& each : memory.scale) each = 1;
}

/// Cycle 7.n, TRANS DATUM AXIS: each named axis gets its shift, or adds to it.
Status Heidenhain::shift_datum(Emitter& m, const KlartextBlock& block) {
  for (const KlartextWord& word : block.words) {
    if (word.name == word_name("#")) {
      const auto row = value(m, block, word);
      if (!row) return fail(row.error());
      return take_datum_row(m, *row, word.where);
    }
    for (std::size_t a = 0; a < m.axis_count; ++a) {
      if (word.name != word_name(m.axis_names[a])) continue;
      const auto read = value(m, block, word);
      if (!read) return fail(read.error());
      const double by = *read * ((m.def.rotary >> a & 1U) != 0 ? 1 : m.unit_scale());
      memory.shift[a] = word.incremental ? memory.shift[a] + by : by;
      if (!(std::fabs(memory.shift[a]) <= farthest))
        return fail(alarm(AlarmId::position_out_of_range, word.where, std::string_view(m.axis_names[a]), memory.shift[a]));
    }
  }
  return set_frame(m);
}

Status Heidenhain::frame_cycle(Interpreter& m, const KlartextBlock& block) {
  const auto number_of = [&](const KlartextWord& word) { return value(m, block, word); };
  switch (block.number) {
    case 7: return block.part == 0 ? Status() : shift_datum(m, block);
    case 8:
      if (block.part == 0) return {};
      memory.mirrored = 0;
      for (const KlartextWord& word : block.words)
        for (std::size_t a = 0; a < m.axis_count; ++a)
          if (word.name == word_name(m.axis_names[a])) memory.mirrored |= AxisMask{1} << a;
      return set_frame(m);
    case 10:
      if (const KlartextWord* const word = block.find("ROT")) {
        const auto read = number_of(*word);
        if (!read) return fail(read.error());
        memory.rotation = word->incremental ? memory.rotation + *read : *read;
        if (m.modal.radius_side != 0) m.run_modes({Function::radius_comp_off});
      }
      return set_frame(m);
    case 11:
      if (const KlartextWord* const word = block.find("SCL")) {
        const auto read = number_of(*word);
        if (!read) return fail(read.error());
        for (std::size_t a = 0; a < 3; ++a) memory.scale[a] = *read;
        memory.scale_centre = {};
      }
      return set_frame(m);
    case 26:
      for (std::size_t a = 0; a < 3 && block.part != 0; ++a) {
        memory.scale[a] = 1;
        memory.scale_centre[a] = 0;
        if (const KlartextWord* const word = block.find(axis_words[a])) {
          const auto read = number_of(*word);
          if (!read) return fail(read.error());
          memory.scale[a] = *read;
        }
        if (const KlartextWord* const word = block.find("CC" + std::string(axis_words[a]))) {
          const auto read = number_of(*word);
          if (!read) return fail(read.error());
          memory.scale_centre[a] = *read * m.unit_scale();
        }
      }
      return set_frame(m);
    default: {  // 247
      reset_frames();
      if (memory.tilted) untilt(m);
      const KlartextWord* const word = block.words.empty() ? nullptr : &block.words.front();
      if (word != nullptr) {
        const auto row = number_of(*word);
        if (!row) return fail(row.error());
        const double preset = std::round(*row);
        if (!(preset >= 0) || preset > 65'535) return fail(alarm(AlarmId::value_out_of_range, word->where, "Q339", preset));
        if (preset < static_cast<double>(m.tables.zeros.size()) && m.tables.zeros[static_cast<std::size_t>(preset)] != Axes{})
          m.modal.work_zero = static_cast<std::uint16_t>(preset);
        else if (preset == 0) m.modal.work_zero = 0;
        m.change_frames();
      }
      return set_frame(m);
    }
  }
}

}  // namespace kadr::heidenhain
