#pragma once
// MovingBodies: solid bodies on the links of a machine. Finds which bodies collide (meet) while the axes move.
//
// For each pair of bodies a lower bound of their distance is stored. A motion reduces this bound by the most that the two bodies can
// approach each other (MachineLinks::travel). Only if the bound would become 0, FCL computes the distance, repeatedly along the path: each
// time at the farthest position up to which the two bodies cannot have met (conservative advancement). So even the shortest collision is
// found, always before the distance of the two bodies is below 0.01 mm.

#include <cstdint>
#include <string>
#include <vector>

#include "stock/bodies/body_world.h"

namespace kadr {

/// Limit in mm: two bodies whose distance is smaller than this count as having met.
inline constexpr double bodies_meet = 0.01;

/// The role of a body. Pairs of bodies with certain roles are not checked against each other.
enum class BodyKind : std::uint8_t {
  machine,  // a body from the machine's file
  tool,     // a part of the tool, including its shank and holder
  work,     // the blank or a fixture; the cutting simulation finds whether the tool cuts into this body
};

/// A collision of two bodies.
struct BodyMeeting {
  std::size_t first, second;  // numbers of the two bodies, as add() returned them
  double part;                // fraction of the motion (0 to 1) at which the two bodies met
  Vec3 at;                    // position of the collision in the coordinates of the bed, mm
  double depth;               // greatest overlap of the two bodies in mm, from the collision to the end of the motion; 0 if unknown
};

class MovingBodies {
 public:
  MovingBodies(const MachineLinks& links, BodyWorld world) : links_(links), world_(std::move(world)) {}
  BodyWorld& world() { return world_; }
  const MachineLinks& links() const { return links_; }

  /// Adds a body. Bodies with the same `group`, such as the parts of one tool, count as one: a collision with several of them is reported
  /// once.
  ///   returns  the body's number
  std::size_t add(const SolidBody& body, std::size_t link, BodyKind kind, std::size_t group);
  /// Moves a body to another pose on the link that carries it.
  void put(std::size_t body, const LinkPose& on_link);
  /// Excludes a body from the checks, or includes it again.
  void show(std::size_t body, bool is_there);
  /// Makes all stored distances and contacts unknown. Must be called after the axes have moved along an unknown path.
  void jump();

  /// Excludes from the checks the pairs of bodies that are in contact when all axes are at 0, because the machine is built with this
  /// contact. Only pairs of two bodies of the machine, and pairs of the tool and a body of the machine, are excluded.
  ///   returns  the pairs of two bodies of the machine that this call has excluded
  std::vector<std::pair<std::size_t, std::size_t>> accept_initial_contacts();

  /// Moves each axis evenly from the position `from` to the position `to`, and appends the collisions on this motion to `found`.
  void move(const Axes& from, const Axes& to, std::vector<BodyMeeting>& found);
  /// Returns by how much two bodies overlap at the axis positions `axes`, mm; 0 if they do not overlap, or if the overlap is unknown.
  double depth(std::size_t first, std::size_t second, const Axes& axes);
  /// Returns the number of distance computations by FCL so far.
  std::uint64_t queries() const { return queries_; }

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
    std::size_t carrier;   // the last link, counted from the bed, that carries both bodies
    double at_least = 0;   // lower bound in mm of the distance between the two bodies at the present axis positions
    bool touches = false;  // true if the two bodies have met and have not separated since
    bool touched = false;  // true if the two bodies were already in contact at the start of the present motion
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
  void report_meeting(const BodyMeeting& meeting, std::size_t first_new, std::vector<BodyMeeting>& found) const;
  bool same_groups(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const;

  MachineLinks links_;
  BodyWorld world_;
  std::vector<Body> bodies_;
  std::vector<Pair> pairs_;
  std::vector<std::size_t> chosen_;    // indices in pairs_ of the pairs to check
  std::vector<LinkPose> start_, now_;  // poses of the links at the start of the motion, and at the present step along the motion
  std::vector<Travel> travels_;        // upper bounds of the displacements of the bodies in a motion, in the coordinates of the bed
  std::uint64_t queries_ = 0;
};

}  // namespace kadr
