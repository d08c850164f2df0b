// The blocks of the figure of G70 to G73 on a lathe's control (spec/fanuc-t 9.1). Used by control/fanuc/turning/turning_contour.

#include "control/fanuc/lathe/figure_block.h"

#include "control/block_context.h"
#include "lang/block/grammar.h"

namespace kadr::fanuc {
namespace {

bool permitted(const BlockContext& m, const Word& w, const CodeRow& row) {
  switch (row.function) {
    case Function::rapid:
    case Function::linear:
    case Function::arc_cw:
    case Function::arc_ccw:
    case Function::dwell:
    case Function::dwell_or_turns:
    case Function::absolute:
    case Function::incremental:
    // these act in G70 only
    case Function::feed_per_minute:
    case Function::feed_per_revolution:
    case Function::css_on:
    case Function::css_off: return true;
    case Function::radius_side: return m.def.behaviour.lathe == Lathe::haas;  // 9.11; haas-st 6.2
    default: return w.address == 'M' && row.phase != Phase::flow;
  }
}

/// Returns the alarm of a last block whose end depends on the next block (9.1), which does not belong to the figure.
Status check_last(const BlockContext& m, Span where) {
  if (m.has(comma_angle)) return fail(alarm(AlarmId::figure_direct_last, where));
  // 3.4: I, K, R and, with 3405#4, C, A mean a corner or an angle in a block with G01
  const auto means_corner = [&](char letter) { return m.has(letter) && (m.letters.axes & letter_bit(letter)) == 0; };
  bool corner = m.has(comma_chamfer) || m.has(comma_rounding);
  const bool arc = m.has_code({Function::arc_cw, Function::arc_ccw});
  const bool line = m.has_code({Function::rapid, Function::linear}) || (!arc && m.modal.motion == MotionMode::linear);
  for (const char letter : {'I', 'K', 'R', 'C'}) corner = corner || (line && means_corner(letter));
  if (corner) return fail(alarm(AlarmId::figure_corner_last, where));
  return line && means_corner('A') ? fail(alarm(AlarmId::figure_direct_last, where)) : Status();
}

}  // namespace

Status check_figure_block(const BlockContext& m, FigureBlock which, Span where) {
  const Block& block = *m.block;
  const auto unavailable = [&](Span what) { return fail(alarm(AlarmId::figure_unavailable, where, block.text_of(what))); };
  if (block.statement.kind != StatementKind::none) return unavailable(block.where);
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.address == 0 || (m.letters.codes & letter_bit(w.address)) == 0) continue;
    const std::int32_t index = w.code < 0 ? -1 : m.def.row_of(w.address, w.code);
    if (index < 0 || !permitted(m, w, m.def.codes[static_cast<std::size_t>(index)])) return unavailable(w.where);
  }
  if (which.first && !m.has_code({Function::rapid, Function::linear}))
    return fail(alarm(AlarmId::figure_first_block, where, double(block.has_number ? block.number : 0)));
  return which.last ? check_last(m, where) : Status();
}

}  // namespace kadr::fanuc
