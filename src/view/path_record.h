#pragma once
// PathRecord: records the path of the tool over the part, for the page. It converts the steps of a run to segments of vertices.

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
  /// Starts a path. `tool` is the number of the tool in the spindle at the start; the other parameters are described in the class ToolPath.
  PathRecord(const AxisRoles& roles, std::shared_ptr<const MachineTree> tree, const std::optional<Axes>& apart, std::uint32_t tool);

  /// A function of the client that receives a segment of the path; PathRecord calls it when the segment is complete. The reference to the
  /// segment stays valid as long as the PathRecord exists.
  std::function<void(const ViewPiece&)> on_piece;

  /// Records a step of the run.
  ///   later   delay in s: how much later than in the time estimate the step starts on the machine
  ///   longer  extension in s: how much longer than in the time estimate the step takes on the machine
  void consume(const Step& step, double later, double longer);
  /// Sets the times of a contour that was recorded without times: each vertex gets the time at which its block ends on `path`, the path of
  /// the tool.
  void take_times_of(const PathRecord& path);
  /// Returns the time in s at which the block with the number `number` ends. A block without motion ends at the same time as the last
  /// earlier block with motion.
  double end_of_block(std::uint32_t number) const;
  /// Completes the present segment, even if the segment is not full.
  void flush();
  /// Returns true if the greatest number of vertices is reached; later steps are then not recorded.
  bool is_full() const { return vertices_ >= max_vertices; }

  const std::deque<ViewPiece>& pieces() const { return pieces_; }
  std::size_t vertices() const { return vertices_; }
  /// Returns the zero point of the picture in machine coordinates.
  Vec3 zero() const { return tool_path_.zero().value_or(tool_path_.present_origin()); }
  /// Returns the box around the path, relative to the zero point of the picture. The box contains chords instead of arcs.
  Box reach() const { return moved(all_); }
  Box cutting_reach() const { return moved(cutting_); }
  /// Returns the joints of the machine whose positions are stored with the vertices.
  const std::vector<PartJoint>& joints() const { return joints_; }
  /// Returns the first vertex that the tool reaches at or after an instant; nullptr if the path ends before the instant.
  const PathVertex* at(double instant) const;
  /// Returns the time of a vertex in s.
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
  ToolPath tool_path_;
  std::vector<PartJoint> joints_;          // joints whose positions are recorded; empty until the first motion
  std::vector<float> stand_, last_stand_;  // joint positions: at the vertex that is being added, and at the previous vertex
  std::uint32_t tool_;
  std::vector<PathSegment> segments_;
  std::deque<ViewPiece> pieces_;  // segments of the path; the last segment is not complete, except after flush()
  bool open_ = false;
  std::size_t vertices_ = 0;
  double last_time_ = 0;
  Vec3 last_, last_direction_{0, 0, 1};
  bool begun_ = false;
  Box cutting_, all_;  // boxes around the cutting motions and around the whole path, relative to the zero point of the machine
};

}  // namespace kadr
