#pragma once
// TraceWriter: writes Steps as JSON Lines, one object per line (tests/golden/README.md).

#include <optional>

#include "action/step.h"
#include "config/alarm_texts.h"
#include "out/trace/text_buffer.h"

namespace kadr {

/// Fields of the last line of a trace that are not always present.
struct LastLine {
  std::string_view state{};  // JSON text of the state after the run; empty: none
  int alarm_channel = 0;     // the channel in which the alarm arose, if it is another channel than this one
};

class TraceWriter {
 public:
  ///   points  fractions of a motion (0 … 1) at which the trace contains intermediate points
  /// The caller closes the file.
  TraceWriter(std::FILE* file, const std::vector<std::string>& axes, AxisMask rotary, std::vector<double> points = {});

  /// For programs of several channels: each trace line contains the channel number. The channels share the file: call flush() before
  /// another channel writes.
  ///   writes_program_ends  also writes the codes that the control executes itself (MachineFunction::by_control)
  void set_channel(int channel, bool writes_program_ends = true) { channel_ = channel, writes_program_ends_ = writes_program_ends; }
  /// True if the step before was a probe motion: the trace line of the next motion then also contains how far each axis moves.
  bool after_probe() const { return after_probe_; }
  void go_on_behind_probe(bool is) { after_probe_ = is; }
  void flush() { out_.flush(); }

  /// Writes one line; none for a FrameChange or ZoneChange. The line of a motion without a computed time has no length, seconds or highest
  /// feed.
  void write(const Step& step);

  /// Writes the last line: the state after the run, and the alarm if one stopped it.
  void finish(const FinalState& ending, const LastLine& more = {});
  void finish(const FinalState& ending, const AlarmReport& report, const AlarmTexts& texts, Lang lang, const LastLine& more = {});

  /// Returns false if the file could not be written.
  bool ok() const { return out_.ok(); }
  int error() const { return out_.error(); }  // errno of the first write error

 private:
  char* put_head(char* at, std::string_view kind, const Origin& origin) const;
  char* put_axes(char* at, std::string_view key, const Axes& axes) const;
  char* put_arc(char* at, const Motion& motion) const;
  void write_motion(const Step& step, const Motion& motion);
  /// A position on the path of a motion.
  struct Place {
    const Step& step;
    const Motion& motion;
    double part;
    const Axes& work;
    const Axes& machine;
  };
  char* put_vector(char* at, std::string_view key, Vec3 v) const;
  void write_space(const Place& place);
  void write_path(const Step& step, const Motion& motion);
  void write_detail(const Step& step, const Motion& motion);
  void write_time(const Motion& motion, const MotionTime& time);
  void write_points(const Step& step, const Motion& motion);
  void write_other(const Action& action);
  void write_state(const FinalState& ending, const LastLine& more);

  TextBuffer out_;
  AxisRoles roles_;
  int channel_ = 0;  // number of the channel in each line; 0: the program has only one channel, and no line contains a number
  bool writes_program_ends_ = true;
  std::vector<std::string> keys_;  // names of the axes as JSON keys: "X":
  std::vector<std::string> names_;
  std::size_t line_room_ = 0;  // greatest number of characters that a line head and two positions need
  std::vector<double> points_;
  bool after_probe_ = false;  // the previous motion was a probe motion
};

}  // namespace kadr
