#pragma once
// MotionDialect: what a control does differently for motions, feeds and
// the spindle. One of the interfaces of a Dialect (control/dialect.h).

#include "action/action.h"
#include "base/result.h"
#include "base/vec.h"
#include "control/block/arc.h"
#include "control/control.h"

namespace kadr {

class BlockContext;
class Emitter;
struct Call;

class MotionDialect {
 public:
  virtual ~MotionDialect() = default;

  /// Computes the end point from the block's axis words.
  virtual Status target(const BlockContext& m, Axes& to, AxisMask& named) const;
  /// Returns true if the block has words that are added to its motion, such as the L of an axis corrector (offset). add_to_motion()
  /// executes these words, and returns the axes that the words move.
  virtual bool adds_to_motion(const BlockContext& m) const;
  virtual Result<AxisMask> add_to_motion(Emitter& m);
  /// Returns true if words of the block change a straight G0 or G1 motion into another path. Then straight() executes that path.
  virtual bool shapes_lines(const BlockContext& m) const;
  virtual Status straight(Emitter& m, const Call& call, MotionKind kind);
  /// Returns true if the axis words of the block only shift the start point. Then the tool does not move.
  virtual bool only_shifts(const BlockContext& m) const;
  virtual Status arc(Emitter& m, const Call& call, Turn turn);
  /// Executes a straight motion while the programmed plane is mapped to a face (G12.1) or to a cylinder (G7.1): see PathSurface.
  virtual Status surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named);
  /// Returns true if a block that has only an end point, an arc centre and a feed may be executed like the block before it, without a
  /// second check of its words, of the modes and of the dialect's data. control/block/motion_run executes such blocks.
  virtual bool lines_follow(const BlockContext&) const { return false; }
  /// Returns true if lines_follow() holds under cutter compensation too, because the contour has begun, and continues with the same tool,
  /// on the same side, in the same plane.
  virtual bool contour_follows(const BlockContext&) const { return false; }
  /// Returns the axes that are an exception from lines_follow(): a block that has a word of one of these axes is executed with all checks.
  virtual AxisMask rolling_axes(const BlockContext&) const { return 0; }
  /// Returns the rule by which arcs are computed in blocks for which lines_follow() holds.
  virtual ArcRule arc_rule(const BlockContext& m) const;
  /// Returns the arc of a block for which lines_follow() holds, from its centre or from its word R (`radius`), with all checks that the
  /// control makes of its geometry. All lengths are in mm. If the result is an alarm, the block is executed the general way, which reports
  /// the alarm. arc_of_radius() is used only if ArcRule::radius_by_words is set.
  virtual Result<PlaneArc> arc_of_center(Emitter& m, const ArcRule& rule, const ArcEnds& ends, Vec2 center) const;
  virtual Result<PlaneArc> arc_of_radius(Emitter& m, const ArcRule& rule, const ArcEnds& ends, double radius) const;
  /// Scales the numbers of a block, as read, to the unit in which the control counts: F without a decimal point, values of expressions. The
  /// interpreter calls this function before it uses the numbers of a block for which lines_follow() holds.
  virtual void count_words(BlockContext&) const {}
  /// Updates the dialect's own data after the execution of a block for which lines_follow() holds.
  virtual void note_line(BlockContext&) {}
  /// Checks that the program may move the axes `named`.
  virtual Status may_move(const BlockContext& m, AxisMask named) const;
  virtual void note_motion(Emitter& m, Motion& motion);
  /// Returns, in mm/min or degrees/min, the feed of a motion that is programmed in inches.
  virtual double inch_feed(const BlockContext& m, const Motion& motion, const Axes& from) const;
  /// Updates the dialect's own data when a feed that the block gives comes into force.
  virtual void note_feed(BlockContext& m);
  /// Returns true if the control stores the feed per minute and the feed per revolution separately. If not, a change of the feed's unit
  /// discards the feed.
  virtual bool keeps_both_feeds() const { return false; }
  /// Returns true if M3, M4, M5 of this block are for spindles other than the first one. The dialect has then emitted the commands for
  /// these spindles.
  virtual Result<bool> turns_spindle(Emitter&, SpindleDir, Span) { return false; }
  virtual SurfaceSpeed surface_speed(const BlockContext& m) const;
  /// Returns true if drilling cycles of this control only emit motions, and call no other function of the dialect.
  virtual bool drills_plainly() const { return false; }
  virtual Status accept_answer(Emitter& m, const ProbeAnswer& answer);
};

}  // namespace kadr
