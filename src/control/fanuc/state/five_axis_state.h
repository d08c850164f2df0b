#pragma once
// The data of the five-axis functions (NCT manual, chapter 25) that stay valid from block to block: tool centre point control, the
// programming frame in space, the positions to which G53.1 has turned the rotary axes (spec/nct/25b to 25l). All are plain values;
// space.cpp computes the resulting transformation, Placement::space.

#include <array>
#include <cstdint>
#include <optional>

#include "kinematics/five_axis.h"

namespace kadr::fanuc {

/// Codes of modal group 8 other than G43, G44, G49. They decide which point of the tool the programmed coordinates describe.
enum class TipControl : std::uint8_t {
  none,
  axis,            // G43.1: the tool length acts along the tilted tool axis
  tip,             // G43.4: tool centre point control; the program gives positions of the rotary axes
  tip_vector,      // G43.5: tool centre point control; the program gives the tool's direction as a vector
  contact,         // G43.8: cutting point control; the program gives positions of the rotary axes
  contact_vector,  // G43.9: cutting point control; the program gives the tool's direction as a vector
};
constexpr bool controls_tip(TipControl tip_control) { return tip_control >= TipControl::tip; }
constexpr bool by_vector(TipControl tip_control) {
  return tip_control == TipControl::tip_vector || tip_control == TipControl::contact_vector;
}
constexpr bool controls_contact(TipControl tip_control) { return tip_control >= TipControl::contact; }

/// The kind of programming frame in space (modal group 18). none: G69.1 is in force; turned: one G68.1 is in force; turned_twice: two G68.1
/// are in force; plane: G68.2 is in force.
enum class SpaceFrame : std::uint8_t { none, turned, turned_twice, plane };

/// The blocks of G68.2 P2 (three points) or P3 (two vectors) read so far, which define a tilted plane. INFERRED (25.8): the first block of
/// another kind ends the definition.
struct PlaneBlocks {
  std::uint8_t kind = 0;          // word P of the blocks that define the tilted plane: 2 points, 3 vectors; 0 while no definition is open
  std::uint8_t seen = 0;          // bit q is set if the block of the tilted plane with word Q = q has been read
  std::array<Vec3, 4> points{};   // mm; the point that each block of the tilted plane gives, indexed by word Q of the block
  std::array<Vec3, 4> vectors{};  // G68.2 P3: the vector that each block of the tilted plane gives, indexed by word Q of the block
  double turn = 0;                // rotation angle R in degrees of the tilted plane, from the block with Q0
};

struct FiveAxisState {
  TipControl tip_control = TipControl::none;
  bool begins = false;    // tool centre point control has been commanded and takes effect with the next motion (25h)
  bool posture = false;   // tool posture control is on: P1 was in the block of G43.4 to G43.9
  double tip_length = 0;  // tool length in mm that H has put into force
  SpaceFrame frame = SpaceFrame::none;
  Mat3 turn;           // rotation of the programming frame in space
  Vec3 origin;         // origin of the programming frame in space, mm
  Axes outer_shift{};  // shifts of G52 and G92 that were in force when the programming frame was set
  PlaneBlocks plane;
  // rotary axis positions that G53.1 or G53.6 has set; the programming frame is valid for these positions
  std::optional<RotaryPair> oriented;
  AxisMask positioned = 0;        // rotary axes programmed since G43.1 or tool centre point control was switched on (25.20), one bit each
  Vec3 normal;                    // surface normal that ,L2 I J K gives, a unit vector in part coordinates; {} if it is not programmed
  double radius = 0, corner = 0;  // tool radius and corner radius of offset D, mm (25.17)
};

}  // namespace kadr::fanuc
