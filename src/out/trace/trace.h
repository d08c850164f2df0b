#pragma once
// TraceWriter: Steps as JSON Lines (design.md 5, tests/golden/README.md).

#include <optional>

#include "action/step.h"
#include "config/alarm_texts.h"
#include "out/trace/text_buffer.h"

namespace kadr {

/// What only some last lines have.
struct LastLine {
  std::string_view state{};  // JSON text; empty: none
  int alarm_channel = 0;     // in which the alarm arose, if not in this one
};

class TraceWriter {
 public:
  /// `points`: parts of a motion at which the trace gives intermediate points. The file stays open, it is the caller's.
  TraceWriter(std::FILE* file, const std::vector<std::string>& axes, AxisMask rotary, std::vector<double> points = {});

  /// Where there are several channels: each line names this one. They share the file: flush() before another one writes.
  ///   tells_ends  also of the codes that the control carries out itself (MachineFunction::by_control)
  void set_channel(int channel, bool tells_ends = true) { channel_ = channel, tells_ends_ = tells_ends; }
  /// What it remembers of the step before: a motion after a probe's tells how far it goes.
  bool behind_probe() const { return behind_probe_; }
  void go_on_behind_probe(bool is) { behind_probe_ = is; }
  void flush() { out_.flush(); }

  /// One line; FrameChange and ZoneChange give none. A motion that nobody has timed has no length, seconds and highest feed.
  void write(const Step& step);

  /// The last line: the state after the run, and the alarm if one stopped it.
  void finish(const Ending& ending, const LastLine& more = {});
  void finish(const Ending& ending, const AlarmReport& report, const AlarmTexts& texts, Lang lang, const LastLine& more = {});

  /// false: the file could not be written.
  bool ok() const { return out_.ok(); }
  int error() const { return out_.error(); }  // of the system

 private:
  char* put_head(char* at, std::string_view kind, const Origin& origin) const;
  char* put_axes(char* at, std::string_view key, const Axes& axes) const;
  char* put_arc(char* at, const Motion& motion) const;
  void write_motion(const Step& step, const Motion& motion);
  /// A point of a motion's way.
  struct Place {
    const Step& step;
    const Motion& motion;
    double part;
    const Axes& work;
    const Axes& machine;
  };
  char* put_vector(char* at, std::string_view key, Vec3 v) const;
  void write_space(const Place& place);
  void write_way(const Step& step, const Motion& motion);
  void write_detail(const Step& step, const Motion& motion);
  void write_time(const Motion& motion, const MotionTime& time);
  void write_points(const Step& step, const Motion& motion);
  void write_other(const Action& action);
  void write_state(const Ending& ending, const LastLine& more);

  TextBuffer out_;
  AxisRoles roles_;
  int channel_ = 0;  // 0: the only one
  bool tells_ends_ = true;
  std::vector<std::string> keys_;
  std::vector<std::string> names_;  // "X":
  std::size_t line_room_ = 0;       // characters that a head and two positions take at most
  std::vector<double> points_;
  bool behind_probe_ = false;  // the motion before was a probe's
};

}  // namespace kadr
