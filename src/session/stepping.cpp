// Stepping: decides before which blocks a session is held. It is used by cli/debug, cli/run (--from, --to) and session/restart, and tested
// by tests/session/stepping_test.cpp.

#include "session/stepping.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/ascii.h"
#include "lang/block/block_reader.h"
#include "lang/expression/expression.h"
#include "lang/text/executed_comment.h"

namespace kadr {
namespace {

struct Relation {
  std::string_view written;
  Op op;
};
// The relational operators of conditions. Longer operators come first, so that "<=" is not read as "<".
constexpr std::array relations = {Relation{"<=", Op::less_equal},    Relation{">=", Op::greater_equal}, Relation{"==", Op::equal},
                                  Relation{"!=", Op::not_equal},     Relation{"<>", Op::not_equal},     Relation{"<", Op::less},
                                  Relation{">", Op::greater},        Relation{"EQ", Op::equal},         Relation{"NE", Op::not_equal},
                                  Relation{"GE", Op::greater_equal}, Relation{"GT", Op::greater},       Relation{"LE", Op::less_equal},
                                  Relation{"LT", Op::less}};

/// Finds the relational operator outside all brackets. Returns its index in the text and the operator; nullopt if there is none.
std::optional<std::pair<std::size_t, Relation>> relation_in(std::string_view text) {
  int open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '[' || text[i] == '(') ++open;
    if (text[i] == ']' || text[i] == ')') --open;
    if (open != 0 || (i > 0 && is_letter(text[i - 1]))) continue;
    for (const Relation& relation : relations) {
      const std::string_view here = text.substr(i, relation.written.size());
      if (std::equal(here.begin(), here.end(), relation.written.begin(), relation.written.end(),
                     [](char a, char b) { return to_upper(a) == b; }))
        return std::pair{i, relation};
    }
  }
  return std::nullopt;
}

std::string_view last_part(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

}  // namespace

Stepping::Stepping(Session& session) : session_(session) {
  session_.control().holds_before = [this](const Origin& origin) { return must_hold(origin); };
}

Stepping::~Stepping() { session_.control().holds_before = nullptr; }

bool Stepping::is_file(const std::string& file, std::uint16_t reader) const {
  if (file.empty()) return reader == 0;
  const std::string& path = session_.control().file_name(reader);
  return path == file || last_part(path) == file;
}

bool Stepping::matches(const StopPoint& point, const Origin& origin, bool begins_call) const {
  if (point.line != 0 && (origin.line != point.line || !is_file(point.file, origin.file))) return false;
  if (point.block && (!origin.has_block || origin.block != *point.block || !is_file(point.file, origin.file))) return false;
  if (point.tool != 0 && (tool_ != point.tool || tool_before_ == point.tool)) return false;
  if (point.number != 0 && origin.number != point.number) return false;
  if (point.pass != 0 && passes(point.line, point.file) != point.pass) return false;
  if (!point.call.empty() && (!begins_call || session_.control().calls().back().what != point.call)) return false;
  if (point.condition.empty()) return true;
  const auto is_true = holds(point.condition);
  return is_true && *is_true;
}

bool Stepping::ends_at_target(const Origin& origin, bool same_line, bool begins_call) {
  if (!same_line && matches(*target_, origin, begins_call)) return true;
  ran_out_ = most_ == 0;
  --most_;
  return ran_out_;
}

/// Returns true if nothing but comments is in the block's line. A comment that the control executes, such as (MSG, …), is more.
bool Stepping::is_remark(const Origin& origin) const {
  const AlarmReport::Line line = session_.control().line_at(origin);
  BlockReader reader(text_source(line.text), session_.def().grammar, Encoding::utf8);
  Block block;
  for (;;) {
    const auto got = reader.next(block);
    if (got && *got == BlockReader::Got::end) return true;
    if (!got || block.word_count != 0 || !block.assignments.empty() || block.statement.kind != StatementKind::none ||
        block.marker != Marker::none || block.broken)
      return false;
    for (const Span comment : block.comments)
      if (is_executed_comment(block.text_of(comment))) return false;
  }
}

bool Stepping::asks_for(const Origin& origin, bool same_line) {
  if (past_ != 0) return past_at_ && origin.depth <= *past_at_ && !(same_line && origin.line == past_);
  switch (how_) {
    case How::block: return true;
    case How::single: return !is_remark(origin) && !std::exchange(only_remarks_, false);
    case How::over: return origin.depth <= depth_;
    case How::out: return origin.depth < depth_;
    default: return false;
  }
}

/// Stores the tool in the spindle, if a stop point or the target names a tool.
void Stepping::note_tool() {
  const auto asks = [](const StopPoint& point) { return point.tool != 0; };
  if (!(target_ && asks(*target_)) && std::none_of(points_.begin(), points_.end(), [&](const auto& p) { return asks(p.second); })) return;
  tool_before_ = std::exchange(tool_, session_.control().state_now().tool);
}

