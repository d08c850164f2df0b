#pragma once
// TraceWriter: writes steps as JSON Lines, one object per line (tests/golden/README.md).

#include <optional>

#include "action/step.h"
#include "config/alarm_texts.h"
#include "out/trace/text_buffer.h"

namespace kadr {

/// Fields that the last line of a trace contains only in some cases.
struct LastLine {
  std::string_view state{};  // state after the run as JSON text; empty: the field is omitted
  int alarm_channel = 0;     // number of the channel that raised the alarm, if it is not this channel
};

class TraceWriter {
 public:
  /// Writes to `file`, which the caller closes later.
  ///   points  fractions (0 to 1) of a motion at which the trace contains intermediate points
  TraceWriter(std::FILE* file, const std::vector<std::string>& axes, AxisMask rotary, std::vector<double> points = {});

  /// Sets the channel number that each trace line contains, for programs with several channels. All channels write to the same file, so
  /// flush() must be called before another channel writes.
  ///   writes_program_ends  true: the trace also contains the codes that the control executes itself (MachineFunction::by_control)
  void set_channel(int channel, bool writes_program_ends = true) { channel_ = channel, writes_program_ends_ = writes_program_ends; }
  /// True if the previous step was a probe motion. Then the trace line of the next motion also contains how far each axis moves.
  bool after_probe() const { return after_probe_; }
  void continue_after_probe(bool is) { after_probe_ = is; }
  void flush() { out_.flush(); }

  /// Writes the line of a step. A FrameChange or ZoneChange has no line. The line of a motion without a computed time contains no length,
  /// no seconds and no highest feed.
  void write(const Step& step);

  /// Writes the last line: the state after the run, and the alarm if an alarm stopped the run.
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
  int channel_ = 0;  // channel number in each line; 0: the program has only one channel, so lines contain no number
  bool writes_program_ends_ = true;
  std::vector<std::string> keys_;  // names of the axes as JSON keys, e.g. "X":
  std::vector<std::string> names_;
  std::size_t line_room_ = 0;  // greatest number of characters that the beginning of a trace line and two positions need
  std::vector<double> points_;
  bool after_probe_ = false;  // true: the previous motion was a probe motion
};

}  // namespace kadr
