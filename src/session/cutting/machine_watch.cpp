// MachineWatch: finds collisions of the machine's bodies during a run. It is used by cli/cut and tested by tests/run_cut.py.

#include "session/cutting/machine_watch.h"

#include <algorithm>
#include <cmath>

#include "kinematics/five_axis_transform.h"
#include "session/cutting/axes_path.h"
#include "texts/cutting.h"

namespace kadr {
namespace {

// Tolerance of the chords that replace the motion of the axes, mm or degrees. It is a fifth of the depth that counts as a collision.
constexpr double chord_of_axes = 0.002;
constexpr std::size_t max_waiting_steps = 10'000;  // greatest number of steps stored until the work coordinates of the blank are known
constexpr double same_length = 1e-9;               // mm; lengths that differ by less count as equal

/// Returns the kinematics of the machine. If the machine's file has no [kinematics], the result is a chain in which the axes X, Y and Z, in
/// this order, carry the tool.
MachineTree tree_of(MachineProfile machine, const std::vector<std::string>& axes) {
  if (!machine.chains.given()) {
    machine.chains.tool = {"X", "Y", "Z"};
    for (int i = 0; i < 3; ++i) {
      AxisJoint& moves = machine.axes[machine.chains.tool[std::size_t(i)]].joint;
      if (!(length(moves.direction) > 0)) moves.direction = {i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0.};
    }
  }
  return {machine, axes};
}

/// Returns the rotation that turns a tool with its axis along Z into the direction of the tool in the spindle.
Mat3 turn_of_tool(Vec3 direction) {
  const Vec3 z{0, 0, 1}, axis = cross(z, direction);
  if (length(axis) > 0) return Mat3::about(unit(axis), std::atan2(length(axis), dot(z, direction)) / rad_per_deg);
  return direction.z < 0 ? Mat3::about({1, 0, 0}, 180) : Mat3{};
}

std::string no_memory() { return translated(texts::cutting::no_memory); }

}  // namespace

std::string tool_in_words(ToolPart part, std::uint32_t tool) {
  if (part == ToolPart::holder) return translated(texts::cutting::holder, tool);
  if (part == ToolPart::shank) return translated(texts::cutting::shank, tool);
  return translated(texts::cutting::tool, tool);
}

MachineWatch::MachineWatch(const MachineTree& tree, BodyWorld world, const MachineProfile& machine, const AxisRoles& roles,
                           const CutJob& job)
    : job_(job),
      roles_(roles),
      chain_(roles),
      tree_(tree),
      bodies_(MachineLinks(tree), std::move(world)),
      tool_direction_(machine.chains.tool_direction),
      tool_(job.tool) {
  if (!job.starts_known)
    for (const int axis : roles.xyz)
      if (axis >= 0) unknown_ |= AxisMask{1} << axis;
}

tl::expected<std::unique_ptr<MachineWatch>, std::string> MachineWatch::of(const MachineProfile& machine,
                                                                          const std::vector<std::string>& axes, const AxisRoles& roles,
                                                                          const CutJob& job, const std::vector<WorkBody>& work,
                                                                          const ReadMesh& read) {
  const KadrBodiesInterface* const door = bodies_library();
  if (door == nullptr) return tl::unexpected(translated(texts::cutting::no_library));
  std::unique_ptr<MachineWatch> watch(new MachineWatch(tree_of(machine, axes), BodyWorld(*door), machine, roles, job));
  if (const auto fault = watch->add_bodies(machine, work, read)) return tl::unexpected(*fault);
  return watch;
}

std::optional<std::string> MachineWatch::add_bodies(const MachineProfile& machine, const std::vector<WorkBody>& work,
                                                    const ReadMesh& read) {
  BodyWorld& world = bodies_.world();
  const MachineLinks& links = bodies_.links();
  for (const MachineBody& body : machine.bodies) {
    std::optional<SolidBody> solid;
    if (body.shape.form == BodyShape::Form::file) {
      const auto mesh = read(body.shape.file);
      if (!mesh) return mesh.error();
      solid = world.add(*mesh);
    } else {
      solid = world.add(body.shape);
    }
    if (!solid) return no_memory();
    bodies_.add(*solid, links.moved_by(body.on), BodyKind::machine, names_.size());
    names_.push_back(body.name);
  }
  for (const auto& [first, second] : bodies_.accept_initial_contacts())
    as_built_.push_back(translated(texts::cutting::built_so, names_[first], names_[second]));
  for (const WorkBody& body : work) {
    const auto solid = body.mesh != nullptr ? world.add(*body.mesh) : world.add(body.shape);
    if (!solid) return no_memory();
    work_.push_back(bodies_.add(*solid, links.part(), BodyKind::work, names_.size()));
    bodies_.show(work_.back(), false);
    names_.push_back(body.name);
  }
  return std::nullopt;
}

/// Returns the bodies of a tool. They are created when the tool is first in the spindle. Returns nullptr if the tools file does not contain
/// the tool.
const MachineWatch::ToolBodies* MachineWatch::bodies_of_tool(std::uint32_t tool) {
  for (const ToolBodies& made : tools_)
    if (made.tool == tool) return &made;
  const ToolGeometry* geometry = job_.tools.find(tool);
  if (geometry == nullptr && tool == 0 && job_.tools.tools.size() == 1) geometry = &job_.tools.tools.front();
  if (geometry == nullptr) return nullptr;
  ToolBodies made{tool, {}, geometry->length + (geometry->holder.empty() ? 0 : geometry->holder.back().height)};
  const std::size_t group = names_.size();
  for (const ConvexBody& body : shape_of(*geometry).bodies) {
    const auto solid = bodies_.world().add(body);
    if (!solid) continue;  // a body of zero width is omitted, since the collision library FCL cannot represent it
    made.sticks_out = std::max(made.sticks_out, body.top());
    made.bodies.push_back(bodies_.add(*solid, bodies_.links().tool(), BodyKind::tool, group));
    names_.push_back(tool_in_words(body.part, geometry->number));
  }
  return &tools_.emplace_back(std::move(made));
}

/// Determines the distance from the gauge point down to the tool tip. It comes from the set-up, or else from the length that the control
/// applies now or has applied last. If neither is known, the tool has the length that the tools file states, and the work offset is assumed
/// to have been measured with the tool tip.
void MachineWatch::take_tool(const InForce& in_force, std::vector<std::string>& notes) {
  if (std::fabs(in_force.length) > same_length) lengths_in_force_[in_force.tool] = in_force.length;
  const auto real = job_.lengths.find(in_force.tool), reckoned = lengths_in_force_.find(in_force.tool);
  const ToolBodies* const tool = bodies_of_tool(in_force.tool);
  const bool is_known = real != job_.lengths.end() || reckoned != lengths_in_force_.end();
  const double length = real != job_.lengths.end()            ? real->second
                        : reckoned != lengths_in_force_.end() ? reckoned->second
                        : tool != nullptr                     ? tool->sticks_out
                                                              : 0;
  if (now_ && now_->first == in_force.tool && now_->second == length) return;
  now_ = {in_force.tool, length};
  for (const ToolBodies& other : tools_)
    for (const std::size_t body : other.bodies) bodies_.show(body, other.tool == in_force.tool);
  if (tool != nullptr)
    for (const std::size_t body : tool->bodies) bodies_.put(body, {turn_of_tool(tool_direction_), -length * tool_direction_});
  (void)bodies_.accept_initial_contacts();
  position_work(is_known ? 0 : length);
  if (is_known || tool == nullptr || length_reported_) return;
  length_reported_ = true;
  notes.push_back(translated(texts::cutting::length_not_stated, in_force.tool));
}

/// Places blank and fixtures on the link that carries them. `reference`: distance from the gauge point down to the point with which the
/// work offset was measured, mm.
void MachineWatch::position_work(double reference) {
  if (!zero_) return;
  std::vector<LinkPose>& poses = poses_;
  bodies_.links().poses(*zero_, poses);
  const Vec3 at = poses[bodies_.links().tool()].of(-reference * tool_direction_);
  work_on_link_ = poses[bodies_.links().part()].inverse().after({{}, at});
  for (const std::size_t body : work_) bodies_.put(body, work_on_link_), bodies_.show(body, true);
}

/// Computes the machine position at the zero point of the work coordinates in force. X, Y and Z are at the zero point. The axes that turn
/// the part are where they were when the work offset was measured.
void MachineWatch::find_zero() {
  Axes axes{};
  const Vec3 zero = work_origin_of(chain_, placement_);
  const double main[] = {zero.x, zero.y, zero.z};
  for (const MachineJoint& joint : tree_.part())
    if (joint.axis >= 0) axes[std::size_t(joint.axis)] = placement_.origin[std::size_t(joint.axis)];
  if (const auto* const space = dynamic_cast<const FiveAxisTransform*>(placement_.space.get()); space != nullptr && space->has_rotary()) {
    const FiveAxisTransformData& data = space->data();
    if (data.machine.first.axis >= 0 && data.machine.first_on_table()) axes[std::size_t(data.machine.first.axis)] = data.measured.first;
    if (data.machine.second.axis >= 0 && data.machine.second_on_table()) axes[std::size_t(data.machine.second.axis)] = data.measured.second;
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (roles_.xyz[i] >= 0) axes[std::size_t(roles_.xyz[i])] = main[i];
  zero_ = axes;
  now_.reset();
}

void MachineWatch::take(const Step& step, const MachineTime& time, std::vector<CutFinding>& found, std::vector<std::string>& notes) {
  notes.insert(notes.end(), as_built_.begin(), as_built_.end());
  as_built_.clear();
  if (const auto* const change = std::get_if<ToolChange>(&step.action.what)) tool_ = change->tool;
  if (const auto* const frame = std::get_if<FrameChange>(&step.action.what)) placement_ = frame->placement;
  const Motion* const motion = step.motion();
  if (motion == nullptr || time.begins >= job_.until) return;
  const InForce in_force{tool_, chain_.tip(placement_.length).z, time, unknown_ == 0};
  unknown_ &= ~motion->named;
  if (unknown_ != 0) return;
  if (!zero_ && (job_.system ? motion->system == *job_.system : is_cutting(motion->kind))) release_waiting(found, notes);
  if (zero_) return execute(step, in_force, found, notes);
  waiting_.push_back({KeptStep(step), in_force});
  if (waiting_.size() >= max_waiting_steps) release_waiting(found, notes);
}

void MachineWatch::release_waiting(std::vector<CutFinding>& found, std::vector<std::string>& notes) {
  find_zero();
  for (const WaitingMotion& waiting : waiting_) execute(waiting.step.step(), waiting.in_force, found, notes);
  waiting_ = {};
}

void MachineWatch::finish(std::vector<CutFinding>& found, std::vector<std::string>& notes) {
  if (!zero_) release_waiting(found, notes);
}

void MachineWatch::execute(const Step& step, const InForce& in_force, std::vector<CutFinding>& found, std::vector<std::string>& notes) {
  take_tool(in_force, notes);
  const Motion& motion = *step.motion();
  const Axes from = in_force.known ? step.from.machine : motion.machine;
  if (!bodies_.links().same_place(from, stand_)) bodies_.jump();
  Axes at = from;
  double begins = 0;
  const std::size_t first_new = found.size();
  std::vector<std::pair<std::size_t, std::size_t>> new_ones;
  const auto go = [&](const Axes& to, double ends) {
    met_.clear();
    bodies_.move(at, to, met_);
    for (const BodyMeeting& meeting : met_) {
      Axes there = at;
      for (std::size_t i = 0; i < max_axes; ++i) there[i] += meeting.part * (to[i] - at[i]);
      CutFinding finding = finding_of(meeting, there);
      finding.origin = step.action.origin;
      finding.tool = in_force.tool;
      const double part = begins + meeting.part * (ends - begins);
      finding.at_time = in_force.time.begins + part * in_force.time.seconds;
      if (finding.at_time > job_.until) continue;
      found.push_back(finding);
      new_ones.emplace_back(meeting.first, meeting.second);
    }
    at = to;
    begins = ends;
  };
  if (in_force.known) along_axes_path(step, chord_of_axes, job_.apart, go);
  else go(motion.machine, 1);
  // A collision of an earlier segment may be deeper at the end of the motion, so its depth there is compared with the depth found first.
  for (std::size_t i = 0; i < new_ones.size(); ++i) {
    double& depth = found[first_new + i].depth;
    depth = std::max(depth, bodies_.depth(new_ones[i].first, new_ones[i].second, at));
  }
  stand_ = motion.machine;
}

CutFinding MachineWatch::finding_of(const BodyMeeting& meeting, const Axes& axes) {
  bodies_.links().poses(axes, poses_);
  CutFinding finding;
  finding.id = AlarmId::machine;
  finding.at = work_on_link_.back(poses_[bodies_.links().part()].back(meeting.at));
  finding.depth = meeting.depth;
  finding.bodies = {names_[meeting.first], names_[meeting.second]};
  return finding;
}

}  // namespace kadr
