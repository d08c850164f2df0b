#pragma once
// What chapter 25 keeps from block to block: how the tool is led, the programming frame in space, where G53.1 has turned the rotary axes
// (spec/nct/25b to 25l). A value; the space that follows from it is Placement::space (part_space.cpp).

#include <array>
#include <cstdint>
#include <optional>

#include "kinematics/five_axis.h"

namespace kadr::fanuc {

/// Group 8, beyond G43, G44, G49.
enum class ToolLead : std::uint8_t {
  none,
  axis,            // G43.1: the length leans with the head
  tip,             // G43.4: the tip is led, rotary axes are programmed
  tip_vector,      // G43.5: … the tool's direction is
  contact,         // G43.8: the cutting point is led, rotary axes are programmed
  contact_vector,  // G43.9: … the tool's direction is
};
constexpr bool leads_tip(ToolLead lead) { return lead >= ToolLead::tip; }
constexpr bool by_vector(ToolLead lead) { return lead == ToolLead::tip_vector || lead == ToolLead::contact_vector; }
constexpr bool leads_contact(ToolLead lead) { return lead >= ToolLead::contact; }

/// Group 18.
enum class SpaceFrame : std::uint8_t { none, turned, turned_twice, plane };  // G69.1; one or two G68.1; G68.2

/// G68.2 P2, P3: blocks that have come; the frame is there when the first other block comes (25.8, INFERRED).
struct PlaneBlocks {
  std::uint8_t kind = 0;          // P; 0: none
  std::uint8_t seen = 0;          // a bit a Q
  std::array<Vec3, 4> points{};   // by Q
  std::array<Vec3, 4> vectors{};  // of P3
  double turn = 0;                // R of Q0
};

struct FiveAxisState {
  ToolLead lead = ToolLead::none;
  bool begins = false;     // it is led from the next motion on (25h)
  bool posture = false;    // P1 of it
  double lead_length = 0;  // mm, of H
  SpaceFrame frame = SpaceFrame::none;
  Mat3 turn;           // R
  Vec3 origin;         // v0
  Axes outer_shift{};  // of G52, G92, as it was when the frame came
  PlaneBlocks plane;
  std::optional<RotaryPair> oriented;  // where G53.1, G53.6 have turned the rotary axes: the frame is that of these positions
  AxisMask positioned = 0;             // rotary axes that were programmed since the length leans or the tip is led (25.20)
  Vec3 normal;                         // of ,L2, in the part, of length 1; {}: none yet
  double radius = 0, corner = 0;       // of D (25.17)
};

}  // namespace kadr::fanuc
