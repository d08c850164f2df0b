#pragma once
// Plot: draws the tool path as a picture, SVG or PNG: an isometric view and the three planes XY, XZ, YZ.

#include <map>
#include <set>
#include <string>
#include <tl/expected.hpp>

#include "kinematics/chain.h"
#include "out/picture/plot/plot_shades.h"
#include "out/picture/tool_directions.h"
#include "out/trace/result_file.h"

namespace kadr {

struct PlotTitle {
  std::string file;
  std::string control;
  Lang lang = Lang::en;
  std::string extents{};                         // text: the range of each axis while cutting, as in the summary
  LengthUnit unit = LengthUnit::mm;              // the unit in which lengths are printed
  std::map<std::uint16_t, std::string> files{};  // names of the files that program lines are in, by Origin::file

  std::string_view file_of(const ProgramLine& line) const {
    const auto found = files.find(line.file);
    return found == files.end() ? std::string_view() : std::string_view(found->second);
  }
};

/// A symbol at a point of the path (start, end, stop).
struct PlotMark {
  enum class What : std::uint8_t { start, end, stop } what = What::start;
  Vec3 at;
  ProgramLine line;
};

/// Consumes Steps in order. The picture uses the coordinates of the work system in which the first cut is made. Motions in other work
/// systems are drawn at their true position on the machine.
class Plot {
 public:
  Plot(const std::vector<std::string>& axes, AxisMask rotary, const ToolPosition& start);

  void consume(const Step& step);

  /// Adds an action as programmed, before cutter radius compensation: the programmed contour is drawn in addition to the tool path. The
  /// machine does not execute this action; Plot tracks the programmed position separately from the machine's.
  void follow_programmed(const Action& action);

  /// Marks the position where an alarm in that line has stopped the program; line 0: the alarm arose in another channel.
  void stop(ProgramLine line);
  /// Numbers (Origin::file) of the files that contain the program lines of the picture.
  const std::set<std::uint16_t>& files() const { return files_; }

  /// Colours the motions that follow by speed or by limit. A motion is drawn when its cells (short parts of the planner's plan) have
  /// arrived.
  void colour_by(PlotColour by) { shaded_.emplace(roles_, by), colour_ = by; }
  ShadedMotions& shaded() { return *shaded_; }
  void take(const TimedCells& cells, const MotionLimits& limits) { shaded_->take(cells, limits, path_); }
  /// Draws the motions that are still waiting; call it after the last cell.
  void finish_cells() { shaded_->finish(path_); }

  /// Draws the picture; the ending of the file's name (.svg, .png) selects the format.
  ///   returns  an error sentence
  tl::expected<void, std::string> write(const ResultFile& file, const PlotTitle& title) const;

  const PlotPath& path() const { return path_; }
  /// Origins of all work systems in which motions took place, in the picture's coordinates.
  const std::vector<Vec3>& zeros() const { return zeros_; }

 private:
  void take_motion(const Step& step, const Motion& motion);
  std::vector<PlotMark> marks() const;
  void take_frame(const FrameChange& frame);
  void mark_zero();
  void take_reference();
  void draw(PlotPath& path, const Step& step, Vec3 shift, Stroke stroke, ProgramLine line) const;

  AxisRoles roles_;
  Chain chain_;
  Vec3 here_;  // end of the path so far
  PlotPath path_;
  ToolDirections directions_;
  std::optional<ShadedMotions> shaded_;
  PlotColour colour_ = PlotColour::stroke;
  Vec3 first_origin_;
  Vec3 shift_;  // origin of the present work system − origin of the first one
  bool origin_known_ = false;
  bool started_ = false;
  std::vector<Vec3> zeros_;
  PlotMark start_;
  ProgramLine last_line_;
  std::optional<ProgramLine> stop_;
  std::set<std::uint16_t> files_;
  ToolPosition programmed_;  // position along the programmed contour, without compensation
  Vec3 programmed_origin_;
  PlotPath contour_;  // programmed contour, in machine coordinates
  bool has_contour_ = false;
};

}  // namespace kadr
