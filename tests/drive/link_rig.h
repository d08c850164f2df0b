#pragma once
// LinkRig: a GrblLink and a GrblDouble with a serial line between them, on one simulated clock, with faults that a test injects.

#include <functional>
#include <random>
#include <set>

#include "drive/grbl/grbl_link.h"
#include "drive/grbl_double.h"
#include "drive/wire.h"

namespace kadr::drive::test {

enum class Injected : std::uint8_t {
  nothing,
  lost_from,      // a byte from the controller is lost
  changed_from,   // a byte from the controller is changed
  doubled_from,   // a byte from the controller comes twice
  lost_to,        // a byte to the controller is lost
  changed_to,     // a byte to the controller is changed
  cut,            // the cable is pulled: no byte goes either way
  deaf,           // bytes from the controller no longer arrive
  reset,          // the controller restarts
  limit,          // a limit switch
  door,           // the safety door
  garbage,        // a burst of random bytes from the controller
  lost_answer,    // a whole answer from the controller is lost
  mute_a_while,   // nothing from the controller arrives for some time
  no_probe,       // the probe touches nothing
  hold_button,    // somebody presses feed hold at the machine, and cycle start later
  operator_hold,  // the operator of Kadr holds, and resumes later
  operator_stop,  // the operator of Kadr stops the job
  count
};

class LinkRig {
 public:
  explicit LinkRig(const LinkOptions& options = {}) : link(options) { link.open(0); }

  GrblLink link;
  GrblDouble machine;
  Wire to_machine, from_machine;
  std::vector<LinkEvent> events;
  std::vector<std::string> sent_lines;  // what the link sent, without real-time bytes
  bool is_cut = false, is_deaf = false;
  std::function<char(char)> change_to, change_from;  // change one byte each; 0: the byte is lost

  void tick() {
    machine.advance();
    const double now = machine.now;
    while (const auto byte = to_machine.next(now)) {
      const char got = change_to ? change_to(*byte) : *byte;
      if (!is_cut && got != 0) machine.receive(got);
    }
    from_machine.send(machine.take_output(), now);
    std::string got;
    while (const auto byte = from_machine.next(now)) {
      const char changed = change_from ? change_from(*byte) : *byte;
      if (!is_cut && !is_deaf && changed != 0) got += changed;
    }
    if (!got.empty()) link.receive(got, now);
    if (++ticks_ % 5 == 0) link.tick(now);
    for (std::string bytes = link.take_output(); !bytes.empty(); bytes = link.take_output()) {
      if (bytes.back() == '\n') sent_lines.push_back(bytes.substr(0, bytes.size() - 1));
      to_machine.send(bytes, now);
    }
    for (LinkEvent& event : link.take_events()) events.push_back(std::move(event));
  }
  void run(double seconds) {
    for (const double end = machine.now + seconds; machine.now < end;) tick();
  }
  /// Runs until an event of this kind has come. Returns nullptr if it does not come in time.
  const LinkEvent* until(LinkEventKind kind, double seconds) {
    for (const double end = machine.now + seconds; machine.now < end;) {
      for (; seen_ < events.size(); ++seen_)
        if (events[seen_].kind == kind) return &events[seen_++];
      tick();
    }
    return nullptr;
  }
  void forget_events() {
    events.clear();
    seen_ = 0;
  }
  bool connect() { return until(LinkEventKind::connected, 10) != nullptr && settle(); }
  /// Waits for a report after connecting.
  bool settle() {
    run(0.5);
    return link.view().state == GrblState::idle;
  }
  /// Runs a whole job, offering its lines as the link asks for them. Returns the event that ended it, nullptr after `seconds`.
  const LinkEvent* work(const std::vector<JobLine>& job, double seconds, const std::function<void()>& each = {}) {
    if (!link.begin_job()) return nullptr;
    std::size_t next = 0;
    for (const double end = machine.now + seconds; machine.now < end;) {
      while (next < job.size() && link.wants_line()) link.offer(job[next++]);
      if (next == job.size()) link.end_of_job();
      tick();
      if (each) each();
      for (; seen_ < events.size(); ++seen_) {
        const LinkEvent& event = events[seen_];
        if (event.kind == LinkEventKind::stop_reached) link.resume();
        if (event.kind == LinkEventKind::fault || event.kind == LinkEventKind::finished || event.kind == LinkEventKind::stopped)
          return &events[seen_++];
      }
    }
    return nullptr;
  }

 private:
  std::size_t ticks_ = 0, seen_ = 0;
};

/// Makes a job of random lines: motions, dwells, codes and stops; every text is unique.
inline std::vector<JobLine> random_job(std::mt19937& random, std::size_t lines) {
  const auto any = [&](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
  std::vector<JobLine> job;
  GrblPoint at{};
  std::uint32_t number = 0;
  job.push_back({"G21G90G94G1F3000", ++number, LineKind::plain, 0, {}});
  while (job.size() < lines) {
    JobLine line;
    line.number = ++number;
    const int kind = any(0, 19);
    if (kind == 0) {
      line.text = fmt::format("G4P0.{:02}", any(1, 9));
      line.seconds = 0.1;
    } else if (kind == 1) {
      line.text = fmt::format("M3S{}", any(1, 1000));
    } else if (kind == 2) {
      line.text = fmt::format("G10L2P2X{}", number);
      line.kind = LineKind::alone;
      line.seconds = 0.05;
    } else if (kind == 4 && number % 3 == 0) {
      GrblPoint to = at;
      to[2] = std::round(to[2] * 1000 - any(100, 2000)) / 1000;
      line.text = fmt::format("G38.2F600Z{:.3f}", to[2]);
      line.kind = LineKind::alone;
      line.path = {at, to};
      line.seconds = (at[2] - to[2]) / 10;
      job.push_back(line);
      // the modes of the double: a probe motion leaves its feed, and the next line is absolute
      line.text = fmt::format("G1F3000Z{:.3f}", at[2]);
      line.number = ++number;
      line.kind = LineKind::plain;
      line.path = {to, at};
      line.seconds = (at[2] - to[2]) / 50;
    } else if (kind == 3 && number % 5 == 0) {
      line.text = "M0";
      line.kind = LineKind::stop;
    } else {
      GrblPoint to = at;
      const int axis = any(0, 2);
      const int reach = any(0, 3) == 0 ? 20000 : 500;
      to[static_cast<std::size_t>(axis)] = std::round(at[static_cast<std::size_t>(axis)] * 1000 + any(-reach, reach)) / 1000;
      line.text = fmt::format("N{}G1X{:.3f}Y{:.3f}Z{:.3f}", number, to[0], to[1], to[2]);
      double length = 0;
      for (std::size_t i = 0; i < 3; ++i) length = std::hypot(length, to[i] - at[i]);
      line.seconds = length / 50;
      if (length > 0) line.path = {at, to};
      at = to;
    }
    job.push_back(std::move(line));
  }
  return job;
}

}  // namespace kadr::drive::test
