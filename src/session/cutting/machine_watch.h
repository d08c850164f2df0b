#pragma once
// MachineWatch: moves the machine's solid bodies with the steps of a run, and finds collisions between them, and with fixtures, blank and
// tool.
//
//   Step ─▶ positions of the axes, piece by piece ─▶ MovingBodies ─▶ BodyMeeting ─▶ CutFinding (`machine`)
//
// The stock reports collisions of the tool with blank and fixtures. Steps are kept until the work system of the blank is known, at the
// first motion at feed.

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

/// A blank or fixture.
struct WorkBody {
  std::string name;
  BodyShape shape;
  const Mesh* mesh = nullptr;  // set if a mesh file describes the body
};

class MachineWatch {
 public:
  /// Reads the mesh file of a machine's body. Returns the mesh, or an error sentence.
  using ReadMesh = std::function<tl::expected<Mesh, std::string>(const std::string& file)>;

  /// `axes`: names of the channel's axes, in their order.
  ///   pre      machine.bodies is not empty
  ///   returns  an error sentence if the module for collisions is missing or a file cannot be read
  static tl::expected<std::unique_ptr<MachineWatch>, std::string> of(const MachineProfile& machine, const std::vector<std::string>& axes,
                                                                     const AxisRoles& roles, const CutJob& job,
                                                                     const std::vector<WorkBody>& work, const ReadMesh& read);

  /// Appends the collisions during the step to `found`, in the order of time. `notes` receives a sentence for each piece of input that is
  /// questionable but used unchanged.
  void take(const Step& step, const MachineTime& time, std::vector<CutFinding>& found, std::vector<std::string>& notes);
  /// Processes the steps that are still kept.
  void finish(std::vector<CutFinding>& found, std::vector<std::string>& notes);
  const MovingBodies& bodies() const { return bodies_; }

 private:
  /// The tool and tool length that the control applied during a motion.
  struct InForce {
    std::uint32_t tool = 0;
    double length = 0;  // tool length that the control applies
    MachineTime time;
    bool known = true;  // the position at the start of the motion is known
  };
  struct KeptMotion {
    KeptStep step;
    InForce in_force;
  };
  struct ToolBodies {
    std::uint32_t tool = 0;
    std::vector<std::size_t> bodies;
    double sticks_out = 0;  // length of the tool with its holder
  };
  MachineWatch(const MachineTree& tree, BodyWorld world, const MachineProfile& machine, const AxisRoles& roles, const CutJob& job);
  std::optional<std::string> add_bodies(const MachineProfile& machine, const std::vector<WorkBody>& work, const ReadMesh& read);
  void release_kept(std::vector<CutFinding>& found, std::vector<std::string>& notes);
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
  std::vector<std::string> names_;  // names of the bodies, by their numbers
  std::vector<std::size_t> work_;   // numbers of the bodies fixed in the work system
  std::vector<ToolBodies> tools_;
  std::map<std::uint32_t, double> lengths_in_force_;
  std::optional<std::pair<std::uint32_t, double>> now_;  // tool number and tool length that the bodies of the tool currently represent
  std::uint32_t tool_;
  AxisMask unknown_ = 0;
  Placement placement_;
  std::vector<KeptMotion> kept_;
  std::optional<Axes> zero_;  // machine position at the zero point of the blank's work system
  LinkPose work_on_link_;     // pose of the blank's work system on the link that carries it
  Axes stand_{};
  std::vector<LinkPose> poses_;
  std::vector<BodyMeeting> met_;
  std::vector<std::string> as_built_;  // notes that are reported once
  bool length_reported_ = false;
};

}  // namespace kadr
