// The observer of a fuzzed run. Used by fuzz/run_program.

#include "looks.h"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/state/state_json.h"

namespace kadr::fuzz {
namespace {

constexpr std::size_t max_shown = 40;   // greatest number of alarms whose text is written
constexpr std::size_t max_saved = 200;  // greatest number of blocks before which the state is saved for comparison
constexpr double farthest_end = 1e8;    // mm; no motion may end farther away
constexpr double same_place = 1e-5;     // mm; rounding error of coordinates of ten kilometres

bool is_finite(const Axes& axes) {
  for (const double v : axes)
    if (!std::isfinite(v)) return false;
  return true;
}
bool near(double a, double b) { return std::fabs(a - b) <= same_place * (1 + 1e-6 * std::fabs(a)); }
bool near(const Axes& a, const Axes& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!near(a[i], b[i])) return false;
  return true;
}

std::string text_of(const FinalState& e) {
  std::string text;
  for (const auto& [name, value] : e.variables) text += name + "=" + std::to_string(value) + " ";
  for (const std::string& code : e.modal) text += code + " ";
  return text;
}

void same_state(const FinalState& before, const FinalState& after) {
  if (before.variables != after.variables || before.modal != after.modal)
    std::fprintf(stderr, "before: %s\nafter:  %s\n", text_of(before).c_str(), text_of(after).c_str());
  require(before.variables == after.variables, "a faulty block changes no variable");
  require(before.modal == after.modal, "a faulty block changes no mode");
}

void check_other(const Action& action) {
  if (const auto* const dwell = std::get_if<Dwell>(&action.what))
    require(std::isfinite(dwell->seconds) && dwell->seconds >= 0, "a dwell ends");
  if (const auto* const spindle = std::get_if<Spindle>(&action.what)) require(std::isfinite(spindle->rpm), "the speed is a number");
  if (const auto* const message = std::get_if<Message>(&action.what)) require(is_utf8(message->text), "a message is UTF-8");
}

/// A 64-bit FNV-1a hash.
class Digest {
 public:
  void add(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) sum_ = (sum_ ^ (value >> shift & 0xffU)) * 0x100000001b3ULL;
  }
  void add(const Axes& axes) {
    for (const double v : axes) add(std::bit_cast<std::uint64_t>(v));
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325ULL;
};

}  // namespace

Looks::Looks(const Shop& shop, Session& session)
    : shop_(shop),
      session_(session),
      control_(session.control()),
      stand_(control_.tool_position()),
      statistics_(control_.axes(), control_.rotary(), rates_of(session.machine(), session.setup(), control_.axes())),
      plot_(control_.axes(), control_.rotary(), stand_),
      trace_(shop.nowhere, control_.axes(), control_.rotary(), session.setup().points) {
  require(is_finite(stand_.work) && is_finite(stand_.machine), "the run begins somewhere");
  Outlets& outlets = session.outlets();
  outlets.programmed = [this](const Action& action) { programmed(action); };
  outlets.step = [this](const Step& step) { stepped(step); };
  outlets.warning = [this](const AlarmReport& report) { show(report); };
  outlets.alarm = [this](const AlarmReport& report) { return stopped(report); };
  if (session.channels().size() == 1) outlets.clock = &statistics_.clock();
}

void Looks::before_block() {
  before_is_saved_ = ++saved_ <= max_saved;
  if (before_is_saved_) before_block_ = control_.ending();
}

void Looks::begin_at(const Place& place) {
  stand_ = place.stand;
  frame_ = place.frame;
  before_is_saved_ = false;
}

/// Observes an action as programmed, before cutter compensation.
void Looks::programmed(const Action& action) {
  if (++actions_ > last_action_ && stop_ != nullptr) *stop_ = true;
  before_is_saved_ = false;  // the action may be the first of a canned cycle: the state has changed
  if (const auto* const motion = std::get_if<Motion>(&action.what)) check_motion(*motion);
  if (const auto* const frame = std::get_if<FrameChange>(&action.what)) {
    require(is_finite(frame->placement.origin) && is_finite(frame->placement.length) && is_finite(frame->work), "the frame is of numbers");
    frame_ = *frame;
  }
  check_other(action);
  stand_.take(action);
}

