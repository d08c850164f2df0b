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

  /// Receives each piece of the path when the piece is complete. The reference stays valid as long as this object exists.
  std::function<void(const ViewPiece&)> on_piece;

  /// Consumes a step of the run.
  ///   later   s by which the step starts later on the machine than the time estimate says
  ///   longer  s by which the step takes longer on the machine than the time estimate says
  void consume(const Step& step, double later, double longer);
  /// For a contour that was recorded without times: gives each vertex the time at which its block ends on `path`, the path of the tool.
  void take_times_of(const PathRecord& path);
  /// Returns the time, s, at which the block with that number ends. For a block without motion this is the end of the last block with
  /// motion before it.
  double end_of_block(std::uint32_t number) const;
  /// Completes the present piece, even if it is not full.
  void flush();
  /// True if the greatest number of vertices is reached. Nothing more is recorded then.
  bool is_full() const { return vertices_ >= max_vertices; }

  const std::deque<ViewPiece>& pieces() const { return pieces_; }
  std::size_t vertices() const { return vertices_; }
  /// Zero point of the picture, in machine coordinates.
  Vec3 zero() const { return way_.zero().value_or(way_.present_origin()); }
  /// Returns the box around the path, relative to the zero point of the picture. Chords replace arcs.
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
  std::vector<float> stand_, last_stand_;  // joint positions: at the vertex that is being added; at the previous vertex
  std::uint32_t tool_;
  std::vector<PathSegment> ways_;
  std::deque<ViewPiece> pieces_;  // the last piece is being filled, except after flush()
  bool open_ = false;
  std::size_t vertices_ = 0;
  double last_time_ = 0;
  Vec3 last_, last_direction_{0, 0, 1};
  bool begun_ = false;
  Box cutting_, all_;  // boxes relative to the zero point of the machine
};

}  // namespace kadr
