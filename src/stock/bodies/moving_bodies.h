#pragma once
// MovingBodies: solid bodies on the links of a machine, and which of them meet while the axes move.
//
// Of each pair it is known how far apart they are at least. A motion takes from that what the two can come nearer by
// (MachineLinks::travel); only where nothing would be left FCL is asked, and then again and again along the way, each time as far on as
// cannot bring them together (conservative advancement). So no meeting is missed, however short, and one is found before 0.01 mm are left
// between them.

#include <cstdint>
#include <string>
#include <vector>

#include "stock/bodies/body_world.h"

namespace kadr {

/// Nearer than this, two bodies meet, mm.
inline constexpr double bodies_meet = 0.01;

/// What of a machine a body is: pairs of some kinds are not looked at.
enum class BodyKind : std::uint8_t {
  machine,  // of the machine's file
  tool,     // part of the tool, with shank and holder
  work,     // the blank, a fixture: what the tool does to it, the cut itself tells
};

/// Two bodies met.
struct BodyMeeting {
  std::size_t first, second;  // by the numbers of add()
  double part;                // of the motion
  Vec3 at;                    // seen from the bed
  double depth;               // mm that they overlap afterwards; 0: not known
};

class MovingBodies {
 public:
  MovingBodies(const MachineLinks& links, BodyWorld world) : links_(links), world_(std::move(world)) {}
  BodyWorld& world() { return world_; }
  const MachineLinks& links() const { return links_; }

  /// `group`: bodies of one group are one to those who meet them: the parts of a tool, told once.
  ///   returns  its number
  std::size_t add(const SolidBody& body, std::size_t link, BodyKind kind, std::size_t group);
  /// Another place on its link.
  void put(std::size_t body, const LinkPose& on_link);
  /// It is not there from now on, or is again.
  void show(std::size_t body, bool is_there);
  /// The axes stand somewhere else, nobody knows how they came there.
  void jump();

  /// Pairs that meet where all axes stand at 0 are built so: they are looked at no more. Between bodies of the machine, and between them
  /// and the tool.
  ///   returns  those of the machine that are new
  std::vector<std::pair<std::size_t, std::size_t>> take_as_built();

  /// Each axis goes evenly from one position to the other.
  ///   found  is added to
  void move(const Axes& from, const Axes& to, std::vector<BodyMeeting>& found);
  /// By how much two bodies overlap where the axes stand, mm; 0: they do not, or it is not known.
  double depth(std::size_t first, std::size_t second, const Axes& axes);
  /// How often FCL was asked for a distance.
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
    std::size_t carrier;   // of both links
    double at_least = 0;   // that they are apart where the axes stand now
    bool touches = false;  // they have met, and not parted
    bool touched = false;  // before this motion
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
  std::vector<std::size_t> chosen_;    // of pairs_: those that are looked at
  std::vector<LinkPose> start_, now_;  // of the links
  std::vector<Travel> travels_;        // of the bodies in a motion, seen from the bed
  std::uint64_t asked_ = 0;
};

}  // namespace kadr
