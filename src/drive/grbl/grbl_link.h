#pragma once
// GrblLink: the conversation with a controller of the Grbl family, as a state machine without clock and without input or output. Bytes
// and times come in, bytes and events go out, so a test can run a day in a second and a fuzzer can feed it anything.
//
//   bytes, time ──▶ GrblLink ──▶ bytes to send: real-time bytes first, then whole lines that the controller has space for
//                        └─────▶ events: connected, faults, stops, finished
//
// What it guarantees:
//   - a line of the job is never sent twice, and never left out;
//   - no line is sent unless the controller's receive buffer has space for it (character counting, docs/drive.md);
//   - after a fault, a hold or a stop no line is sent until the caller resumes (hold) or begins a new job;
//   - the shown state is the last one that the controller reported.

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drive/grbl/grbl_reply.h"
#include "drive/grbl/grbl_settings.h"
#include "drive/grbl/job_line.h"
#include "drive/grbl/line_tracker.h"

namespace kadr::drive {

struct LinkOptions {
  bool resets = true;             // true: a controller that sends no banner is reset, so that its state is known; false: only listen
  double report_every = 0.2;      // time between two requests for a status report, s (Grbl advises 5 to 10 Hz at most)
  double silence = 1.5;           // time without any byte after which the connection counts as lost, s
  double banner_wait = 2.5;       // time to wait for the banner of a board that resets itself when the port is opened, s
  double answer_wait = 2;         // time, in addition to that of the motions, after which an answer counts as lost, s
  double off_path = 0.05;         // greatest distance of a reported position from the path, mm
  std::size_t buffer = 127;       // usable bytes of the receive buffer, until the controller states its own number
  std::size_t ahead = 64;         // most lines that are kept in the link before they are sent
  double most_seconds_ahead = 0;  // most time of motion that is sent in advance, s; 0: no limit besides the buffers
  // Characters per second that the line carries; 0: not known. A line is sent only when the line has carried nearly everything before it:
  // a real-time command cannot overtake what lies in the operating system's driver.
  double line_rate = 0;
};

enum class LinkPhase : std::uint8_t {
  closed,
  opening,   // waits for the banner
  asking,    // reads $I, $$, $#, $G
  ready,     // connected, no job
  running,   // a job is sent
  waiting,   // the job is at a stop (M0, M6), everything before it is executed, and the operator has to continue it
  held,      // feed hold by the operator, or by the controller itself
  stopping,  // waits for standstill, then resets
  faulted,   // a fault ended the job
  lost,      // no connection
};
std::string_view name_of(LinkPhase phase);

/// Why a job ended, or could not begin.
enum class LinkFault : std::uint8_t {
  no_answer,      // no banner and no report after opening
  busy,           // the controller moves, or is held, by somebody else's command
  line_refused,   // error:N to a line of the job; `number` is N
  setup_refused,  // error:N to $I, $$, $#, $G
  alarm,          // ALARM:N; `number` is N
  reset,          // the controller has restarted by itself
  answer_lost,    // a line was not answered in the time that its motions need
  broken_answer,  // bytes that are no answer
  extra_answer,   // an answer to nothing, so the count of the buffer is wrong
  buffer_wrong,   // the controller reports more bytes in its buffer than were sent
  overdue,        // everything is answered, and the motion has not ended in the time that it needs
  off_path,       // the reported position is not on the path of the job; `value` is the distance, mm
  silent,         // no bytes for some time
  port_lost,      // the port reported an error: a cable was unplugged
};
std::string_view name_of(LinkFault fault);

enum class LinkEventKind : std::uint8_t {
  connected,     // the controller is known and idle, or in an alarm
  fault,         //
  held,          // the controller reports a hold or an open door
  resumed,       //
  stop_reached,  // the job is at a stop of the program, and everything before it is executed
  finished,      // all lines of the job are executed
  stopped,       // the controller was reset after stop()
  answered,      // the answer to command(); `number` is the error, 0 for `ok`
  message,       // a message of the controller, `text`
  probed,        // the result of a probe motion; `point` is empty if it touched nothing
};

struct LinkEvent {
  LinkEventKind kind = LinkEventKind::connected;
  LinkFault fault = LinkFault::no_answer;
  int number = 0;                    // number of the error or alarm
  std::uint32_t line = 0;            // program line that the event is about; 0: none
  std::string text;                  // what the controller sent, or the text of the line
  double value = 0;                  // distance, mm
  bool changes_tool = false;         // the stop is a tool change
  std::optional<GrblPoint> point{};  // what the probe touched, machine coordinates
};

/// What is known of the controller.
struct LinkView {
  LinkPhase phase = LinkPhase::closed;
  GrblState state = GrblState::unknown;
  int substate = 0;
  std::optional<GrblPoint> machine;  // last reported position, mm, machine coordinates
  double reported_at = 0;            // when the last report came, s; the position is at least `now` − this old
  std::optional<GrblFree> free;
  GrblOverrides overrides;
  double feed = 0, speed = 0;  // present feed, mm/min, and spindle speed, rev/min
  std::string pins;
  std::string version;
  std::uint64_t sent = 0, accepted = 0, executed = 0;  // lines of the job
  std::optional<std::uint32_t> line;                   // program line on which the tool is
  std::size_t bytes_in_flight = 0;                     // sent and not answered
};

class GrblLink {
 public:
  explicit GrblLink(const LinkOptions& options) : options_(options), tracker_(options.off_path) {}

