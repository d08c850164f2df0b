// Loops and branches among the O lines (spec/linuxcnc 6.4). Used by control/linuxcnc/o_line_flow.

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "control/linuxcnc/o_lines.h"

namespace kadr::linuxcnc {

Status OLines::begin_do() {
  const auto made = take_mark(OWord::do_);
  return made ? Status() : Status(fail(made.error()));
}

Status OLines::while_loop() {
  const auto test = value_of(s_.conditions[0]);
  if (!test) return fail(test.error());
  if (const Mark* const known = mark(); known != nullptr && known->word == OWord::do_ && known->at != m_.block->position) {
    const bool early = std::exchange(flow_.break_left, false);
    if (*test != 0 && !early) return jump_to(position_after(*known));
    if (*test != 0) warn_once(flow_.warned_early, AlarmId::loop_ends_early);
    forget_mark();
    return {};
  }
  if (*test != 0) {
    const auto made = take_mark(OWord::while_);
    return made ? Status() : Status(fail(made.error()));
  }
  forget_mark();
  flow_.continue_left = false;
  return after_end({OWord::endwhile});
}

Status OLines::repeat() {
  const auto count = value_of(s_.conditions[0]);
  if (!count) return fail(count.error());
  if (std::round(*count) < 1) {
    flow_.continue_left = false;
    return after_end({OWord::endrepeat});
  }
  const auto made = take_mark(OWord::repeat);
  if (!made) return fail(made.error());
  (*made)->left = std::round(*count);
  return {};
}

/// Jumps to the line after the end of the loop or branch. `ends`: the O words by which it may end.
Status OLines::after_end(std::initializer_list<OWord> ends) {
  const std::int32_t end = next_of(ends);
  if (end < 0) return end_of_file_seeking();
  return jump_to(row(end).position_after);
}

Position OLines::position_after(const Mark& of) {
  const OFile& all = of.reader == m_.program().reader() ? *file_ : flow_.of(m_, of.reader);
  const auto found = all.by_offset.find(of.at.offset);
  return found == all.by_offset.end() ? of.at : all.lines[static_cast<std::size_t>(found->second)].position_after;
}

Status OLines::end_loop(OWord of) {
  Mark* const known = mark();
  if (known == nullptr) return undefined();
  if (known->word != of) return wrong(fmt::format("{}: no matching label: '{}' {}", line(), line_text(), found(*known)));
  if (of == OWord::while_) return jump_to(known->at);
  if (--known->left < 1) {
    const Position begin = known->at;
    forget_mark();
    if (!std::exchange(flow_.continue_left, false)) return {};
    warn_once(flow_.warned_again, AlarmId::loop_runs_again);
    return jump_to(begin);
  }
  return jump_to(position_after(*known));
}

Status OLines::leave_loop(bool again) {
  const Mark* const known = mark();
  if (known == nullptr) return undefined();
  if (known->word != OWord::while_ && known->word != OWord::do_)
    return wrong(fmt::format("{}: no matching while/do label: '{}' {}", line(), line_text(), found(*known)));
  const bool of_while = known->word == OWord::while_;
  if (of_while && (again || flow_.continue_left)) {
    if (!again) warn_once(flow_.warned_again, AlarmId::loop_runs_again);
    flow_.continue_left = false;
    return jump_to(known->at);
  }
  (again ? flow_.continue_left : flow_.break_left) = again || of_while;
  const std::int32_t end = next_of({OWord::endwhile, OWord::while_});
  if (end < 0) return end_of_file_seeking();
  if (again) return jump_to(row(end).at);
  forget_mark();
  return jump_to(row(end).position_after);
}

void OLines::warn_once(bool& reported, AlarmId id) {
  if (!std::exchange(reported, true)) m_.warn(warning(id, s_.where));
}

Status OLines::branch() {
  const auto test = value_of(s_.conditions[0]);
  if (!test) return fail(test.error());
  const auto made = take_mark(OWord::if_, true);
  if (!made) return fail(made.error());
  (*made)->taken = *test != 0;
  return *test != 0 ? Status() : on_to_other();
}

Status OLines::on_to_other() {
  const std::int32_t other = next_of({OWord::elseif, OWord::else_, OWord::endif});
  if (other < 0) return end_of_file_seeking();
  return jump_to(row(other).at);
}

Status OLines::other_branch() {
  Mark* const known = mark();
  if (known == nullptr) return undefined();
  if (known->word != OWord::if_) return wrong(fmt::format("{}: no matching 'if' label: '{}' {}", line(), line_text(), found(*known)));
  if (known->taken) return after_end({OWord::endif});
  if (s_.o_word == OWord::else_) {
    known->taken = true;
    return {};
  }
  const auto test = value_of(s_.conditions[0]);
  if (!test) return fail(test.error());
  known->taken = *test != 0;
  return *test != 0 ? Status() : on_to_other();
}

Status OLines::end_branch() {
  const Mark* const known = mark();
  if (known == nullptr) return undefined();
  if (known->word != OWord::if_)
    return wrong(fmt::format("{}: no matching label: '{}' {}: '{}'", line(), local_name(), found(*known), line_text()));
  return {};
}

}  // namespace kadr::linuxcnc
