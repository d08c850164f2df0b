// Converts the polar words @ and ^ (spec/linuxcnc 7.1; find_ends of LinuxCNC's source).

#include <algorithm>

#include "base/code_literals.h"
#include "base/units.h"
#include "base/vec.h"
#include "control/block_context.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// Replaces the polar words @ and ^ of the block by words X and Y (spec/linuxcnc 7.1), so that each motion function can read them.
Status LinuxCnc::take_polar_words(BlockContext& m) {
  char radius_sign = 0, angle_sign = 0;
  for (const AddressName& name : m.def.grammar.names) {
    if (name.text == "@") radius_sign = name.address;
    if (name.text == "^") angle_sign = name.address;
  }
  Word* const radius = m.has(radius_sign) ? const_cast<Word*>(m.word(radius_sign)) : nullptr;
  Word* const angle = m.has(angle_sign) ? const_cast<Word*>(m.word(angle_sign)) : nullptr;
  if (radius == nullptr && angle == nullptr) return {};
  const Span at = m.block->where;
  const auto wrong = [&](const char* text) { return fault(AlarmId::rs274_motion, at, text); };
  if (m.has_code({Function::machine_coordinates})) return wrong("Cannot use polar coordinates with G53");
  const double unit = (codes.g[6] >= 0 ? codes.g[6] == 20_g : m.modal.inch) ? mm_per_inch : 1;
  const Vec2 here{m.position.programmed[0] / unit, m.position.programmed[1] / unit};
  const bool at_zero = length(here) < 1e-9;
  const bool absolute = codes.g[3] >= 0 ? codes.g[3] == 90_g : m.modal.absolute;
  double r = length(here), t = at_zero ? 0 : angle_deg(here);
  if (absolute) {
    if (radius != nullptr && angle == nullptr && at_zero) return wrong("Must specify angle in polar coordinate if at the origin");
    if (radius != nullptr) r = radius->value;
    if (angle != nullptr) t = angle->value;
  } else {
    if (at_zero && radius != nullptr) return wrong("Incremental motion with polar coordinates is indeterminate when at the origin");
    if (at_zero) return wrong("G91 motion with polar coordinates is indeterminate when at the origin");
    if (radius != nullptr) r += radius->value;
    if (angle != nullptr) t += angle->value;
  }
  const SinCos by = sincos_deg(t);
  Vec2 to{r * by.cos, r * by.sin};
  if (!absolute) to = to - here;
  state.polar_step = !absolute;
  state.polar_radius = radius == nullptr ? 0 : radius->value * unit;
  state.polar_angle = angle == nullptr ? 0 : angle->value;
  // The words @ and ^ of the block become X and Y. If the block has only one of them, a word is added, because both X and Y are needed. The
  // words as written are saved, because a loop may execute the block again; forget_polar_words() restores them.
  written_words.assign(m.block->words.begin(), m.block->words.begin() + m.block->word_count);
  Word* const first = radius != nullptr ? radius : angle;
  first->address = first->written = 'X';
  first->value = to.x;
  Word* second = radius != nullptr && angle != nullptr ? angle : nullptr;
  if (second == nullptr) {
    if (m.block->word_count == limits::block_words) return fail(alarm(AlarmId::too_many_words, at, double{limits::block_words}));
    m.block->words[m.block->word_count] = *first;
    second = &m.block->words[m.block->word_count++];
  }
  second->address = second->written = 'Y';
  second->value = to.y;
  first->expression = second->expression = {};
  m.block->altered = true;
  m.note_addresses();
  return {};
}

/// Restores the words of the block as they were before take_polar_words().
void LinuxCnc::forget_polar_words(BlockContext& m) {
  if (written_words.empty()) return;
  std::copy(written_words.begin(), written_words.end(), m.block->words.begin());
  m.block->word_count = static_cast<std::uint32_t>(written_words.size());
  m.block->altered = false;
  written_words.clear();
  m.note_addresses();
}

}  // namespace kadr::linuxcnc
