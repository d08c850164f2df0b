#pragma once
// MovingBodies: solid bodies on the links of a machine. Finds which of them meet while the axes move.
//
// For each pair a lower bound of the distance is kept. A motion reduces it by the most that the two can approach
// (MachineLinks::travel). FCL is called only where nothing of the bound would remain, and then repeatedly along the path, each time
// at the farthest point that the two cannot have met before (conservative advancement). So no meeting is missed, however short, and
// each is found before the gap is below 0.01 mm.

#include <cstdint>
#include <string>
#include <vector>

#include "stock/bodies/body_world.h"

namespace kadr {

/// mm: two bodies nearer than this meet
inline constexpr double bodies_meet = 0.01;

/// The role of a body; pairs of some roles are not checked.
enum class BodyKind : std::uint8_t {
  machine,  // from the machine's file
  tool,     // part of the tool, with shank and holder
  work,     // the blank or a fixture: what the tool does to it is found by the cut itself
};

/// Two bodies met.
struct BodyMeeting {
  std::size_t first, second;  // numbers from add()
  double part;                // share of the motion
  Vec3 at;                    // in the coordinates of the bed
  double depth;               // mm that they overlap afterwards; 0: unknown
};

class MovingBodies {
 public:
  MovingBodies(const MachineLinks& links, BodyWorld world) : links_(links), world_(std::move(world)) {}
  BodyWorld& world() { return world_; }
  const MachineLinks& links() const { return links_; }

  /// Adds a body. Bodies with the same `group`, such as the parts of a tool, count as one body, and a meeting with them is reported
  /// once.
  ///   returns  the body's number
  std::size_t add(const SolidBody& body, std::size_t link, BodyKind kind, std::size_t group);
  /// Moves a body to another pose on its link.
  void put(std::size_t body, const LinkPose& on_link);
  /// Removes a body from the checks, or brings it back.
  void show(std::size_t body, bool is_there);
  /// Call it when the axes have moved by an unknown path.
  void jump();

  /// Excludes the pairs that meet when all axes are at 0, since they are built so: pairs of bodies of the machine, and pairs of such
  /// a body with the tool.
  ///   returns  the newly excluded pairs between bodies of the machine
  std::vector<std::pair<std::size_t, std::size_t>> take_as_built();

  /// Moves each axis evenly from one position to the other.
  ///   found  receives the meetings, after what it already holds
  void move(const Axes& from, const Axes& to, std::vector<BodyMeeting>& found);
  /// Returns by how much two bodies overlap at these axis positions, mm; 0 if they do not, or if unknown.
  double depth(std::size_t first, std::size_t second, const Axes& axes);
  /// Number of distance calls to FCL.
  std::uint64_t asked() const { return asked_; }

 private:
  struct Body {
    SolidBody solid;
    LinkPose on_link;
    std::size_t link = 0, group = 0;
    BodyKind kind = BodyKind::machine;
    bool there = false;
  };
  struct Pair {
    std::size_t first, second;
    std::size_t carrier;   // innermost link that carries both
    double at_least = 0;   // lower bound of their distance at the present positions
    bool touches = false;  // they have met and not separated since
    bool touched = false;  // value of `touches` before this motion
    bool as_built = false, is_checked = false;
  };
  void choose();
  bool belongs_together(const Pair& pair) const;
  LinkPose pose(std::size_t body, const std::vector<LinkPose>& links) const {
    return links[bodies_[body].link].after(bodies_[body].on_link);
  }
  Travel travel(std::size_t body, std::size_t from, const std::vector<LinkPose>& links, const Axes& by) const;
  BodyGap gap(const Pair& pair, const std::vector<LinkPose>& links);
  double nearing(const Pair& pair, const BodyGap& gap, const std::vector<LinkPose>& links, const Axes& by) const;
  void follow(Pair& pair, const Axes& from, const Axes& by, std::vector<BodyMeeting>& found);
  void part_from(Pair& pair, const Axes& to);
  double depth_after(const Pair& pair, const Axes& from, const Axes& by, double part);
  void tell(const BodyMeeting& meeting, std::size_t first_new, std::vector<BodyMeeting>& found) const;
  bool same_groups(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const;

  MachineLinks links_;
  BodyWorld world_;
  std::vector<Body> bodies_;
  std::vector<Pair> pairs_;
  std::vector<std::size_t> chosen_;    // numbers of the pairs in pairs_ to check
  std::vector<LinkPose> start_, now_;  // of the links
  std::vector<Travel> travels_;        // of the bodies during a motion, in the coordinates of the bed
  std::uint64_t asked_ = 0;
};

}  // namespace kadr
