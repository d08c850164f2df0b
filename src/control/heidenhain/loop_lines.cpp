// Executes blocks of loops (loop_lines.h). Used by control/heidenhain.

#include "control/heidenhain/loop_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/flow/program_file.h"
#include "control/heidenhain/heidenhain.h"
#include "lang/klartext/klartext_parser.h"

namespace kadr::heidenhain {
namespace {

bool compute_one(KlartextOp op, double& v) {
  switch (op) {
    case KlartextOp::negate:
    case KlartextOp::negative: v = -v; return true;
    case KlartextOp::sin: v = sincos_deg(v).sin; return true;
    case KlartextOp::cos: v = sincos_deg(v).cos; return true;
    case KlartextOp::square: v *= v; return true;
    case KlartextOp::square_root:
      if (!(v >= 0)) return false;
      v = std::sqrt(v);
      return true;
    case KlartextOp::integer: v = std::trunc(v); return true;
    case KlartextOp::absolute: v = std::fabs(v); return true;
    case KlartextOp::fraction: v -= std::trunc(v); return true;
    default: return false;  // by the general path
  }
}

bool compute_two(KlartextOp op, double& a, double b) {
  switch (op) {
    case KlartextOp::add: a += b; return true;
    case KlartextOp::subtract: a -= b; return true;
    case KlartextOp::multiply: a *= b; return true;
    case KlartextOp::divide:
      if (b == 0) return false;
      a /= b;
      return true;
    case KlartextOp::remainder:
      if (b == 0) return false;
      a = std::fmod(a, b);
      return true;
    case KlartextOp::length: a = std::hypot(a, b); return true;
    default: return false;
  }
}

bool is_of_two(KlartextOp op) {
  return (op >= KlartextOp::add && op <= KlartextOp::power) || op == KlartextOp::length || op == KlartextOp::angle;
}

}  // namespace

void LoopLines::forget_all() {
  files_.clear();
  lines_.clear();
  knows_chains_ = records_chains_ = false;
}

/// Computes an expression. Returns false if it has anything but numbers and their operators, or if it causes an alarm.
bool LoopLines::value(const KlartextBlock& block, KlartextExpression expression, double& to) const {
  std::array<double, most_values> stack;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
  std::size_t count = 0;
  for (std::uint16_t i = expression.begin; i < expression.end; ++i) {
    const KlartextStep& step = block.code[i];
    if (step.op == KlartextOp::number || step.op == KlartextOp::parameter) {
      if (count == most_values) return false;
      if (step.op == KlartextOp::number) {
        stack[count++] = step.number;
        continue;
      }
      constexpr std::uint16_t first_set = 108, last_set = 114;  // by the control (spec/heidenhain 10.5)
      if (step.family == ParameterFamily::qs || (step.family == ParameterFamily::q && step.index >= first_set && step.index <= last_set))
        return false;
      const double read = own_.family(step.family)[step.index];
      if (std::isnan(read)) return false;
      stack[count++] = read;
      continue;
    }
    if (is_of_two(step.op)) {
      if (count < 2 || !compute_two(step.op, stack[count - 2], stack[count - 1])) return false;
      --count;
    } else if (count < 1 || !compute_one(step.op, stack[count - 1])) {
      return false;
    }
    if (!std::isfinite(stack[count - 1])) return false;
  }
  if (count != 1) return false;
  to = stack[0];
  return true;
}

/// Returns the number of the line, which is read if it was not met before.
std::int32_t LoopLines::line_at(Interpreter& m, const Position& at) {
  File& file = files_[m.program().reader()];
  if (lines_.empty()) lines_.emplace_back();  // the line of everything that is not read because there is too much of it
  if (lines_.size() >= most_lines && !file.lines.contains(at.offset)) return 0;
  const auto [found, added] = file.lines.try_emplace(at.offset, static_cast<std::int32_t>(lines_.size()));
  if (!added) return found->second;
  Line& line = lines_.emplace_back();
  line.at = line.after = at;
  const ProgramFile& of = m.program().file(m.program().reader());
  if (!file.reader) file.reader = std::make_unique<BlockReader>(of.source(), of.grammar(), of.reader().encoding());
  file.reader->seek(at);
  const auto block = std::make_unique<Block>();
  const auto got = file.reader->next(*block);
  if (!got || *got == BlockReader::Got::end) return found->second;
  line.after = file.reader->position();
  compile(m, line, *block);
  return found->second;
}

void LoopLines::compile(Interpreter& m, Line& line, const Block& block) {
  if (block.skip != 0 || !block.warnings.empty()) return;
  line.at = block.position;
  line.origin.line = block.position.line;
  line.origin.column = block.where.begin + 1;
  line.origin.block = block.number;
  line.origin.has_block = block.has_number;
  line.origin.block_digits = block.number_digits;
  line.origin.file = m.program().reader();
  if (block.text.substr(0, block.where.begin).find_first_not_of(" \t/0123456789") != std::string_view::npos) return;
  line.read = own_.block_at(m, block.position);
  if (line.read == nullptr) return;
  const KlartextBlock& read = *line.read;
  const auto to_label = [&](Kind kind) {
    if (read.name.empty()) return;
    const auto* const label = own_.index(m).label(read.name);
    if (label == nullptr || label->twice) return;
    line.target = label->at;
    line.kind = kind;
  };
  switch (read.kind) {
    case KlartextKind::words: line.kind = read.words.empty() ? Kind::nothing : Kind::other; break;
    case KlartextKind::passed_over: line.kind = Kind::nothing; break;
    case KlartextKind::label: line.kind = read.name == "0" ? Kind::leave : Kind::nothing; break;
    case KlartextKind::assignment: line.kind = read.part == 1 ? Kind::other : Kind::assign; break;
    case KlartextKind::jump:
      if (read.second) to_label(Kind::jump);
      break;
    case KlartextKind::call_label: to_label(read.part < 0 ? Kind::call : Kind::repeat); break;
    case KlartextKind::line:
      if (compile_motion(m, line)) line.kind = Kind::line;
      break;
    default: break;
  }
}

/// Takes the words of a straight line. Returns false if it has more than linear axes, R0, F and FMAX.
bool LoopLines::compile_motion(const BlockContext& m, Line& line) const {
  for (const KlartextWord& word : line.read->words) {
    if (word.name == word_name("R0")) continue;
    if (word.name == word_name("FMAX")) {
      line.rapid = true;
      continue;
    }
    if (word.name == word_name("F")) {
      line.feed = &word;
      continue;
    }
    constexpr std::size_t linear_axes = 3;
    std::size_t axis = 0;
    while (axis < linear_axes && word.name != word_name(m.def.axes[axis])) ++axis;
    if (axis == linear_axes) return false;
    line.axes.push_back({axis, word.incremental, word.number, word.value});
  }
  return !line.axes.empty();
}

/// Returns true if nothing that is in force makes a line more than its words.
bool LoopLines::moves_plainly(Interpreter& m) const {
  const Memory& memory = own_.memory;
  return m.modal.radius_side == 0 && !memory.calls_always && !(memory.plunge > 0) && !memory.shortest && !memory.feed_per_turn &&
         !memory.holds_tip && !memory.tilted && !own_.index(m).has_corners() && m.modal.feed_mode == FeedMode::per_minute;
}

Origin LoopLines::origin_of(const Interpreter& m, const Line& line, std::uint64_t done) const {
  Origin origin = line.origin;
  origin.number = static_cast<std::uint32_t>(m.program().blocks() + done + 1);
  origin.depth = static_cast<std::uint8_t>(std::min<std::size_t>(m.program().depth(), 255));
  origin.calls = origin.depth == m.origin.depth ? m.origin.calls : std::uint16_t{0};
  return origin;
}

LoopLines::Step LoopLines::jump(const Line& line) const {
  double a = 0, b = 0;
  if (!value(*line.read, line.read->value, a) || !value(*line.read, line.read->second, b)) return Step::stops;
  constexpr double equal = 1e-9;  // as in the general path (spec/heidenhain 10.3)
  const bool same = std::fabs(a - b) <= equal;
  switch (line.read->number) {
    case 9: return same ? Step::jumps : Step::on;
    case 10: return same ? Step::on : Step::jumps;
    case 11: return a > b && !same ? Step::jumps : Step::on;
    default: return a < b && !same ? Step::jumps : Step::on;
  }
}

LoopLines::Step LoopLines::repeat(const BlockContext& m, const Line& line) {
  auto& repeats = own_.memory.repeats;
  const auto key = std::pair(m.program().reader(), line.at.offset);
  const auto open = repeats.find(key);
  double left = 0;
  if (open != repeats.end()) {
    left = open->second;
  } else {
    if (!value(*line.read, line.read->value, left)) return Step::stops;
    left = std::round(left);
    constexpr double most = 65'534;
    if (!(left >= 0 && left <= most)) return Step::stops;
  }
  if (left < 1) {
    if (open != repeats.end()) repeats.erase(open);
    return Step::on;
  }
  if (open != repeats.end()) open->second = left - 1;
  else repeats[key] = left - 1;
  return Step::jumps;
}

LoopLines::Step LoopLines::call(Interpreter& m, const Line& line, std::uint64_t done) {
  if (!knows_chains_ || records_chains_) return Step::stops;
  CallFrame frame;
  frame.kind = CallFrame::Kind::subprogram;
  frame.left = 1;
  frame.caller = origin_of(m, line, done);
  m.flow.jump(line.after);
  if (!m.flow.call_at(m.program().reader(), line.target, frame, line.read->where)) return Step::stops;
  own_.memory.calls.emplace_back();
  return Step::jumps;
}

LoopLines::Step LoopLines::leave(Interpreter& m, const Line& line) {
  auto& calls = own_.memory.calls;
  if (calls.empty() || calls.back().of_program) return Step::on;
  if (!knows_chains_ || records_chains_ || !m.flow.end_subprogram(line.read->where)) return Step::stops;
  calls.pop_back();
  return Step::jumps;
}

LoopLines::Step LoopLines::move(Interpreter& m, const Line& line, std::uint64_t done) {
  if (m.batch->size() + 1 >= batch_size || !moves_plainly(m)) return Step::stops;
  // The chain of calls is that of the block before it, at the same depth; else it is not recorded.
  if (m.program().depth() != m.origin.depth && (!knows_chains_ || records_chains_)) return Step::stops;
  Axes to = m.position.programmed;
  AxisMask named = 0;
  for (const AxisValue& axis : line.axes) {
    double read = axis.number;
    if (axis.value && !value(*line.read, axis.value, read)) return Step::stops;
    read *= m.unit_scale();
    to[axis.axis] = axis.incremental ? to[axis.axis] + read : read;
    if (!(std::fabs(to[axis.axis]) <= farthest)) return Step::stops;
    named |= AxisMask{1} << axis.axis;
  }
  double feed = m.modal.feed;
  if (line.feed != nullptr) {
    feed = line.feed->number;
    if (line.feed->value && !value(*line.read, line.feed->value, feed)) return Step::stops;
    feed *= m.unit_scale();
  }
  if (!line.rapid && !(feed > 0 && (line.feed != nullptr || m.modal.feed_known))) return Step::stops;
  if (line.feed != nullptr && !(feed > 0)) return Step::stops;
  own_.memory.feed_before = m.modal.feed_known ? m.modal.feed : 0;
  if (line.feed != nullptr) m.modal.feed = feed, m.modal.feed_known = true;
  own_.previous_ = m.position.work;
  own_.corner_rounding = own_.corner_chamfer = own_.corner_feed = 0;
  own_.corner = CornerJoin::arc;
  m.origin = origin_of(m, line, done);
  moved_ = true;
  if (!m.straight(line.rapid ? MotionKind::rapid : MotionKind::feed, to, named)) return Step::stops;
  own_.memory.moved_at_rapid = line.rapid;
  own_.note_straight(m, line.rapid);
  return Step::on;
}

LoopLines::Step LoopLines::execute(Interpreter& m, Line& line, std::uint64_t done) {
  switch (line.kind) {
    case Kind::nothing: return Step::on;
    case Kind::assign: {
      double result = 0;
      if (!value(*line.read, line.read->value, result)) return Step::stops;
      (void)own_.set_parameter(line.read->target, result);
      own_.written_.clear();
      return Step::on;
    }
    case Kind::jump: return jump(line);
    case Kind::repeat: return repeat(m, line);
    case Kind::call: return call(m, line, done);
    case Kind::leave: return leave(m, line);
    case Kind::line: return move(m, line, done);
    default: return Step::stops;
  }
}

bool LoopLines::run(Interpreter& m) {
  constexpr std::uint64_t most_at_once = 4096;  // so that the caller may stop the run
  constexpr std::uint64_t last_blocks = 2;      // by the general path, so that the alarm of an endless program names the right line
  const std::uint64_t left = m.program().repeats_left();
  const std::uint64_t most = std::min(most_at_once, left - std::min(left, last_blocks));
  Position now = m.program().position();
  std::uint64_t done = 0;
  moved_ = false;
  for (std::int32_t at = line_at(m, now); at != 0 && done < most;) {
    Line& line = lines_[static_cast<std::size_t>(at)];
    const Step step = execute(m, line, done);
    if (step == Step::stops) break;
    ++done;
    if (line.kind == Kind::leave && step == Step::jumps) {
      now = m.program().position();
      at = line_at(m, now);
      continue;
    }
    now = step == Step::jumps ? line.target : line.after;
    std::int32_t& follows = step == Step::jumps ? line.jumped : line.next;
    if (follows < 0) follows = line_at(m, now);
    at = follows;
  }
  if (m.program().position() != now) m.flow.jump(now);
  if (moved_) m.modes_changed();
  if (done == 0) return false;
  m.flow.pass(done);
  return true;
}

}  // namespace kadr::heidenhain
