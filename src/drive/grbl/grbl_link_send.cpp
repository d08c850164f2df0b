// The conversation with a controller of the Grbl family: what goes to the controller, and when. Used by grbl_link.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "drive/grbl/grbl_link.h"

namespace kadr::drive {
namespace {

constexpr std::array<const char*, 4> questions = {"$I", "$$", "$#", "$G"};
constexpr std::size_t first_changing_question = 2;  // $# and $G: what the operator can change
constexpr double hold_wait = 0.5;       // time after `!` in which a report must show the hold, s; then the controller is reset at once
constexpr double longest_brake = 5;     // time that the axes may need to stop, s
constexpr double ask_again = 1;         // time after which a report that has not come is requested again, s
constexpr double quick_reports = 0.05;  // time between two requests while the axes brake, s
constexpr double rest_reports = 0.1;    // the same while the job waits for the end of all motions, s
constexpr double driver_time = 0.005;   // how long the line may still have to carry when the next line is sent, s
constexpr double slower = 1.5;          // how much longer the motions may take than Kadr computes
constexpr char reset_byte = '\x18';

}  // namespace

void GrblLink::open(double now) {
  *this = GrblLink(options_);
  now_ = opened_at_ = heard_at_ = now;
  view_.phase = LinkPhase::opening;
}

void GrblLink::port_lost() {
  if (view_.phase == LinkPhase::closed || view_.phase == LinkPhase::lost) return;
  fault(LinkFault::port_lost, 0, view_.line.value_or(0));
}

bool GrblLink::begin_job() {
  only_checks_ = view_.state == GrblState::check;
  if (view_.phase != LinkPhase::ready || !in_flight_.empty() || (view_.state != GrblState::idle && !only_checks_)) return false;
  tracker_.clear();
  view_.sent = view_.accepted = view_.executed = stops_passed_ = 0;
  view_.line.reset();
  is_job_open_ = true;
  job_ended_ = waits_for_hold_ = is_alone_ = false;
  view_.phase = LinkPhase::running;
  progress_at_ = now_;
  return true;
}

void GrblLink::offer(JobLine line) {
  if (!wants_line() || (only_checks_ && line.kind == LineKind::stop)) return;
  if (only_checks_) {
    line.path.clear();
    line.seconds = 0;
  }
  queue_.push_back(std::move(line));
}

bool GrblLink::command(const std::string& text, double patience) {
  if (view_.phase != LinkPhase::ready || !in_flight_.empty()) return false;
  send_line({text.size() + 1, 0, text, false, patience});
  return true;
}

bool GrblLink::ask_offsets() {
  if (view_.phase != LinkPhase::ready || !in_flight_.empty()) return false;
  view_.phase = LinkPhase::asking;
  question_ = first_changing_question;
  ask_next();
  return true;
}

void GrblLink::override_feed(int percent) { override_by('\x90', percent); }
void GrblLink::override_spindle(int percent) { override_by('\x99', percent); }

/// Sends `whole`, which sets an override to 100 %, and then steps: the four bytes after it are 10 % more and less, 1 % more and less.
void GrblLink::override_by(char whole, int percent) {
  const auto step = [whole](int number) { return static_cast<char>(whole + number); };
  const int change = std::clamp(percent, 10, 200) - 100;
  urgent_ += whole;
  urgent_.append(static_cast<std::size_t>(std::abs(change) / 10), step(change > 0 ? 1 : 2));
  urgent_.append(static_cast<std::size_t>(std::abs(change) % 10), step(change > 0 ? 3 : 4));
}

void GrblLink::override_rapid(int percent) { urgent_ += percent <= 25 ? '\x97' : percent <= 50 ? '\x96' : '\x95'; }

bool GrblLink::end_at_stop() {
  if (view_.phase != LinkPhase::waiting) return false;
  end_job();
  view_.phase = LinkPhase::ready;
  return true;
}

void GrblLink::hold() {
  urgent_ += '!';
  waits_for_hold_ = true;
  if (view_.phase == LinkPhase::running || view_.phase == LinkPhase::waiting) view_.phase = LinkPhase::held;
}

void GrblLink::resume() {
  if (view_.phase == LinkPhase::waiting) {
    queue_.pop_front();  // the stop
    ++stops_passed_;
  } else if (view_.phase == LinkPhase::held) {
    urgent_ += '~';
  } else if (view_.phase == LinkPhase::ready && (view_.state == GrblState::hold || view_.state == GrblState::door)) {
    urgent_ += '~';  // a hold without a job
    return;
  } else {
    return;
  }
  view_.phase = LinkPhase::running;
  progress_at_ = resumed_at_ = now_;
}

void GrblLink::stop() {
  if (view_.phase == LinkPhase::closed || view_.phase == LinkPhase::opening || view_.phase == LinkPhase::stopping) return;
  end_job();
  urgent_ += '!';
  view_.phase = LinkPhase::stopping;
  view_.state = GrblState::unknown;  // a report from before `!` is no proof of a standstill
  stopping_at_ = now_;
  reset_sent_ = false;
}

std::string GrblLink::take_output() {
  if (!urgent_.empty()) return std::exchange(urgent_, {});
  if (output_.empty()) return {};
  std::string line = std::move(output_.front());
  output_.pop_front();
  return line;
}

void GrblLink::tick(double now) {
  now_ = now;
  if (view_.phase == LinkPhase::closed) return;
  check_times();
  if (view_.phase == LinkPhase::stopping) check_stopping();
  ask_report();
  pump();
}

void GrblLink::ask_next() {
  if (question_ < questions.size()) {
    const std::string text = questions[question_++];
    return send_line({text.size() + 1, 0, text, false, 0});
  }
  view_.phase = LinkPhase::ready;
  if (settings_.buffer_bytes && *settings_.buffer_bytes > 1) options_.buffer = static_cast<std::size_t>(*settings_.buffer_bytes - 1);
  note(LinkEventKind::connected);
}

void GrblLink::send_line(Sent sent) {
  if (in_flight_.empty()) progress_at_ = now_;
  idle_reports_ = 0;
  output_.push_back(sent.text + '\n');
  if (options_.line_rate > 0) line_busy_until_ = std::max(line_busy_until_, now_) + static_cast<double>(sent.bytes) / options_.line_rate;
  view_.bytes_in_flight += sent.bytes;
  in_flight_.push_back(std::move(sent));
}

/// True if the line has carried nearly everything that was sent.
bool GrblLink::is_line_free() const { return options_.line_rate <= 0 || line_busy_until_ - now_ <= driver_time; }

/// True if everything is sent and answered, and the job goes on or ends when the motions have ended.
bool GrblLink::waits_for_rest() const {
  const bool is_at_stop = !queue_.empty() && queue_.front().kind == LineKind::stop;
  return view_.phase == LinkPhase::running && in_flight_.empty() && (is_at_stop || (queue_.empty() && job_ended_));
}

/// Sends the lines of the job for which the controller has space.
void GrblLink::pump() {
  while (view_.phase == LinkPhase::running && !queue_.empty()) {
    JobLine& next = queue_.front();
    if (next.kind == LineKind::stop) {
      if (!is_all_executed()) return;
      view_.phase = LinkPhase::waiting;
      note(LinkEventKind::stop_reached, next.number, next.text);
      events_.back().changes_tool = next.changes_tool;
      return;
    }
    const std::size_t bytes = next.text.size() + 1;
    const bool waits_alone = !in_flight_.empty() && (is_alone_ || next.kind == LineKind::alone);
    const bool is_too_far = options_.most_seconds_ahead > 0 && tracker_.pending() > 0 &&
                            tracker_.seconds_pending() + next.seconds > options_.most_seconds_ahead;
    if (waits_alone || is_too_far || !is_line_free() || (view_.bytes_in_flight + bytes > options_.buffer && !in_flight_.empty())) return;
    tracker_.sent(next);
    ++view_.sent;
    is_alone_ = next.kind == LineKind::alone;
    send_line({bytes, next.number, std::move(next.text), true, 0});
    queue_.pop_front();
  }
  if (view_.phase == LinkPhase::running && queue_.empty() && job_ended_ && is_all_executed()) {
    end_job();
    view_.phase = LinkPhase::ready;
    note(LinkEventKind::finished, view_.line.value_or(0));
  }
}

void GrblLink::end_job() {
  queue_.clear();
  output_.clear();
  is_job_open_ = false;
  job_ended_ = true;
}

void GrblLink::note(LinkEventKind kind, std::uint32_t line, std::string text) {
  LinkEvent event;
  event.kind = kind;
  event.line = line;
  event.text = std::move(text);
  events_.push_back(std::move(event));
}

void GrblLink::fault(LinkFault fault, int number, std::uint32_t line, std::string text, double value) {
  const bool is_known = view_.phase == LinkPhase::faulted || view_.phase == LinkPhase::lost;
  end_job();
  const bool is_lost = fault == LinkFault::silent || fault == LinkFault::port_lost || fault == LinkFault::no_answer;
  const bool stands =
      fault == LinkFault::reset || fault == LinkFault::alarm || fault == LinkFault::busy || fault == LinkFault::setup_refused;
  if (!stands) urgent_ += '!';
  view_.phase = is_lost ? LinkPhase::lost : LinkPhase::faulted;
  if (is_known && !is_lost) return;  // the first fault is the cause
  LinkEvent event;
  event.kind = LinkEventKind::fault;
  event.fault = fault;
  event.number = number;
  event.line = line;
  event.text = std::move(text);
  event.value = value;
  events_.push_back(std::move(event));
}

void GrblLink::check_times() {
  if (view_.phase == LinkPhase::opening) {
    if (now_ - opened_at_ < options_.banner_wait) return;
    if (now_ - opened_at_ > 2 * options_.banner_wait) fault(LinkFault::no_answer);
    return;
  }
  if (view_.phase == LinkPhase::lost) return;
  const double patience = in_flight_.empty() ? 0 : in_flight_.front().patience;
  if (now_ - heard_at_ > options_.silence + patience) return fault(LinkFault::silent, 0, view_.line.value_or(0));
  const bool runs = view_.phase == LinkPhase::running;
  const bool talks = runs || view_.phase == LinkPhase::asking || view_.phase == LinkPhase::ready;
  if (!talks || (in_flight_.empty() && !(runs && tracker_.pending() > 0))) return;
  const double share = std::min(std::max(view_.overrides.feed, 1) / 100.0, 1.0);
  const double most = options_.answer_wait + patience + slower * tracker_.seconds_pending() / share;
  if (now_ - progress_at_ <= most) return;
  if (in_flight_.empty()) fault(LinkFault::overdue, 0, view_.line.value_or(0));
  else fault(LinkFault::answer_lost, 0, in_flight_.front().number, in_flight_.front().text);
}

/// Waits until the axes are at rest, then resets the controller, which empties its buffers.
void GrblLink::check_stopping() {
  const double since = now_ - stopping_at_;
  if (reset_sent_) {
    if (since > longest_brake) fault(LinkFault::silent);
    return;
  }
  const bool brakes = view_.state == GrblState::hold && view_.substate != 0;
  const bool stands = (view_.state == GrblState::hold && view_.substate == 0) || view_.state == GrblState::alarm ||
                      view_.state == GrblState::door || view_.state == GrblState::check;
  if (!stands && since < (brakes ? longest_brake : hold_wait)) return;
  urgent_ += reset_byte;
  reset_sent_ = true;
  stopping_at_ = now_;
}

void GrblLink::ask_report() {
  const bool opens = view_.phase == LinkPhase::opening;
  if (opens && options_.resets && now_ - opened_at_ < options_.banner_wait && !reset_sent_) return;
  double every = view_.phase == LinkPhase::stopping ? quick_reports : options_.report_every;
  if (waits_for_rest()) every = answered_at_ > asked_at_ ? 0 : std::min(rest_reports, every);  // at once after the last answer
  if (now_ - asked_at_ < (report_asked_ ? std::max(ask_again, every) : every)) return;
  const bool still_moves = view_.state == GrblState::run || view_.state == GrblState::jog;
  if (still_moves && (view_.phase == LinkPhase::faulted || (view_.phase == LinkPhase::held && waits_for_hold_))) urgent_ += '!';
  urgent_ += '?';
  report_asked_ = true;
  asked_at_ = now_;
}

}  // namespace kadr::drive
