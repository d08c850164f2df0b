#pragma once
// Plot: the path as a picture, SVG or PNG: isometric and the three planes.

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
  std::string extents{};                         // of the cutting, as the summary tells them
  LengthUnit unit = LengthUnit::mm;              // that numbers are told in
  std::map<std::uint16_t, std::string> files{};  // by Origin::file: what lines stand in

  std::string_view file_of(const ProgramLine& line) const {
    const auto found = files.find(line.file);
    return found == files.end() ? std::string_view() : std::string_view(found->second);
  }
};

/// A place of the path that has a sign of its own.
struct PlotMark {
  enum class What : std::uint8_t { start, end, stop } what = What::start;
  Vec3 at;
  ProgramLine line;
};

/// Takes Steps in order. Coordinates of the picture: the work system of the first cut; others stand where they are on the machine.
class Plot {
 public:
  Plot(const std::vector<std::string>& axes, AxisMask rotary, const ToolPosition& start);

  void consume(const Step& step);

  /// An action as programmed, before cutter radius compensation: contours are drawn beside the tool's path. No step of the machine: the
  /// programmed position is followed here.
  void take_programmed(const Action& action);

  /// The program has stopped here, by an alarm of that line; line 0: of another channel.
  void stop(ProgramLine line);
  /// Files that lines of the picture stand in, by Origin::file.
  const std::set<std::uint16_t>& files() const { return files_; }

  /// From now on motions wait for their cells, and are coloured by these.
  void colour_by(PlotColour by) { shaded_.emplace(roles_, by), colour_ = by; }
  ShadedMotions& shaded() { return *shaded_; }
  void take(const TimedCells& cells, const MotionLimits& limits) { shaded_->take(cells, limits, path_); }
  /// No cells come any more.
  void finish_cells() { shaded_->finish(path_); }

  /// Draws; the ending of the name (.svg, .png) says which.
  ///   returns  an error sentence
  tl::expected<void, std::string> write(const ResultFile& file, const PlotTitle& title) const;

  const PlotPath& path() const { return path_; }
  /// Work zeros in the picture's coordinates.
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
  Vec3 here_;  // where the path ends
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
  ToolPosition programmed_;  // beside the machine's, as there is no compensation
  Vec3 programmed_origin_;
  PlotPath contour_;  // measured from the machine's zero
  bool has_contour_ = false;
};

}  // namespace kadr
