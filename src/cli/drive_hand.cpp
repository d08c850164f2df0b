// The operator of kadr drive by hand, the controller's check mode, and the program continued. Tested by tests/drive.py.

#include "cli/drive_hand.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <deque>

#include "cli/job/keyboard.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "drive/grbl/grbl_fault.h"
#include "texts/drive_command.h"

namespace kadr::cli {
namespace {

using drive::LineKind;
using drive::LinkEvent;
using drive::LinkEventKind;
using drive::LinkFault;
using drive::LinkPhase;

constexpr double hand_patience = 120;  // time that a line by hand may need, s
constexpr double rest_wait = 2;        // time until the axes are at rest when the program goes on, s
constexpr double jog_feed = 500;       // mm/min, if the operator states none

void tell(const std::string& text) { write_message(text + "\n"); }

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Returns the line for the controller of what the operator has typed: `j x5 f300` is a jog by 5 mm. Empty: it may not be sent.
std::string line_of(const std::string& typed) {
  std::string text = in_capitals(typed);
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  if (text.starts_with("J") && text.size() > 1) {
    const bool has_feed = text.find('F') != std::string::npos;
    return "$J=G91G21" + text.substr(1) + (has_feed ? "" : fmt::format("F{:g}", jog_feed));
  }
  // Settings are not changed here: a job would run with others than those of the proof.
  const bool is_setting = text.starts_with('$') && text != "$H" && text != "$X" && text != "$#" && text != "$G";
  return is_setting ? std::string() : text;
}

class ByHand {
 public:
  explicit ByHand(drive::GrblDriver& driver) : driver_(driver), link_(driver.link()) {}

  bool work() {
    tell(translated(texts::drive_command::by_hand));
    while (!interrupted()) {
      while (goes_on_at_ == 0) {
        const auto typed = keyboard_.line();
        if (!typed) break;
        if (*typed == "s" || (typed->empty() && keyboard_.has_ended())) return left();
        if (*typed == "h") hold();
        else if (*typed == "~") link_.resume();
        else if (*typed == "r") goes_on_at_ = driver_.now();  // what is typed after it is for another question
        else if (!typed->empty()) typed_.push_back(*typed);
      }
      if (rests() && !typed_.empty()) {
        execute(typed_.front());
        typed_.pop_front();
      } else if (goes_on_at_ != 0 && rests()) {
        return true;
      } else if (goes_on_at_ != 0 && driver_.now() - goes_on_at_ > rest_wait && typed_.empty()) {
        complain(translated(texts::drive_command::not_ready, name_of(link_.view().state)));
        goes_on_at_ = 0;
      }
      if (cancels_ && link_.view().state == drive::GrblState::jog && link_.view().reported_at > cancelled_at_) hold();
      driver_.flush();
      for (const LinkEvent& event : driver_.step(DriveTimes::key))
        if (!take(event)) return false;
    }
    return left();
  }

 private:
  bool left() {
    link_.hold();
    driver_.flush();
    tell(translated(texts::drive_command::left_by_hand));
    return false;
  }
  /// True if the last line is answered, and a later report shows that nothing moves.
  bool rests() const {
    const auto& view = link_.view();
    return view.bytes_in_flight == 0 && view.state == drive::GrblState::idle && view.reported_at > answered_at_;
  }
  /// Ends a jog, or holds another motion. Grbl would stay in its hold state if it held after a jog.
  void hold() {
    typed_.clear();
    if (jogs_) link_.cancel_jog();
    else link_.hold();
    cancels_ = jogs_;
    cancelled_at_ = driver_.now();
  }
  void execute(const std::string& typed) {
    const std::string text = line_of(typed);
    if (text.empty()) return complain(translated(texts::drive_command::not_by_hand, typed));
    if (!link_.command(text, hand_patience)) return complain(translated(texts::drive_command::not_ready, name_of(link_.view().state)));
    jogs_ = text.starts_with("$J");
    cancels_ = false;
  }
  bool take(const LinkEvent& event) {
    switch (event.kind) {
      case LinkEventKind::fault: complain(drive::fault_text(event, 0)); return false;
      case LinkEventKind::answered:
        answered_at_ = driver_.now();
        if (event.number != 0) complain(translated(texts::drive_command::refused_command, event.number, event.text));
        else tell(translated(texts::drive_command::answered, event.text));
        return true;
      case LinkEventKind::probed:
        tell(event.point ? translated(texts::drive_command::probed, point_text(*event.point))
                         : translated(texts::drive_command::probed_nothing));
        return true;
      case LinkEventKind::message: tell(translated(texts::drive_command::message, event.text)); return true;
      default: return true;
    }
  }

