#pragma once
// PathRecord: the way of the tool over the part, kept for the page: from Steps to pieces of vertices.

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "kinematics/part_joints.h"
#include "out/text/extents.h"
#include "session/cutting/tool_way.h"
#include "view/path_piece.h"

namespace kadr {

class PathRecord {
 public:
  /// `tool`: in the spindle at the start. The rest as of ToolWay.
  PathRecord(const AxisRoles& roles, std::shared_ptr<const MachineTree> tree, const std::optional<Axes>& apart, std::uint32_t tool);

  /// Gets each piece when it is complete; the reference holds until the record goes.
  std::function<void(const ViewPiece&)> on_piece;

  ///   later, longer  s that the step begins later and takes longer on the machine than it was timed
  void consume(const Step& step, double later, double longer);
  /// Of a contour that nobody has timed: each vertex gets the time of its block's end on the path.
  void take_times_of(const PathRecord& path);
  /// s at which the block of that number ends, or the last one before it that moves.
  double end_of_block(std::uint32_t number) const;
  /// What has come so far is a piece.
  void flush();
  /// A vertex more would be too many: nothing more is kept.
  bool is_full() const { return vertices_ >= most_vertices; }

  const std::deque<ViewPiece>& pieces() const { return pieces_; }
  std::size_t vertices() const { return vertices_; }
  /// Where the picture's zero is, machine coordinates.
  Vec3 zero() const { return way_.zero().value_or(way_.present_zero()); }
  /// What the path reaches, from the picture's zero; arcs by their chords.
  Box reach() const { return moved(all_); }
  Box cutting_reach() const { return moved(cutting_); }
  /// Whose positions the vertices have.
  const std::vector<PartJoint>& joints() const { return joints_; }
  /// The vertex at which the tool arrives at or after an instant; nullptr: the path is over before.
  const PathVertex* at(double instant) const;
  /// Its time, s.
  static double time_of(const ViewPiece& piece, const PathVertex& vertex) { return piece.begins + double(vertex.time); }

 private:
  static constexpr std::size_t most_vertices = 20'000'000;
  void add(const PathVertex& vertex, Vec3 at, Vec3 direction, double time);
  void begin_piece();
  void stand_at(const Step& step, double part);
  void turn_on_the_spot(const Step& step);
  void note_reach(const Motion& motion);
  Box moved(Box box) const;

  AxisRoles roles_;
  std::shared_ptr<const MachineTree> tree_;
  ToolWay way_;
  std::vector<PartJoint> joints_;          // from the first motion on
  std::vector<float> stand_, last_stand_;  // where they are at the vertex that is added, at the one before
  std::uint32_t tool_;
  std::vector<WayPiece> ways_;
  std::deque<ViewPiece> pieces_;  // the last one is being filled, unless flushed
  bool open_ = false;
  std::size_t vertices_ = 0;
  double last_time_ = 0;
  Vec3 last_, last_direction_{0, 0, 1};
  bool begun_ = false;
  Box cutting_, all_;  // from the machine's zero
};

}  // namespace kadr
