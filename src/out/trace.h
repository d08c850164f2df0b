#pragma once
// TraceWriter: Actions as JSON Lines (design.md 5, tests/golden/README.md).

#include "config/alarm_texts.h"
#include "out/text_buffer.h"
#include "path/curve.h"

namespace kadr {

class TraceWriter {
 public:
  /// `points`: parts of a motion at which the trace gives intermediate points. The file stays open, it is the caller's.
  TraceWriter(std::FILE* file, const std::vector<std::string>& axes, AxisMask rotary, const ToolPosition& start,
              std::vector<double> points = {});

  /// One line; FrameChange gives none.
  void write(const Action& action);

  /// The last line: the state after the run, and the alarm if one stopped it.
  void finish(const Ending& ending);
  void finish(const Ending& ending, const AlarmReport& report, const AlarmTexts& texts, Lang lang);

  /// false: the file could not be written.
  bool ok() const { return out_.ok(); }

 private:
  char* put_head(char* at, std::string_view kind, const Origin& origin) const;
  char* put_axes(char* at, std::string_view key, const Axes& axes) const;
  char* put_arc(char* at, const Motion& motion) const;
  void write_motion(const Motion& motion, const Origin& origin);
  void write_points(const Motion& motion);
  void write_other(const Action& action);
  void write_state(const Ending& ending);

  TextBuffer out_;
  AxisRoles roles_;
  std::vector<std::string> keys_;
  std::vector<std::string> names_;  // "X":
  std::vector<double> points_;
  ToolPosition position_;
};

}  // namespace kadr
