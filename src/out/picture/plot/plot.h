#pragma once
// Plot: draws the tool path as a picture, SVG or PNG. The picture contains an isometric view and the three planes XY, XZ, YZ.

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
  std::string extents{};             // text that states the range of each axis while cutting, in the form of the run's summary on stdout
  LengthUnit unit = LengthUnit::mm;  // unit in which the picture states lengths
  // names of the files that contain the program lines; the key is the file number Origin::file
  std::map<std::uint16_t, std::string> files{};
  bool x_is_diameter = false;  // true: in the view of a lathe the numbers along X are diameters; the picture itself is in true lengths

  std::string_view file_of(const ProgramLine& line) const {
    const auto found = files.find(line.file);
    return found == files.end() ? std::string_view() : std::string_view(found->second);
  }
};

/// A symbol at a point of the path: its start, its end or a stop.
struct PlotMark {
  enum class What : std::uint8_t { start, end, stop } what = What::start;
  Vec3 at;
  ProgramLine line;
};

/// Processes steps in order. The picture shows the work coordinates in which the first cut is made. Motions in other work coordinates are
/// drawn at their true position on the machine. For a channel with X and Z, but no Y, as a lathe has, the picture is one view with Z to the
/// right and X upwards.
class Plot {
 public:
  Plot(const std::vector<std::string>& axes, AxisMask rotary, const ToolPosition& start);

  void consume(const Step& step);

  /// Adds an action of the programmed contour, without cutter radius compensation. The contour is drawn in addition to the tool path. The
  /// machine does not execute this action, so Plot stores the programmed position separately from that of the machine.
  void follow_programmed(const Action& action);

  /// Marks the position at which an alarm in this program line has stopped the program. Line 0 means that the alarm occurred in another
  /// channel.
  void stop(ProgramLine line);
  /// Returns the numbers (Origin::file) of the files that contain the program lines of the picture.
  const std::set<std::uint16_t>& files() const { return files_; }

  /// Colours the motions that follow by speed or by limit. From now on a motion is drawn only when its cells (short parts of the planner's
  /// plan) have arrived.
  void colour_by(PlotColour by) { shaded_.emplace(roles_, by), colour_ = by; }
  ShadedMotions& shaded() { return *shaded_; }
  void take(const TimedCells& cells, const MotionLimits& limits) { shaded_->take(cells, limits, path_); }
  /// Draws the motions whose cells have not arrived completely. Call this function after the last cell.
  void finish_cells() { shaded_->finish(path_); }

  /// Draws the picture. The ending of the file's name (.svg, .png) selects the format.
  ///   returns  an error sentence if the picture cannot be drawn
  tl::expected<void, std::string> write(const ResultFile& file, const PlotTitle& title) const;

  const PlotPath& path() const { return path_; }
  /// Returns the origins of all work coordinates in which the program has moved, in the coordinates of the picture, mm.
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
  Vec3 here_;  // end of the path that has been drawn so far
  PlotPath path_;
  ToolDirections directions_;
  std::optional<ShadedMotions> shaded_;
  PlotColour colour_ = PlotColour::stroke;
  Vec3 first_origin_;
  Vec3 shift_;  // origin of the present work coordinates minus origin of the first ones, mm
  bool origin_known_ = false;
  bool started_ = false;
  std::vector<Vec3> zeros_;
  PlotMark start_;
  ProgramLine last_line_;
  std::optional<ProgramLine> stop_;
  std::set<std::uint16_t> files_;
  ToolPosition programmed_;  // position on the programmed contour, without cutter compensation
  Vec3 programmed_origin_;
  PlotPath contour_;  // the programmed contour, in machine coordinates
  bool has_contour_ = false;
};

}  // namespace kadr
