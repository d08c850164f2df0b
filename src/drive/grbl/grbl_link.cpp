// The conversation with a controller of the Grbl family: what comes from the controller. grbl_link_send.cpp has what goes to it. Tested by
// tests/drive/grbl_link_test.cpp against the double of tests/drive/grbl_double.h.

#include "drive/grbl/grbl_link.h"

#include <array>
#include <cmath>
#include <utility>

#include "base/units.h"

namespace kadr::drive {
namespace {

constexpr double resume_wait = 0.5;        // time after `~` in which a report may still show the hold, s
constexpr std::size_t longest_line = 512;  // of a controller, bytes; Grbl's own are shorter than 150

constexpr std::array<std::string_view, 10> phase_names = {"closed",  "opening", "asking",   "ready",   "running",
                                                          "waiting", "held",    "stopping", "faulted", "lost"};
constexpr std::array<std::string_view, 14> fault_names = {"no_answer", "busy",        "line_refused",  "setup_refused", "alarm",
                                                          "reset",     "answer_lost", "broken_answer", "extra_answer",  "buffer_wrong",
                                                          "overdue",   "off_path",    "silent",        "port_lost"};

}  // namespace

std::string_view name_of(LinkPhase phase) { return phase_names[static_cast<std::size_t>(phase)]; }
std::string_view name_of(LinkFault fault) { return fault_names[static_cast<std::size_t>(fault)]; }

void GrblLink::receive(std::string_view bytes, double now) {
  now_ = now;
  if (!bytes.empty() && view_.phase != LinkPhase::closed) heard_at_ = now;
  for (const char byte : bytes) {
    if (byte == '\r') continue;
    if (byte != '\n') {
      if (partial_.size() < longest_line) partial_ += byte;
      continue;
    }
    const std::string text = std::exchange(partial_, {});
    if (!text.empty()) line(text);
  }
  pump();
}

void GrblLink::line(std::string_view text) {
  if (view_.phase == LinkPhase::closed) return;
  const GrblReply reply = grbl_reply(text);
  if (const auto* const found = std::get_if<GrblBanner>(&reply)) return banner(*found);
  if (const auto* const found = std::get_if<GrblReport>(&reply)) return report(*found);
  if (view_.phase == LinkPhase::opening) return;  // before the banner: the rest of what was sent earlier (drive.md F5)
  if (std::holds_alternative<GrblOk>(reply)) answer({});
  else if (const auto* const error = std::get_if<GrblError>(&reply)) answer(error->code);
  else if (const auto* const found = std::get_if<GrblAlarm>(&reply)) alarm(found->code);
  else if (const auto* const setting = std::get_if<GrblSetting>(&reply)) settings_.values[setting->number] = setting->value;
  else if (const auto* const found_bracket = std::get_if<GrblBracket>(&reply)) bracket(*found_bracket);
  else if (const auto* const found_unknown = std::get_if<GrblUnknown>(&reply)) unknown(found_unknown->text);
}

/// An answer to the oldest line that is not answered: `ok`, or the number of an error.
void GrblLink::answer(std::optional<int> error) {
  progress_at_ = answered_at_ = now_;
  idle_reports_ = 0;
  if (in_flight_.empty()) {
    if (is_at_work()) fault(LinkFault::extra_answer);
    return;
  }
  const Sent sent = in_flight_.front();
  in_flight_.pop_front();
  view_.bytes_in_flight -= sent.bytes;
  if (sent.is_job) return job_answer(sent, error);
  if (view_.phase == LinkPhase::asking) {
    if (error) return fault(LinkFault::setup_refused, *error, 0, sent.text);
    return ask_next();
  }
  LinkEvent event;
  event.kind = LinkEventKind::answered;
  event.number = error.value_or(0);
  event.text = sent.text;
  events_.push_back(event);
}

void GrblLink::job_answer(const Sent& sent, std::optional<int> error) {
  if (!error) {
    tracker_.accepted();
    ++view_.accepted;
    return;
  }
  if (is_at_work()) fault(LinkFault::line_refused, *error, sent.number, sent.text);
}

void GrblLink::banner(const GrblBanner& banner) {
  view_.version = banner.version;
  const LinkPhase before = std::exchange(view_.phase, LinkPhase::ready);
  in_flight_.clear();
  output_.clear();
  view_.bytes_in_flight = 0;
  report_asked_ = false;
  waits_for_hold_ = false;
  progress_at_ = now_;
  if (before == LinkPhase::opening || before == LinkPhase::asking) {
    view_.phase = LinkPhase::asking;
    question_ = 0;
    return ask_next();
  }
  if (before == LinkPhase::stopping) {
    end_job();
    return note(LinkEventKind::stopped);
  }
  view_.phase = before;
  fault(LinkFault::reset, 0, view_.line.value_or(0), "Grbl " + banner.version);
}

void GrblLink::alarm(int code) {
  view_.state = GrblState::alarm;
  if (view_.phase == LinkPhase::stopping) return;  // ALARM:3 follows a reset in motion
  fault(LinkFault::alarm, code, view_.line.value_or(0));
}

void GrblLink::bracket(const GrblBracket& bracket) {
  if (bracket.tag == "PRB" && is_at_work()) {
    LinkEvent event;
    event.kind = LinkEventKind::probed;
    if (bracket.text.ends_with(":1")) event.point = grbl_point(bracket.text.substr(0, bracket.text.size() - 2));
    events_.push_back(event);
    return;
  }
  if (settings_.take(bracket)) return;
  if (bracket.tag == "MSG") note(LinkEventKind::message, 0, bracket.text);
}

/// Bytes that are no answer may be the rest of a lost `ok`, so the count of the buffer is no longer certain.
void GrblLink::unknown(const std::string& text) {
  if (is_at_work()) fault(LinkFault::broken_answer, 0, 0, text);
}

void GrblLink::report(const GrblReport& report) {
  report_asked_ = false;
  view_.state = report.state;
  view_.substate = report.substate;
  view_.reported_at = now_;
  const double unit = settings_.value(13, 0) != 0 ? mm_per_inch : 1;
  if (report.offset) offset_ = report.offset;
  std::optional<GrblPoint> machine = report.machine;
  if (!machine && report.work && offset_) {
    machine = report.work;
    for (std::size_t i = 0; i < grbl_axes; ++i) (*machine)[i] += (*offset_)[i];
  }
  if (machine)
    for (double& value : *machine) value *= unit;
  view_.machine = machine;
  view_.free = report.free;
  view_.pins = report.pins;
  if (report.feed) view_.feed = *report.feed * unit;
  if (report.speed) view_.speed = *report.speed;
  if (report.overrides) view_.overrides = *report.overrides;
  const bool is_empty = !report.free || (report.free->blocks >= settings_.planner_blocks.value_or(0) &&
                                         report.free->bytes >= settings_.buffer_bytes.value_or(0));
  const bool rests = report.state == GrblState::idle || report.state == GrblState::check;
  idle_reports_ = rests && is_empty ? idle_reports_ + 1 : 0;
  if (view_.phase == LinkPhase::opening) {
    if (!options_.resets) {
      view_.phase = LinkPhase::ready;
      note(LinkEventKind::connected);
    } else if (!reset_sent_ && (report.state == GrblState::idle || report.state == GrblState::alarm || report.state == GrblState::check)) {
      reset_sent_ = true;  // nothing moves: the reset makes its state known, and empties its buffers
      urgent_ += '\x18';
      opened_at_ = now_;
    } else if (!reset_sent_) {
      fault(LinkFault::busy, 0, 0, std::string(name_of(report.state)));
    }
    return;
  }
  if (is_at_work()) job_report();
}

/// Compares the report with the job, and notices holds and the end.
void GrblLink::job_report() {
  const bool stands = view_.state == GrblState::hold || view_.state == GrblState::door;
  const bool rests = stands && view_.substate < (view_.state == GrblState::hold ? 1 : 2);  // Hold:1 brakes, Door:2 and 3 move
  if (stands) {
    progress_at_ = now_;
    if (rests && view_.phase == LinkPhase::held && std::exchange(waits_for_hold_, false))
      note(LinkEventKind::held, view_.line.value_or(0), std::string(name_of(view_.state)));
  }
  if (rests && view_.phase == LinkPhase::running && now_ - resumed_at_ > resume_wait) {
    view_.phase = LinkPhase::held;
    note(LinkEventKind::held, view_.line.value_or(0), std::string(name_of(view_.state)));
  } else if (!stands && view_.phase == LinkPhase::held && !waits_for_hold_ && view_.state != GrblState::unknown) {
    view_.phase = LinkPhase::running;  // somebody pressed cycle start at the machine
    progress_at_ = now_;
    note(LinkEventKind::resumed, view_.line.value_or(0));
  }
  if (view_.state == GrblState::alarm) return fault(LinkFault::alarm, 0, view_.line.value_or(0));
  const int total_bytes = settings_.buffer_bytes.value_or(0);
  if (view_.free && total_bytes > 0 && total_bytes - view_.free->bytes > static_cast<int>(view_.bytes_in_flight))
    return fault(LinkFault::buffer_wrong, total_bytes - view_.free->bytes, view_.line.value_or(0));
  if (!view_.machine) return;
  if (only_checks_) view_.executed = view_.accepted;
  if (only_checks_) return;
  const std::optional<int> in_use =
      view_.free && settings_.planner_blocks ? std::optional(*settings_.planner_blocks - view_.free->blocks) : std::nullopt;
  const Tracked tracked = tracker_.at(*view_.machine, in_use);
  if (!tracked.on_path) return fault(LinkFault::off_path, 0, view_.line.value_or(0), {}, tracked.off);
  view_.line = tracked.line;
  if (is_all_executed()) {
    tracker_.all_executed();
    view_.line = tracker_.last_line();
    const double off = tracker_.off_end(*view_.machine);
    if (off > options_.off_path) return fault(LinkFault::off_path, 0, view_.line.value_or(0), {}, off);
  }
  if (const std::uint64_t executed = tracker_.executed() + stops_passed_; executed != view_.executed) {
    view_.executed = executed;
    progress_at_ = now_;
  }
}

/// True if the controller has nothing to do: every line is answered, and a later report shows an idle controller with empty buffers. A
/// report without buffers may come between the answer to a line and the beginning of its motion, so two are needed.
bool GrblLink::is_all_executed() const { return in_flight_.empty() && output_.empty() && idle_reports_ >= (view_.free ? 1 : 2); }

/// True while a job exists that a fault would end.
bool GrblLink::is_at_work() const {
  return view_.phase == LinkPhase::running || view_.phase == LinkPhase::waiting || view_.phase == LinkPhase::held;
}

}  // namespace kadr::drive