  drive::GrblDriver& driver_;
  drive::GrblLink& link_;
  Keyboard keyboard_;
  std::deque<std::string> typed_;               // lines that wait until the one before is done
  bool jogs_ = false, cancels_ = false;         // the last line was a jog; it is being cancelled
  double answered_at_ = 0, cancelled_at_ = -1;  // s
  double goes_on_at_ = 0;                       // when the operator let the program go on; 0: not yet
};

/// Waits for an event. Returns false after a fault, which is printed.
bool wait_for(drive::GrblDriver& driver, LinkEventKind kind) {
  while (!interrupted())
    for (const LinkEvent& event : driver.step(DriveTimes::step)) {
      if (event.kind == kind) return true;
      if (event.kind != LinkEventKind::fault) continue;
      complain(drive::fault_text(event, 0));
      return false;
    }
  return false;
}

/// Waits for a report that is newer than this moment.
void wait_for_report(drive::GrblDriver& driver) {
  const double asked = driver.now();
  while (!interrupted() && driver.link().view().reported_at <= asked) (void)driver.step(DriveTimes::step);
}

}  // namespace

bool read_offsets(drive::GrblDriver& driver) {
  if (!driver.link().ask_offsets() || !wait_for(driver, LinkEventKind::connected)) return false;
  wait_for_report(driver);
  return driver.link().view().machine.has_value();
}

bool work_by_hand(drive::GrblDriver& driver) { return ByHand(driver).work(); }

std::unique_ptr<drive::GrblJob> continued(drive::GrblDriver& driver, const DriveProgram& program, const Continuation& how) {
  drive::GrblLink& link = driver.link();
  if (!read_offsets(driver)) return nullptr;
  drive::GrblRestartPlan plan;
  plan.line = how.line;
  plan.from = *link.view().machine;
  plan.place = how.place;
  plan.offsets_at_place = how.offsets_at_place;
  plan.keeps_offsets = how.keeps_offsets;
  plan.clear = std::max(how.clear, plan.from[2]);
  plan.spin_up = how.by_hand ? how.spin_up : 0;
  const auto restart = program.restart(link.settings(), plan);
  if (!restart) return nullptr;
  // The whole rest is executed by Kadr before the machine moves.
  const auto looked_at = program.open(link.settings(), plan.from, *restart);
  if (!looked_at) return nullptr;
  looked_at->pass_probes();
  const drive::JobNeeds needs = drive::needs_of(*looked_at, {});
  if (needs.alarm || needs.refused) {
    if (needs.alarm) program.print(*needs.alarm);
    return nullptr;
  }
  if (how.by_hand) {
    tell(translated(texts::drive_command::goes_on, restart->text.first, restart->source));
    for (const std::string& line : restart->head) tell("  " + line);
    tell(translated(texts::drive_command::ask_again));
    if (!hears_go(driver)) return nullptr;
  }
  return program.open(link.settings(), plan.from, *restart);
}

bool check_mode(drive::GrblDriver& driver, drive::GrblJob& job) {
  drive::GrblLink& link = driver.link();
  if (!run_command(driver, "$C", 1)) return false;
  wait_for_report(driver);
  bool good = link.begin_job(), done = !good;
  while (!done && !interrupted()) {
    while (link.wants_line()) {
      auto line = job.next();
      if (!line) {
        link.end_of_job();
        break;
      }
      if (line->kind == LineKind::alone && !line->probes) continue;  // Grbl writes its EEPROM in check mode too
      link.offer(std::move(*line));
    }
    for (const LinkEvent& event : driver.step(DriveTimes::key)) {
      if (event.kind == LinkEventKind::fault) {
        complain(drive::fault_text(event, 0));
        good = false;
      }
      done = done || event.kind == LinkEventKind::fault || event.kind == LinkEventKind::finished;
    }
  }
  const std::uint64_t read = link.view().accepted;
  link.stop();  // the reset ends the check mode
  if (!wait_for(driver, LinkEventKind::stopped)) return false;
  wait_for_report(driver);
  if (good && !interrupted()) tell(translated(texts::drive_command::check_passed, read));
  return good && !interrupted();
}

bool hears_go(drive::GrblDriver& driver) {
  Keyboard keyboard;
  std::optional<std::string> line;
  while (!line && !interrupted()) {
    (void)driver.step(DriveTimes::step);
    line = keyboard.line();
  }
  return line == "go";
}

}  // namespace kadr::cli