  /// The port has been opened. `now`: seconds, from any origin; it never decreases between calls.
  void open(double now);
  /// Bytes have come. Any bytes are accepted.
  void receive(std::string_view bytes, double now);
  /// Time has passed. To be called at least every 50 ms.
  void tick(double now);
  /// The port reported an error.
  void port_lost();

  /// Begins a job. The lines follow by offer(); end_of_job() says that no line follows. If the controller is in its check mode ($C), it
  /// only reads the lines: nothing moves, and stops are passed over.
  ///   returns  false if the phase is not `ready`, or the controller is neither idle nor in its check mode
  bool begin_job();
  /// True if the job can accept a further line now.
  bool wants_line() const { return is_job_open_ && queue_.size() < options_.ahead; }
  /// Adds a line to the job; ignored if wants_line() is false.
  void offer(JobLine line);
  void end_of_job() { job_ended_ = true; }

  /// Sends a line outside of a job, such as `$X`, `$H` or a jog. The answer comes as an event.
  ///   patience  time that the line may need, s
  ///   returns   false if the phase is not `ready`, or a line is not answered yet
  bool command(const std::string& text, double patience);
  /// Reads the offsets and the modes again ($#, $G), after something was set by hand. The event `connected` follows.
  ///   returns   false as command() does
  bool ask_offsets();
  /// Sets the feed override, 10 to 200 %, by the steps that the controller knows; and that of rapids: 100, 50 or 25 %.
  void override_feed(int percent);
  void override_rapid(int percent);
  /// Sets the override of the spindle, 10 to 200 %.
  void override_spindle(int percent);
  /// Cancels a jog (real-time command 0x85).
  void cancel_jog() { urgent_ += '\x85'; }

  /// Feed hold. Acts at once, from any phase, and may be repeated.
  void hold();
  /// Continues after a hold, or after a stop of the program. Ignored in all other phases.
  void resume();
  /// Ends the job at the stop of the program at which it waits, so that the operator can move the machine. Returns false if it does not
  /// wait.
  bool end_at_stop();
  /// Ends the job: feed hold, standstill, reset of the controller. May be repeated.
  void stop();

  /// Returns bytes to send, and forgets them: all waiting real-time bytes, or one line. Empty if there is nothing to send.
  std::string take_output();
  std::vector<LinkEvent> take_events() { return std::exchange(events_, {}); }
  const LinkView& view() const { return view_; }
  const GrblSettings& settings() const { return settings_; }
  double seconds_pending() const { return tracker_.seconds_pending(); }
  /// Number of lines that are kept for the controller and for the executed line. It has a limit that does not depend on the job's length.
  std::size_t lines_kept() const { return queue_.size() + in_flight_.size() + tracker_.pending(); }

 private:
  struct Sent {
    std::size_t bytes;
    std::uint32_t number;
    std::string text;
    bool is_job;
    double patience = 0;  // time that the line may need besides the motions of the job, s
  };

  void line(std::string_view text);
  void answer(std::optional<int> error);
  void job_answer(const Sent& sent, std::optional<int> error);
  void report(const GrblReport& report);
  void job_report();
  void bracket(const GrblBracket& bracket);
  void banner(const GrblBanner& banner);
  void alarm(int code);
  void unknown(const std::string& text);

  void ask_next();
  void pump();
  bool is_line_free() const;
  bool waits_for_rest() const;
  void send_line(Sent sent);
  void override_by(char whole, int percent);
  void fault(LinkFault fault, int number = 0, std::uint32_t line = 0, std::string text = {}, double value = 0);
  void end_job();
  void note(LinkEventKind kind, std::uint32_t line = 0, std::string text = {});
  void check_times();
  void check_stopping();
  void ask_report();
  bool is_all_executed() const;
  bool is_at_work() const;

  LinkOptions options_;
  LinkView view_;
  GrblSettings settings_;
  LineTracker tracker_;
  double now_ = 0;
  std::string partial_;             // received bytes of an unfinished line
  std::string urgent_;              // real-time bytes to send
  std::deque<std::string> output_;  // lines to send, with their ends
  std::deque<Sent> in_flight_;      // lines that are sent and not answered
  std::deque<JobLine> queue_;       // lines of the job that are not sent yet
  bool is_job_open_ = false;        // the job accepts lines
  bool job_ended_ = false;          // no further line follows
  bool only_checks_ = false;        // the controller is in its check mode
  bool waits_for_hold_ = false;     // `!` was sent, and no report has shown the hold yet
  std::size_t question_ = 0;        // index of the question that is being asked
  double opened_at_ = 0, heard_at_ = 0, asked_at_ = 0, progress_at_ = 0, stopping_at_ = 0, resumed_at_ = 0;
  double answered_at_ = 0;      // when the last line was answered, s
  double line_busy_until_ = 0;  // when the line will have carried everything that was sent, s
  bool report_asked_ = false;   // a report is requested and has not come
  bool reset_sent_ = false;
  bool is_alone_ = false;            // nothing may follow the last sent line before its answer
  int idle_reports_ = 0;             // consecutive reports, since the last answer, of a controller that has nothing to do
  std::uint64_t stops_passed_ = 0;   // stops of the job that the operator has continued
  std::optional<GrblPoint> offset_;  // last reported difference between machine and work position
  std::vector<LinkEvent> events_;
};

}  // namespace kadr::drive
