#pragma once
// Plot: the path as a picture, SVG or PNG: isometric and the three planes.

#include <string>
#include <tl/expected.hpp>

#include "out/plot_shades.h"
#include "out/result_file.h"

namespace kadr {

struct PlotTitle {
  std::string file;
  std::string control;
  Lang lang = Lang::en;
};

/// Takes Actions in order. Coordinates of the picture: the work system of the first cut; others stand where they are on the machine.
class Plot {
 public:
  Plot(const std::vector<std::string>& axes, AxisMask rotary, const ToolPosition& start);

  void take(const Action& action);

  /// An action as programmed, before cutter radius compensation: contours are drawn beside the tool's path.
  void take_programmed(const Action& action);

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
  void take_motion(const Motion& motion);
  void take_frame(const FrameChange& frame);
  void mark_zero();
  void take_reference();
  void draw(PlotPath& path, const ToolPosition& from, const Motion& motion, Vec3 shift, Stroke stroke) const;

  AxisRoles roles_;
  ToolPosition position_;
  PlotPath path_;
  std::optional<ShadedMotions> shaded_;
  PlotColour colour_ = PlotColour::stroke;
  Vec3 first_origin_;
  Vec3 shift_;  // origin now − first origin
  bool origin_known_ = false;
  bool started_ = false;
  std::vector<Vec3> zeros_;
  ToolPosition programmed_;
  Vec3 programmed_origin_;
  PlotPath contour_;  // measured from the machine's zero
  bool has_contour_ = false;
};

}  // namespace kadr
