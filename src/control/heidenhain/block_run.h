#pragma once
// BlockRun: executes one compiled block (spec/heidenhain 3 to 8, 12.1). Only src/control/heidenhain includes this file.

#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {

class BlockRun {
 public:
  BlockRun(Interpreter& m, Heidenhain& own, const KlartextBlock& read) : m_(m), own_(own), read_(read), plane_(m.modal.axes) {}

  Status run();

 private:
  using Name = std::string_view;

  Result<double> number(Name name) const;
  bool has(Name name) const { return read_.find(name) != nullptr; }
  Span where(Name name) const { return read_.find(name)->where; }

  // words that act before and behind the motion
  Status modes_before();
  Status functions(bool at_end);
  Status function_before(double code, const KlartextWord& word);
  Status function_after(double code, const KlartextWord& word);
  Status run_code(int code, Span where);
  Status hold_tip(bool on);
  Status feed_words();
  Status side_words();
  Status finish_motion();

  // motions
  Status move();
  Status target(Axes& to, AxisMask& named);
  Status polar_target(Axes& to, AxisMask& named);
  Status straight_to(const Axes& to, AxisMask named);
  Status machine_line();
  Status retract();
  Status centre();
  Status circle();
  Status around_pole(const Axes& end, AxisMask named, Turn turn, PlaneAxes plane);
  Status polar_circle();
  Status radius_circle();
  Status tangent_circle();
  Result<Turn> turn();
  Status corner_words();
  Status arc_allowed() const;
  double short_way(std::size_t axis, double to) const;
  double limited_feed(const Axes& to) const;

  // approach.cpp
  Status approach();
  Status departure();
  Result<Vec2> direction_ahead(const Axes& from);
  Status line_in_plane(Vec2 to, bool rapid);
  Status arc_in_plane(Vec2 to, Vec2 centre, Turn turn);

  // free_contour.cpp
  Status free_contour();
  Status free_line(Axes to, AxisMask named, std::optional<Vec2> ahead);
  Status free_arc(Axes to, AxisMask named, std::optional<Vec2> ahead);

  std::string path_written() const;
  Status export_locals();

  // cycle calls
  Status call_at_position();

  Interpreter& m_;
  Heidenhain& own_;
  const KlartextBlock& read_;
  PlaneAxes plane_;
  bool rapid_ = false;
  bool machine_ = false;         // M91, M92
  bool from_reference_ = false;  // M92
  bool calls_ = false;           // M99, M89
  bool untilted_ = false;        // M130
  double raised_ = 0;            // Z of CYCL CALL POS
};

}  // namespace kadr::heidenhain
