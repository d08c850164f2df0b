#pragma once
// MachineWatch: the steps of a run, carried out by the bodies of the machine: which of them meet, and meet fixtures, blank and tool.
//
//   Step ─▶ positions of the axes, piece by piece ─▶ MovingBodies ─▶ BodyMeeting ─▶ CutFinding (`machine`)
//
// What the tool does to blank and fixtures the cut itself tells. Until the work system of the blank is known (the first motion at feed)
// steps are kept.

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

/// Blank or fixture.
struct WorkBody {
  std::string name;
  BodyShape shape;
  const Mesh* mesh = nullptr;  // if it is a file
};

class MachineWatch {
 public:
  /// The file of a machine's body → its mesh, or an error sentence.
  using ReadMesh = std::function<tl::expected<Mesh, std::string>(const std::string& file)>;

  /// `axes`: of the channel, in their order.
  ///   pre      machine.bodies is not empty
  ///   returns  an error sentence: the module is not there, a file cannot be read
  static tl::expected<std::unique_ptr<MachineWatch>, std::string> of(const MachineProfile& machine, const std::vector<std::string>& axes,
                                                                     const AxisRoles& roles, const CutJob& job,
                                                                     const std::vector<WorkBody>& work, const ReadMesh& read);

  /// What meets in the step, in the order of time; a sentence each in `notes` of what was taken as it is.
  void take(const Step& step, const MachineTime& time, std::vector<CutFinding>& found, std::vector<std::string>& notes);
  /// All that was kept.
  void finish(std::vector<CutFinding>& found, std::vector<std::string>& notes);
  const MovingBodies& bodies() const { return bodies_; }

 private:
  /// How the control reckoned in a motion.
  struct InForce {
    std::uint32_t tool = 0;
    double length = 0;  // of the tool, as the control reckons with it
    MachineTime time;
    bool known = true;  // where the motion begins
  };
  struct KeptMotion {
    KeptStep step;
    InForce in_force;
  };
  struct ToolBodies {
    std::uint32_t tool = 0;
    std::vector<std::size_t> bodies;
    double sticks_out = 0;  // with its holder
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
  std::vector<std::size_t> work_;   // bodies that lie in the work system
  std::vector<ToolBodies> tools_;
  std::map<std::uint32_t, double> lengths_in_force_;
  std::optional<std::pair<std::uint32_t, double>> now_;  // the tool, and where its tip is, that the bodies stand for
  std::uint32_t tool_;
  AxisMask unknown_ = 0;
  Placement placement_;
  std::vector<KeptMotion> kept_;
  std::optional<Axes> zero_;  // axes of the machine at the zero of the blank's work system
  LinkPose work_on_link_;     // of that work system
  Axes stand_{};
  std::vector<LinkPose> poses_;
  std::vector<BodyMeeting> met_;
  std::vector<std::string> as_built_;  // to be told once
  bool told_length_ = false;
};

}  // namespace kadr
