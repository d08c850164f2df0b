#pragma once
// Plot: draws the path as a picture, SVG or PNG, in an isometric view and three planes.

#include <map>
#include <set>
#include <string>
#include <tl/expected.hpp>

#include "kinematics/chain.h"
#include "out/picture/plot_shades.h"
#include "out/picture/tool_directions.h"
#include "out/trace/result_file.h"

namespace kadr {

struct PlotTitle {
  std::string file;
  std::string control;
  Lang lang = Lang::en;
  std::string extents{};                         // of the cutting, as in the summary
  LengthUnit unit = LengthUnit::mm;              // in which numbers are shown
  std::map<std::uint16_t, std::string> files{};  // by Origin::file: the files that lines are in

  std::string_view file_of(const ProgramLine& line) const {
    const auto found = files.find(line.file);
    return found == files.end() ? std::string_view() : std::string_view(found->second);
  }
};

/// A point of the path with a symbol of its own.
struct PlotMark {
  enum class What : std::uint8_t { start, end, stop } what = What::start;
  Vec3 at;
  ProgramLine line;
};

/// Consumes Steps in order. The picture's coordinates are the work system of the first cut; other systems are at their true position on the
/// machine.
class Plot {
 public:
  Plot(const std::vector<std::string>& axes, AxisMask rotary, const ToolPosition& start);

  void consume(const Step& step);

  /// An action as programmed, before cutter radius compensation: programmed contours are drawn in addition to the tool's path. It is not a
  /// step of the machine; the programmed position is followed separately.
  void take_programmed(const Action& action);

  /// The program has stopped here, by an alarm of that line; line 0: an alarm of another channel.
  void stop(ProgramLine line);
  /// The files that lines of the picture are in, by Origin::file.
  const std::set<std::uint16_t>& files() const { return files_; }

  /// From now on motions wait for their cells, which give them their colour.
  void colour_by(PlotColour by) { shaded_.emplace(roles_, by), colour_ = by; }
  ShadedMotions& shaded() { return *shaded_; }
  void take(const TimedCells& cells, const MotionLimits& limits) { shaded_->take(cells, limits, path_); }
  /// No more cells follow.
  void finish_cells() { shaded_->finish(path_); }

  /// Draws the picture; the ending of the file's name (.svg, .png) selects the format.
  ///   returns  an error sentence
  tl::expected<void, std::string> write(const ResultFile& file, const PlotTitle& title) const;

  const PlotPath& path() const { return path_; }
  /// Origins of the work systems in the picture's coordinates.
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
  Vec3 here_;  // the end of the path so far
  PlotPath path_;
  ToolDirections directions_;
  std::optional<ShadedMotions> shaded_;
  PlotColour colour_ = PlotColour::stroke;
  Vec3 first_origin_;
  Vec3 shift_;  // origin now − first origin
  bool origin_known_ = false;
  bool started_ = false;
  std::vector<Vec3> zeros_;
  PlotMark start_;
  ProgramLine last_line_;
  std::optional<ProgramLine> stop_;
  std::set<std::uint16_t> files_;
  ToolPosition programmed_;  // followed next to the machine's position, as if there were no compensation
  Vec3 programmed_origin_;
  PlotPath contour_;  // measured from the machine origin
  bool has_contour_ = false;
};

}  // namespace kadr