/// Returns true if the session is to be held before this block. The control calls this function before each block.
bool Stepping::must_hold(const Origin& origin) {
  if (std::exchange(again_, false)) return false;
  const Origin before = std::exchange(last_, origin);
  if (entered_) {
    if (session_.control().in_entered()) return false;
    next_ = origin;
    return true;
  }
  // True if the block follows another block in the same line, as in `N1 … ПС N2 …`. The line is then not counted a second time.
  const bool same_line = before.line == origin.line && before.file == origin.file && origin.column > before.column;
  const bool begins_call = origin.depth > before.depth;
  const auto is_on_line = [&](const StopPoint& p) { return p.line == origin.line; };
  const bool counts =
      (target_ && is_on_line(*target_)) || std::any_of(points_.begin(), points_.end(), [&](const auto& p) { return is_on_line(p.second); });
  if (counts && !same_line) ++seen_[{origin.file, origin.line}];
  hit_ = 0;
  note_tool();
  if (on_block) on_block(origin);
  for (const auto& [number, point] : points_)
    if (!same_line && matches(point, origin, begins_call)) hit_ = number;
  const bool must = std::exchange(hold_requested_, false);
  const bool is_held = must || (target_ ? ends_at_target(origin, same_line, begins_call) : hit_ != 0 || asks_for(origin, same_line));
  if (past_ != 0 && origin.file == 0 && origin.line == past_ && !past_at_) past_at_ = origin.depth;
  if (is_held) next_ = origin;
  return is_held;
}

void Stepping::set_out() {
  // True if the session was held before this block. Then the control asks a second time whether to hold before the same block. In the
  // middle of a block the control does not ask again.
  again_ = next_.has_value() && !session_.control().in_block();
  depth_ = next_ ? next_->depth : 0;
  next_.reset();
  hit_ = 0;
  hold_requested_ = false;
}

Session::State Stepping::run() {
  set_out();
  return session_.run();
}

void Stepping::begin(How how) {
  how_ = how;
  target_.reset();
  past_ = 0;
  only_remarks_ = how == How::single && next_ && is_remark(*next_);
  set_out();
}

Session::State Stepping::begin_block() {
  how_ = How::block;
  target_.reset();
  past_ = 0;
  again_ = next_.has_value();
  next_.reset();
  return session_.go_on();
}

Session::State Stepping::go(How how) {
  begin(how);
  return session_.run();
}

Session::State Stepping::go_to(const StopPoint& target, std::uint64_t max_blocks) {
  most_ = max_blocks;
  ran_out_ = false;
  how_ = How::free;
  target_ = target;
  past_ = 0;
  const Session::State state = run();
  target_.reset();
  return state;
}

Session::State Stepping::go_past(std::uint32_t line) {
  how_ = How::free;
  past_ = line;
  past_at_.reset();
  if (next_ && next_->file == 0 && next_->line == line) past_at_ = next_->depth;
  const Session::State state = run();
  past_ = 0;
  return state;
}

void Stepping::begin_entering(const std::string& line) {
  stood_ = next_;
  hit_ = 0;
  entered_ = true;
  again_ = false;
  session_.enter(line);
}

void Stepping::end_entering(Session::State came_to) {
  if (came_to == Session::State::stopped) {
    session_.acknowledge();
    session_.alone(session_.own());
    (void)session_.run();
  }
  entered_ = false;
  if (!next_) next_ = stood_;
}

Session::State Stepping::enter(const std::string& line) {
  begin_entering(line);
  const Session::State state = session_.run();
  end_entering(state);
  return state;
}

std::optional<Stepping::Memory> Stepping::snapshot() const {
  auto session = session_.snapshot();
  if (!session) return std::nullopt;
  return Memory{std::move(*session), next_, last_, seen_};
}

Status Stepping::restore(const Memory& from) {
  KADR_TRY(session_.restore(from.session));
  next_ = from.next;
  last_ = from.last;
  seen_ = from.seen;
  hit_ = 0;
  return {};
}

Status Stepping::restore(const SessionSnapshot& from, const StopPoint& target, std::uint32_t passed) {
  KADR_TRY(session_.restore(from));
  next_.reset();
  last_ = {};
  seen_.clear();
  if (passed != 0) seen_[{0, target.line}] = passed;
  hit_ = 0;
  return {};
}

AlarmReport::Line Stepping::line() const { return next_ ? session_.control().line_at(*next_) : AlarmReport::Line{}; }

Result<bool> Stepping::holds(std::string_view condition) const {
  const auto found = relation_in(condition);
  if (!found) {
    const auto value = session_.control().evaluate(condition);
    if (!value) return fail(value.error());
    return !is_vacant(*value) && *value != 0;
  }
  const auto left = session_.control().evaluate(condition.substr(0, found->first));
  if (!left) return fail(left.error());
  const auto right = session_.control().evaluate(condition.substr(found->first + found->second.written.size()));
  if (!right) return fail(right.error());
  return compare(found->second.op, *left, *right);
}

std::size_t Stepping::add(StopPoint point) {
  const std::size_t number = points_.empty() ? 1 : points_.rbegin()->first + 1;
  points_.emplace(number, std::move(point));
  return number;
}

bool Stepping::remove(std::size_t number) { return points_.erase(number) != 0; }

std::uint32_t Stepping::passes(std::uint32_t line, const std::string& file) const {
  std::uint32_t count = 0;
  for (const auto& [place, times] : seen_)
    if (place.second == line && is_file(file, place.first)) count += times;
  return count;
}

}  // namespace kadr