/// Observes a step of the tool centre, after cutter compensation.
void Looks::stepped(const Step& step) {
  Digest digest;
  digest.add(step.action.what.index());
  digest.add(step.action.origin.line);
  if (const Motion* const m = step.motion()) {
    require(is_finite(m->to) && is_finite(m->machine), "the tool's centre goes somewhere");
    require(is_arc(m->kind) ? m->turns > 0 && std::isfinite(m->turns) : m->turns == 0, "its arcs turn, its lines do not");
    require(!is_arc(m->kind) || (std::isfinite(m->center.x) && std::isfinite(m->center.y)), "its arcs have a centre");
    if (m->kind == MotionKind::probe) stand_.take(step.action);  // the position at which the probe touched
    digest.add(m->to);
    digest.add(m->machine);
    digest.add(std::bit_cast<std::uint64_t>(m->feed));
  }
  digest_.push_back(digest.sum());
  statistics_.consume(step);
  plot_.consume(step);
  trace_.write(step);
}

void Looks::check_motion(const Motion& motion) const {
  require(is_finite(motion.to) && is_finite(motion.machine), "a motion ends somewhere");
  require(std::isfinite(motion.center.x) && std::isfinite(motion.center.y), "an arc has a centre");
  require(std::isfinite(motion.feed) && motion.feed >= 0, "the feed is a number");
  require(std::isfinite(motion.turns) && std::isfinite(motion.tolerance) && motion.tolerance >= 0, "turns and tolerance are numbers");
  require(is_arc(motion.kind) ? motion.turns > 0 : motion.turns == 0, "an arc turns, a line does not");
  for (std::size_t a = 0; a < control_.axes().size(); ++a) {
    require(std::fabs(motion.to[a]) < farthest_end && std::fabs(motion.machine[a]) < farthest_end, "a motion ends on this earth");
    // An axis that does not move keeps the difference of a cancelled tool length until its next motion (2С42).
    const double apart = motion.machine[a] - motion.to[a];
    const bool in_frame = !frame_ || near(apart, frame_->placement.origin[a] + frame_->placement.length[a]);
    require(!shop_.plain_frames || jumps || in_frame || near(apart, stand_.machine[a] - stand_.work[a]),
            "machine = work + origin + length");
  }
}

bool Looks::stopped(const AlarmReport& report) {
  constexpr std::size_t max_compared = 30;
  ++alarms_;
  last_ = report;
  show(report);
  Digest digest;
  digest.add(static_cast<std::uint64_t>(report.alarm.id));
  digest.add(report.origin.line);
  digest_.push_back(digest.sum());
  // A motion beyond the machine limits is refused: its block is undone, and the control's position differs from the end of the motions.
  if (!jumps && control_.holds_before && !control_.is_stopped()) jumps = true;
  const bool is_known = !jumps && control_.holds_before && session_.channels().size() == 1;  // the control does not execute ahead
  if (is_known && alarms_ <= max_compared) {
    const FinalState after = control_.ending();
    const bool in_space = frame_ && frame_->placement.space;  // the ending is reported in the work system, not in the programmed frame
    const Axes work = in_space ? frame_->placement.space->in_system(stand_.work) : stand_.work;
    const bool frame_is_known = frame_ || shop_.plain_frames;  // false if the run began in mid-program
    // After a refused motion the check uses the end position of that motion.
    require(alarms_ > 1 || ((!frame_is_known || near(after.position, work)) && near(after.machine_position, stand_.machine)),
            "after an alarm the control stands where the motions led");
    if (before_is_saved_ && report.alarm.id != AlarmId::call_too_deep)
      same_state(before_block_, after);  // an interrupt macro may exceed the depth of calls
  }
  before_is_saved_ = false;
  return goes_on_after_alarm();
}

void Looks::finish() {
  control_.check_uncalled([this](const AlarmReport& report) { show(report); });
  const FinalState end = control_.ending();
  if (alarms_ == 0) trace_.finish(end);
  else trace_.finish(end, last_, shop_.texts, Lang::ru);
  require(is_utf8(statistics_.text(control_.blocks(), Lang::ru)), "the summary is UTF-8");
  if (const auto state = control_.run_state(); state) {
    const std::string text = state_json(*state);
    require(nlohmann::json::accept(text), "the state is JSON");
    if (state->frame.empty()) require(parse_setup(text).has_value(), "the state is a set-up");  // a set-up cannot contain a frame in space
  }
}

void Looks::show(const AlarmReport& report) {
  if (++shown_ > max_shown) return;
  std::vector<Finding> findings;
  for (const Lang lang : {Lang::en, Lang::ru}) {
    require(is_utf8(alarm_text(report, shop_.texts, lang)), "an alarm is UTF-8");
    findings.push_back(finding_of(report, shop_.texts, lang));
    require(!findings.back().text.empty() && findings.back().end_column >= findings.back().column, "an alarm has a text and a place");
  }
  require(nlohmann::json::accept(findings_json(findings)), "the list of alarms is JSON");
  if (shown_ % 8 == 1) require(nlohmann::json::accept(findings_sarif(findings, {"0", 0, {}})), "the SARIF log is JSON");
}

}  // namespace kadr::fuzz
