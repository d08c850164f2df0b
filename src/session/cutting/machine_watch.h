#pragma once
// MachineWatch: executes the steps of a run with the bodies of the machine, and finds which of them meet each other, fixtures, blank or
// tool.
//
//   Step ─▶ positions of the axes, piece by piece ─▶ MovingBodies ─▶ BodyMeeting ─▶ CutFinding (`machine`)
//
// What the tool does to blank and fixtures is reported by the cut itself. Steps are kept until the work system of the blank is known,
// which is at the first motion at feed.

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
  const Mesh* mesh = nullptr;  // set if it is a file
};

class MachineWatch {
 public:
  /// Reads the file of a machine's body. Returns its mesh, or an error sentence.
  using ReadMesh = std::function<tl::expected<Mesh, std::string>(const std::string& file)>;

  /// `axes`: of the channel, in their order.
  ///   pre      machine.bodies is not empty
  ///   returns  an error sentence if the module is missing or a file cannot be read
  static tl::expected<std::unique_ptr<MachineWatch>, std::string> of(const MachineProfile& machine, const std::vector<std::string>& axes,
                                                                     const AxisRoles& roles, const CutJob& job,
                                                                     const std::vector<WorkBody>& work, const ReadMesh& read);

  /// Appends what meets in the step, in the order of time; `notes` receives one sentence for each input that is used as it is.
  void take(const Step& step, const MachineTime& time, std::vector<CutFinding>& found, std::vector<std::string>& notes);
  /// Executes the steps that were kept.
  void finish(std::vector<CutFinding>& found, std::vector<std::string>& notes);
  const MovingBodies& bodies() const { return bodies_; }

 private:
  /// What the control applied during a motion.
  struct InForce {
    std::uint32_t tool = 0;
    double length = 0;  // of the tool, as the control applies it
    MachineTime time;
    bool known = true;  // the start of the motion is known
  };
  struct KeptMotion {
    KeptStep step;
    InForce in_force;
  };
  struct ToolBodies {
    std::uint32_t tool = 0;
    std::vector<std::size_t> bodies;
    double sticks_out = 0;  // length including its holder
  };
  MachineWatch(const MachineTree& tree, BodyWorld world, const MachineProfile& machine, const AxisRoles& roles, const CutJob& job);
  std::optional<std::string> add_bodies(const MachineProfile& machine, const std::vector<WorkBody>& work, const ReadMesh& read);
  void release_kept(std::vector<CutFinding>& found, std::vector<std::string>& notes);
  void carry_out(const Step& step, const InForce& in_force, std::vector<CutFinding>& found, std::vector<std::string>& notes);
  void take_tool(const InForce& in_force, std::vector<std::string>& notes);
  const ToolBodies* bodies_of_tool(std::uint32_t tool);
  void place_work(double reference);
  void find_zero();
  CutFinding finding_of(const BodyMeeting& meeting, const Axes& axes);

  CutJob job_;
  AxisRoles roles_;
  Chain chain_;
  MachineTree tree_;
  MovingBodies bodies_;
  Vec3 tool_direction_;
  std::vector<std::string> names_;  // by number of the body
  std::vector<std::size_t> work_;   // bodies fixed in the work system
  std::vector<ToolBodies> tools_;
  std::map<std::uint32_t, double> lengths_in_force_;
  std::optional<std::pair<std::uint32_t, double>> now_;  // the tool, and its tip position, that the bodies currently represent
  std::uint32_t tool_;
  AxisMask unknown_ = 0;
  Placement placement_;
  std::vector<KeptMotion> kept_;
  std::optional<Axes> zero_;  // machine axes at the zero of the blank's work system
  LinkPose work_on_link_;     // pose of that work system on its link
  Axes stand_{};
  std::vector<LinkPose> poses_;
  std::vector<BodyMeeting> met_;
  std::vector<std::string> as_built_;  // notes to be reported once
  bool told_length_ = false;
};

}  // namespace kadr
