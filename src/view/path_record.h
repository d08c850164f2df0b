#pragma once
// PathRecord: records the path of the tool over the part for the page: turns Steps into pieces of vertices.

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
  /// `tool`: in the spindle at the start. The other parameters as in ToolWay.
  PathRecord(const AxisRoles& roles, std::shared_ptr<const MachineTree> tree, const std::optional<Axes>& apart, std::uint32_t tool);

  /// Receives each piece when it is complete; the reference is valid as long as the record.
  std::function<void(const ViewPiece&)> on_piece;

  ///   later, longer  s by which the step begins later, and takes longer, on the machine than timed
  void consume(const Step& step, double later, double longer);
  /// For a contour without times: sets the time of each vertex to the time at which its block ends on `path`.
  void take_times_of(const PathRecord& path);
  /// s at which the block with that number ends; if it does not move, the last one before it that does.
  double end_of_block(std::uint32_t number) const;
  /// Completes the current piece.
  void flush();
  /// True if the limit of vertices is reached: nothing more is recorded.
  bool is_full() const { return vertices_ >= most_vertices; }

  const std::deque<ViewPiece>& pieces() const { return pieces_; }
  std::size_t vertices() const { return vertices_; }
  /// Zero of the picture, in machine coordinates.
  Vec3 zero() const { return way_.zero().value_or(way_.present_zero()); }
  /// The box around the path, relative to the picture's zero; arcs by their chords.
  Box reach() const { return moved(all_); }
  Box cutting_reach() const { return moved(cutting_); }
  /// The joints whose positions the vertices have.
  const std::vector<PartJoint>& joints() const { return joints_; }
  /// The vertex that the tool reaches at or after an instant; nullptr if the path ends before.
  const PathVertex* at(double instant) const;
  /// Time of the vertex, s.
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
  std::vector<PartJoint> joints_;          // known from the first motion on
  std::vector<float> stand_, last_stand_;  // positions at the vertex being added, and at the one before
  std::uint32_t tool_;
  std::vector<WayPiece> ways_;
  std::deque<ViewPiece> pieces_;  // the last one is being filled, unless flushed
  bool open_ = false;
  std::size_t vertices_ = 0;
  double last_time_ = 0;
  Vec3 last_, last_direction_{0, 0, 1};
  bool begun_ = false;
  Box cutting_, all_;  // relative to the machine's zero
};

}  // namespace kadr
