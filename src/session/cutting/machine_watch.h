#pragma once
// MachineWatch: moves the machine's solid bodies with the steps of a run. It finds collisions of these bodies with each other and with
// fixtures, blank and tool.
//
//   Step ─▶ positions of the axes, segment by segment ─▶ MovingBodies ─▶ BodyMeeting ─▶ CutFinding (`machine`)
//
// Collisions of the tool with blank and fixtures are reported by the stock instead. The work coordinates of the blank become known at the
// first motion at feed. Earlier steps are stored until then.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "session/cutting/cutting.h"
#include "stock/bodies/moving_bodies.h"
#include "stock/mesh/mesh.h"

namespace kadr {

/// A blank or fixture as a body for the collision check.
struct WorkBody {
  std::string name;
  BodyShape shape;
  const Mesh* mesh = nullptr;  // mesh of the body; nullptr: `shape` describes the body
};

/// Returns the name of a part of a tool for a finding: "holder of T1".
std::string tool_in_words(ToolPart part, std::uint32_t tool);

class MachineWatch {
 public:
  /// A function of the caller that reads the mesh file of a machine's body. It returns the mesh, or an error sentence.
  using ReadMesh = std::function<tl::expected<Mesh, std::string>(const std::string& file)>;

  /// Creates the collision check. `axes`: names of the channel's axes, in their order.
  ///   pre      machine.bodies is not empty
  ///   returns  an error sentence if the module for collisions is missing or a file cannot be read
  static tl::expected<std::unique_ptr<MachineWatch>, std::string> of(const MachineProfile& machine, const std::vector<std::string>& axes,
                                                                     const AxisRoles& roles, const CutJob& job,
                                                                     const std::vector<WorkBody>& work, const ReadMesh& read);

  /// Appends the collisions during the step to `found`, in the order of time. `notes` receives a sentence for each input value that is
  /// questionable but used unchanged.
  void take(const Step& step, const MachineTime& time, std::vector<CutFinding>& found, std::vector<std::string>& notes);
  /// Processes the steps that are still stored. To be called after the last step.
  void finish(std::vector<CutFinding>& found, std::vector<std::string>& notes);
  const MovingBodies& bodies() const { return bodies_; }

 private:
  /// The tool and the tool length that are in force on the control during a motion.
  struct InForce {
    std::uint32_t tool = 0;
    double length = 0;  // tool length that the control applies, mm
    MachineTime time;
    bool known = true;  // true: the position at the start of the motion is known
  };
  struct WaitingMotion {
    KeptStep step;
    InForce in_force;
  };
  struct ToolBodies {
    std::uint32_t tool = 0;
    std::vector<std::size_t> bodies;
    double sticks_out = 0;  // distance from the tip to the upper end of the holder, mm
  };
  MachineWatch(const MachineTree& tree, BodyWorld world, const MachineProfile& machine, const AxisRoles& roles, const CutJob& job);
  std::optional<std::string> add_bodies(const MachineProfile& machine, const std::vector<WorkBody>& work, const ReadMesh& read);
  void release_waiting(std::vector<CutFinding>& found, std::vector<std::string>& notes);
  void execute(const Step& step, const InForce& in_force, std::vector<CutFinding>& found, std::vector<std::string>& notes);
  void take_tool(const InForce& in_force, std::vector<std::string>& notes);
  const ToolBodies* bodies_of_tool(std::uint32_t tool);
  void position_work(double reference);
  void find_zero();
  CutFinding finding_of(const BodyMeeting& meeting, const Axes& axes);

  CutJob job_;
  AxisRoles roles_;
  Chain chain_;
  MachineTree tree_;
  MovingBodies bodies_;
  Vec3 tool_direction_;
  std::vector<std::string> names_;  // names of the bodies, by number of the body
  std::vector<std::size_t> work_;   // numbers of the bodies that are fixed in the work coordinates: blank and fixtures
  std::vector<ToolBodies> tools_;
  std::map<std::uint32_t, double> lengths_in_force_;
  std::optional<std::pair<std::uint32_t, double>> now_;  // tool number and tool length (mm) for which the bodies of the tool are placed now
  std::uint32_t tool_;
  AxisMask unknown_ = 0;
  Placement placement_;
  std::vector<WaitingMotion> waiting_;
  std::optional<Axes> zero_;  // machine position at the zero point of the blank's work coordinates
  LinkPose work_on_link_;     // pose of the blank's work coordinates on the link that carries the blank
  Axes stand_{};
  std::vector<LinkPose> poses_;
  std::vector<BodyMeeting> met_;
  // notes about bodies of the machine that touch each other when all axes are at 0, reported at the first step
  std::vector<std::string> as_built_;
  bool length_reported_ = false;
};

}  // namespace kadr
