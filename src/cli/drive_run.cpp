// Sends a job to a controller, with the operator at the keyboard. Used by drive_command, tested by tests/drive.py.

#include "cli/drive_run.h"

#include <fmt/core.h>

#include <algorithm>

#include "cli/job/keyboard.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/options.h"
#include "config/texts.h"
#include "drive/grbl/grbl_fault.h"
#include "out/text/summary.h"
#include "texts/drive_command.h"

namespace kadr::cli {
namespace {

using drive::LinkEvent;
using drive::LinkEventKind;
using drive::LinkFault;
using drive::LinkPhase;

constexpr int feed_step = 10;  // %

class JobRun {
 public:
  JobRun(drive::GrblDriver& driver, drive::GrblJob& job, std::uint64_t lines, int feed)
      : driver_(driver), link_(driver.link()), job_(job), lines_(lines), feed_(feed) {}

  JobEnd run() {
    if (!link_.begin_job()) {
      complain(translated(texts::drive_command::not_ready, name_of(link_.view().state)));
      return {alarms, {}};
    }
    begun_ = driver_.now();
    if (feed_ != link_.view().overrides.feed) set_feed(feed_);
    while (!done_) {
      feed(link_, job_);
      keys();
      for (const LinkEvent& event : driver_.step(DriveTimes::key)) take(event);
      show_progress();
      if (!stops_ && interrupted()) stop();
      if (stops_ && driver_.now() - stop_begun_ > DriveTimes::stop) done_ = true;
    }
    erase_bar();
    end_.status = interrupted() ? interrupted_status() : status_;
    if (end_.status != ok) end_.continues_at.reset();
    return end_;
  }

 private:
  void keys() {
    for (char key = keyboard_.next(); key != 0; key = keyboard_.next()) {
      if (key == 'h') link_.hold();
      else if (key == 'r') link_.resume();
      else if (key == 's') stop();
      else if (key == 'm' && link_.view().phase == LinkPhase::waiting) leave();
      else if (key == '+' || key == '-') set_feed(feed_ + (key == '+' ? feed_step : -feed_step));
    }
    driver_.flush();
    if (keyboard_.has_ended() && link_.view().phase == LinkPhase::waiting && !stops_) {
      complain(translated(texts::drive_command::no_operator));
      stop();
    }
  }

  void set_feed(int percent) {
    feed_ = std::clamp(percent, feed_step, 200);
    link_.override_feed(feed_);
    link_.override_rapid(std::min(feed_, 100));
    say(translated(texts::drive_command::feed_is, feed_));
  }

  /// Ends the job at its stop, so that the operator can move the machine.
  void leave() {
    if (!link_.end_at_stop()) return;
    end_.continues_at = stop_line_ + 1;
    end_.by_hand = true;
    done_ = true;
  }

  void stop() {
    if (stops_) return;
    stops_ = true;
    status_ = alarms;
    stop_begun_ = driver_.now();
    line_ = link_.view().line.value_or(0);
    write_message(translated(texts::drive_command::stopping) + "\n");
    link_.stop();
    driver_.flush();
  }

  void take(const LinkEvent& event) {
    switch (event.kind) {
      case LinkEventKind::fault: return fault(event);
      case LinkEventKind::held: return say(translated(texts::drive_command::held, event.line));
      case LinkEventKind::resumed: return say(translated(texts::drive_command::resumed));
      case LinkEventKind::stop_reached: return at_stop(event);
      case LinkEventKind::message: return say(translated(texts::drive_command::message, event.text));
      case LinkEventKind::probed:
        return say(event.point ? translated(texts::drive_command::probed, point_text(*event.point))
                               : translated(texts::drive_command::probed_nothing));
      case LinkEventKind::finished:
        done_ = true;
        end_.continues_at = job_.continues_at();
        if (end_.continues_at) return;
        return say(translated(texts::drive_command::finished, link_.view().sent, duration_text(driver_.now() - begun_)));
      case LinkEventKind::stopped:
        done_ = true;
        say(translated(texts::drive_command::stopped, line_, link_.view().executed));
        if (link_.view().state == drive::GrblState::alarm) say(translated(texts::drive_command::position_lost));
        return;
      default: return;
    }
  }

  void at_stop(const LinkEvent& event) {
    stop_line_ = event.line;
    if (event.changes_tool) {
      say(translated(texts::drive_command::at_tool, event.line, event.text));
      if (!keyboard_.has_ended()) leave();
    } else {
      say(translated(texts::drive_command::at_stop, event.line, event.text));
    }
  }

  /// Reports a fault and what lies in the controller, then brings the machine to rest and empties the controller.
  void fault(const LinkEvent& event) {
    status_ = alarms;
    const double seconds = link_.seconds_pending();
    erase_bar();
    complain(drive::fault_text(event, seconds));
    const auto& view = link_.view();
    if (view.sent > view.executed)
      say(translated(texts::drive_command::in_controller, view.sent - view.executed, fmt::format("{:.1f}", seconds)));
    const bool is_gone = event.fault == LinkFault::port_lost || event.fault == LinkFault::silent;
    const bool was_reset = event.fault == LinkFault::reset || event.fault == LinkFault::alarm;
    if (is_gone || was_reset) {
      say(translated(texts::drive_command::position_lost));
      done_ = true;
    } else if (!stops_) {
      stop();
    }
  }

  static void say(const std::string& text) { write_message(text + "\n"); }

  void show_progress() {
    const auto& view = link_.view();
    if (view.reported_at == shown_at_ || !view.machine) return;
    shown_at_ = view.reported_at;
    show_bar(translated(texts::drive_command::progress, view.executed, lines_, view.line.value_or(0), point_text(*view.machine),
                        fmt::format("{:.0f}", driver_.age() * 1000)));
  }

  drive::GrblDriver& driver_;
  drive::GrblLink& link_;
  drive::GrblJob& job_;
  std::uint64_t lines_;
  int feed_;
  Keyboard keyboard_;
  JobEnd end_;
  std::uint32_t stop_line_ = 0;
  int status_ = ok;
  bool done_ = false, stops_ = false;
  std::uint32_t line_ = 0;  // on which the tool was when the stop was requested
  double begun_ = 0, stop_begun_ = 0, shown_at_ = 0;
};

}  // namespace

std::string point_text(const drive::GrblPoint& point) { return fmt::format("X{:.3f} Y{:.3f} Z{:.3f}", point[0], point[1], point[2]); }

JobEnd run_job(drive::GrblDriver& driver, drive::GrblJob& job, std::uint64_t lines, int feed) {
  return JobRun(driver, job, lines, feed).run();
}

bool run_command(drive::GrblDriver& driver, const std::string& text, double patience) {
  if (!driver.link().command(text, patience)) {
    complain(translated(texts::drive_command::not_ready, name_of(driver.link().view().state)));
    return false;
  }
  while (!interrupted())
    for (const LinkEvent& event : driver.step(DriveTimes::key)) {
      if (event.kind == LinkEventKind::fault) {
        complain(drive::fault_text(event, 0));
        return false;
      }
      if (event.kind != LinkEventKind::answered) continue;
      if (event.number != 0) complain(translated(texts::drive_command::refused_command, event.number, text));
      return event.number == 0;
    }
  driver.link().stop();
  driver.flush();
  return false;
}

}  // namespace kadr::cli
