// Finds loops that never end without running them for long (spec/nct/23 23.2.8, 23.2.11). Used by control/macro_b/memory.

#include "control/macro_b/statements/endless.h"

#include <algorithm>
#include <cstring>

#include "control/emitter.h"
#include "control/macro_b/macro_b.h"

namespace kadr::macro_b {

struct Moment {
  std::uint64_t blocks = 0;  // number of blocks executed up to the snapshot
  std::vector<CallFrame> frames;
  std::vector<Locals> levels;
  std::array<double, last_common + 1> commons{};
  std::vector<std::pair<std::size_t, Locals>> repeated_arguments;
  std::vector<Locals> modal_arguments;
  std::array<std::int16_t, most_groups> rows{};
  std::uint8_t active_modal_calls = 0;
  std::size_t finishing = 0;
  std::uint64_t parameters = 0;
  // ---- compared only if the pass reads a system variable: the values that system variables report
  std::uint64_t readings = 0, changes = 0;
  ProgramPosition position;
  ModalWords words;
  double now_ms = 0, cutting_ms = 0, parts_done = 0;
};

namespace {

constexpr std::uint64_t compared_passes = 8;  // number of passes that are compared with each snapshot
// Limits for loops after a fault: the number of jumps back, and the number of blocks executed in loops. When a limit is exceeded, the
// program continues after the loop.
constexpr std::uint64_t jumps_after_fault = 20'000, blocks_after_fault = 50'000;
constexpr std::size_t max_faults = 1000;

/// Compares the local variables bit by bit, so that two vacant variables are equal.
bool same(const Locals& a, const Locals& b) { return std::memcmp(a.data(), b.data(), sizeof a) == 0; }

bool same(const CallFrame& a, const CallFrame& b) {
  return a.kind == b.kind && a.reader == b.reader && a.back_reader == b.back_reader && a.start == b.start && a.back == b.back &&
         a.left == b.left && a.done == b.done && a.return_to == b.return_to && a.modal_calls == b.modal_calls;
}

bool same(const ModalWords& a, const ModalWords& b) {
  return a.aux == b.aux && a.d == b.d && a.e == b.e && a.f == b.f && a.h == b.h && a.m == b.m && a.n == b.n && a.o == b.o && a.s == b.s &&
         a.t == b.t && a.extended_zero == b.extended_zero;
}

void take(const BlockContext& m, Moment& to) {
  const MacroB& macros = macro_b_of(m);
  to.blocks = m.program().blocks();
  to.frames = m.program().frames();
  to.levels = macros.variables.levels();
  for (int n = first_common; n <= last_common; ++n) to.commons[static_cast<std::size_t>(n)] = macros.variables.common(n);
  to.repeated_arguments = macros.repeated_arguments;
  to.modal_arguments.clear();
  for (const ModalCall& call : macros.state.modal_calls) to.modal_arguments.push_back(call.arguments);
  to.rows = m.modal.rows;
  to.active_modal_calls = macros.state.active_modal_calls;
  to.finishing = macros.open_contours();
  to.parameters = macros.parameters.version();
  to.readings = macros.endless.readings();
  to.changes = macros.endless.changes();
  to.position = m.position;
  to.words = macros.state.words;
  to.now_ms = macros.now_ms;
  to.cutting_ms = macros.cutting_ms;
  to.parts_done = macros.state.parts_done;
}

bool same_variables(const BlockContext& m, const Moment& then) {
  const MacroVariables& now = macro_b_of(m).variables;
  if (now.levels().size() != then.levels.size()) return false;
  for (std::size_t i = then.levels.size(); i-- > 0;)
    if (!same(now.levels()[i], then.levels[i])) return false;
  for (int n = first_common; n <= last_common; ++n) {
    const double value = now.common(n);
    if (std::memcmp(&value, &then.commons[static_cast<std::size_t>(n)], sizeof value) != 0) return false;
  }
  return true;
}

bool same_calls(const BlockContext& m, const Moment& then) {
  const MacroB& macros = macro_b_of(m);
  const auto& frames = m.program().frames();
  if (!std::equal(frames.begin(), frames.end(), then.frames.begin(), then.frames.end(),
                  [](const CallFrame& a, const CallFrame& b) { return same(a, b); }))
    return false;
  if (!std::equal(macros.repeated_arguments.begin(), macros.repeated_arguments.end(), then.repeated_arguments.begin(),
                  then.repeated_arguments.end(),
                  [](const auto& a, const auto& b) { return a.first == b.first && same(a.second, b.second); }))
    return false;
  return std::equal(macros.state.modal_calls.begin(), macros.state.modal_calls.end(), then.modal_arguments.begin(),
                    then.modal_arguments.end(), [](const ModalCall& a, const Locals& b) { return same(a.arguments, b); });
}

/// Returns true if those values that a program can change, and that it reads by system variables, are the same as at the snapshot.
bool same_surroundings(const BlockContext& m, const Moment& then) {
  const MacroB& macros = macro_b_of(m);
  const ProgramPosition &a = m.position, &b = then.position;
  return macros.endless.changes() == then.changes && a.programmed == b.programmed && a.work == b.work && a.machine == b.machine &&
         same(macros.state.words, then.words) && macros.now_ms == then.now_ms && macros.cutting_ms == then.cutting_ms &&
         macros.state.parts_done == then.parts_done;
}

bool same(const BlockContext& m, const Moment& then) {
  const MacroB& macros = macro_b_of(m);
  return same_variables(m, then) && m.modal.rows == then.rows && macros.state.active_modal_calls == then.active_modal_calls &&
         macros.open_contours() == then.finishing && macros.parameters.version() == then.parameters && same_calls(m, then) &&
         (macros.endless.readings() == then.readings || same_surroundings(m, then));
}

/// Returns true if the machine's logic, the operator or another channel may end the loop.
bool others_act(const Emitter& m) { return (m.on_block != nullptr && *m.on_block) || m.waiting.known != 0; }

}  // namespace

void Endless::start(Watch& w, Position target, std::uint16_t reader) {
  w.target = target.offset;
  w.reader = reader;
  w.passes = w.seen = 0;
  w.next_look = 1;
}

void Endless::forget() {
  for (Watch& w : watches_) w.target = ~std::uint64_t{0};
}

void Endless::note_fault(const BlockContext& m, bool may_steer) {
  any_fault_ = true;
  for (Watch& w : watches_) w.next_look = 0;  // after a fault, each jump back is examined, not only some of them
  if (may_steer && faults_.size() < max_faults) faults_.push_back({m.block->position.offset, m.program().blocks(), m.program().reader()});
}

/// Returns true if the loop, from the target to the jump, has a faulty block that would have written a variable, called a program or
/// jumped.
bool Endless::holds_fault(const Watch& w) const {
  return std::any_of(faults_.begin(), faults_.end(),
                     [&](const Fault& f) { return f.reader == w.reader && f.offset >= w.target && f.offset <= w.from; });
}

/// Returns true when `kadr check` has executed the greatest number of jumps or blocks that it allows in a loop after a fault. Such a loop
/// may run for long although no two of its passes are equal.
bool Endless::took_too_long(const BlockContext& m, const Watch& w) {
  const auto nth = static_cast<std::size_t>(&w - watches_.data());
  if (looked_ == nth) looped_ += m.program().blocks() - looked_at_;
  looked_ = nth;
  looked_at_ = m.program().blocks();
  return ++looks_ > jumps_after_fault || looped_ > blocks_after_fault;
}

/// Returns true if a loop around this loop has jumped back since this loop's snapshot. In this case the outer loop may be the one that
/// never ends.
bool Endless::is_inside_another(const Watch& w) const {
  return std::any_of(watches_.begin(), watches_.end(), [&](const Watch& other) {
    if (&other == &w || other.target == ~std::uint64_t{0} || other.arrived <= w.snapshot->blocks) return false;
    const bool around = other.reader == w.reader && other.target <= w.target && other.from >= w.from;
    return other.depth < w.depth || (other.depth == w.depth && around);
  });
}

Endless::Verdict Endless::look_closely(const Emitter& m, Watch& w) {
  w.from = m.block->position.offset;
  w.depth = m.program().depth();
  if (any_fault_ && (holds_fault(w) || took_too_long(m, w))) return Verdict::leave;
  if (others_act(m)) return Verdict::go;
  if (w.seen != 0 && w.passes - w.seen <= compared_passes && same(m, *w.snapshot) && !is_inside_another(w))
    return any_fault_ ? Verdict::leave : Verdict::endless;
  const bool power_of_two = (w.passes & (w.passes - 1)) == 0;
  if (power_of_two) {
    auto now = std::make_shared<Moment>();
    take(m, *now);
    w.snapshot = std::move(now);
    w.seen = w.passes;
  }
  const bool compares = w.passes - w.seen < compared_passes;
  w.next_look = any_fault_ ? 0 : compares ? w.passes + 1 : 2 * w.seen;
  return Verdict::go;
}

}  // namespace kadr::macro_b
