#pragma once
// GrblMachine: a machine with a controller of the Grbl family, for a client with several threads: the operator's panel. A thread of its own
// talks to the controller (GrblDriver). Requests come from any thread; a hold or a stop is sent within a few milliseconds, whatever is
// queued.
//
//   offer(JobLine) ──▶ GrblLink ──▶ port          status() ◀── last report, its age, job, fault

#include <atomic>
#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "base/stop_token.h"
#include "base/thread.h"
#include "drive/grbl/grbl_driver.h"

namespace kadr::drive {

/// How a machine is connected.
struct GrblPlace {
  std::string port;  // as for open_port()
  int baud = 115200;
  std::string log;  // the file of the black box; empty: nothing is recorded
};

/// What is known of the machine. `view.machine` is as old as `age` says.
struct GrblStatus {
  LinkView view;
  double age = 0;                                // time since the last report, s
  double seconds_pending = 0;                    // how long the machine may still move if the connection breaks now, s
  std::uint64_t reports = 0;                     // number of reports so far
  std::uint64_t begun = 0, ended = 0;            // numbers of the last job that has begun, and that has ended
  bool stopping = false;                         // a stop has been requested, and the controller is not reset yet
  bool waits = false;                            // the job has not begun, because of a feed hold
  bool jogs = false;                             // an axis moves by hand, or may still move
  bool log_failed = false;                       // the black box cannot be written
  std::optional<LinkEvent> fault;                // the fault since the last forget_fault()
  double pending_at_fault = 0;                   // seconds_pending when it came
  std::string message;                           // the last message of the controller
  std::optional<GrblPoint> probed;               // where the last probe motion has touched
  std::uint64_t probes = 0, probed_nothing = 0;  // probe motions that have ended, and those that have touched nothing
};

/// A motion by a held key, of which the controller has a piece.
struct GrblJog {
  std::size_t axis = 0;
  double end = 0, feed = 0, next = 0;  // mm, mm/min, mm: end of the motion that was sent
  double kept_at = 0, sent_until = 0;  // now() when it was renewed last, and when the motion that was sent ends, s
  double acted_at = -1;                // GrblDriver::now() when a piece or a cancellation was sent last, s
  bool released = false, cancelled = false;
};

class GrblMachine {
 public:
  /// Opens the port, resets the controller, reads what it is, and waits for its position. Returns an error sentence if that fails.
  static tl::expected<std::unique_ptr<GrblMachine>, std::string> connect(GrblPlace place, const StopToken& stop = {});
  ~GrblMachine();
  GrblMachine(const GrblMachine&) = delete;
  GrblMachine& operator=(const GrblMachine&) = delete;

  const GrblPlace& place() const { return place_; }
  /// What the controller has answered when it was connected last.
  GrblSettings settings() const;
  GrblStatus status() const;

  /// Begins a job and returns its number. Its lines follow.
  std::uint64_t begin_job();
  void offer(JobLine line);
  void end_job();
  /// Number of lines that are offered and not sent.
  std::size_t queued() const;

  void hold();
  void resume();
  /// Ends the job or the jog: feed hold, standstill, reset of the controller, which forgets what it has in its buffers.
  void stop();
  void override_feed(int percent);
  void override_rapid(int percent);
  void override_spindle(int percent);

  /// Moves an axis towards `end` (machine coordinates, mm) at `feed` (mm/min) while keep_jogging() is called at least every `most_silence`
  /// seconds. The controller never has more than about a quarter of a second of this motion, so it ends soon if Kadr or the cable dies.
  void begin_jog(std::size_t axis, double end, double feed);
  void keep_jogging();
  void end_jog();
  static constexpr double most_silence = 0.3;

  /// Sends `$H` or `$X`.
  void home();
  void unlock();
  /// Opens the port again after it was lost. status() shows the result.
  void reconnect();
  void forget_fault();

 private:
  using Clock = std::chrono::steady_clock;
  explicit GrblMachine(GrblPlace place) : place_(std::move(place)) {}
  /// Requests of other threads, which the machine's thread passes to the link.
  struct Wanted {
    bool stop = false, hold = false, resume = false, home = false, unlock = false, reconnect = false;
    std::optional<int> feed, rapid, spindle;
  };

  tl::expected<void, std::string> open();
  void live();
  void obey();
  bool hold_back(bool waits);
  void feed_job();
  void feed_jog();
  void take(const LinkEvent& event);
  void publish();
  void end_job_now();
  double now() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  const GrblPlace place_;
  const Clock::time_point begin_ = Clock::now();
  std::unique_ptr<BlackBox> log_;
  std::unique_ptr<GrblDriver> driver_;  // only the machine's thread uses it after connect()

  mutable std::mutex lock_;  // protects what is below
  Wanted wanted_;
  std::deque<JobLine> lines_;
  bool job_ends_ = false;     // no line follows
  bool job_is_open_ = false;  // the link has begun the job
  bool job_waits_ = false;    // a feed hold came before the first line was sent
  double job_wanted_at_ = 0;  // now() when the client has begun the job, s
  std::optional<GrblJog> jog_;
  GrblStatus status_;
  GrblSettings settings_;
  double last_report_ = -1;
  Clock::time_point reported_ = Clock::now();
  std::atomic<bool> ends_{false};
  Thread thread_;
};

}  // namespace kadr::drive
