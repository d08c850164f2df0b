#pragma once
// PathRecord: records the path of the tool over the part, for the page. It converts the steps of a run to pieces of vertices.

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "kinematics/part_joints.h"
#include "out/text/extents.h"
#include "session/cutting/tool_path.h"
#include "view/path_piece.h"

namespace kadr {

class PathRecord {
 public:
  /// `tool`: number of the tool in the spindle at the start. The other parameters are those of ToolPath.
  PathRecord(const AxisRoles& roles, std::shared_ptr<const MachineTree> tree, const std::optional<Axes>& apart, std::uint32_t tool);

  /// Receives each piece when it is complete. The reference is valid as long as this object.
  std::function<void(const ViewPiece&)> on_piece;

  ///   later   s by which the step starts later on the machine than was computed
  ///   longer  s by which the step takes longer on the machine than was computed
  void consume(const Step& step, double later, double longer);
  /// For a contour that was recorded without times: gives each vertex the time at which its block ends on `path`.
  void take_times_of(const PathRecord& path);
  /// Returns the time, s, at which the block with that number ends. If the block does not move, this is the end of the last block before
  /// it that does.
  double end_of_block(std::uint32_t number) const;
  /// Completes the current piece, although it is not full.
  void flush();
  /// True if the maximum number of vertices is reached and nothing more is recorded.
  bool is_full() const { return vertices_ >= max_vertices; }

  const std::deque<ViewPiece>& pieces() const { return pieces_; }
  std::size_t vertices() const { return vertices_; }
  /// Zero point of the picture, in machine coordinates.
  Vec3 zero() const { return way_.zero().value_or(way_.present_origin()); }
  /// The box around the path, relative to the zero point of the picture. Arcs count by their chords.
  Box reach() const { return moved(all_); }
  Box cutting_reach() const { return moved(cutting_); }
  /// The joints of the machine whose positions are stored with the vertices.
  const std::vector<PartJoint>& joints() const { return joints_; }
  /// Returns the first vertex that the tool reaches at or after an instant; nullptr if the path ends before.
  const PathVertex* at(double instant) const;
  /// Returns the time of a vertex, s.
  static double time_of(const ViewPiece& piece, const PathVertex& vertex) { return piece.begins + double(vertex.time); }

 private:
  static constexpr std::size_t max_vertices = 20'000'000;
  void add(const PathVertex& vertex, Vec3 at, Vec3 direction, double time);
  void begin_piece();
  void stand_at(const Step& step, double part);
  void turn_on_the_spot(const Step& step);
  void note_reach(const Motion& motion);
  Box moved(Box box) const;

  AxisRoles roles_;
  std::shared_ptr<const MachineTree> tree_;
  ToolPath way_;
  std::vector<PartJoint> joints_;          // empty until the first motion
  std::vector<float> stand_, last_stand_;  // joint positions at the vertex that is being added, and at the previous vertex
  std::uint32_t tool_;
  std::vector<PathSegment> ways_;
  std::deque<ViewPiece> pieces_;  // the last piece is being filled, unless it was flushed
  bool open_ = false;
  std::size_t vertices_ = 0;
  double last_time_ = 0;
  Vec3 last_, last_direction_{0, 0, 1};
  bool begun_ = false;
  Box cutting_, all_;  // boxes relative to the zero point of the machine
};

}  // namespace kadr
