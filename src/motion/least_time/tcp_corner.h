#pragma once
// This file computes how far a corner of the axes' path may be rounded under tool centre point control (nct 25.14). A corner of the axes'
// path has two causes: a corner of the tip's own path, and a change of the rotary axes' motion, which the linear axes compensate. The
// second cause does not move the tip if the corners of all axes are rounded together. Two quantities therefore limit the rounding: the
// deviation of the tip across its path, and the change of the tool direction at each tip position.

#include "action/axis_roles.h"
#include "base/vec.h"

namespace kadr {

/// A straight piece of the path of the axes from one position to the next.
struct TcpPiece {
  bool known = false;
  double length = 0;  // length of the axes' path, mm and degrees combined
  Axes along{};       // direction of the axes' path, a unit vector
  Vec3 tip;           // displacement of the tool tip in mm per mm of the axes' path
  double feed = 0;    // programmed speed along the axes' path in this piece, mm/s
  /// True if the tip has the same speed in both pieces, whatever the speeds of the axes are.
  bool keeps_pace(const TcpPiece& before) const;
};

/// Returns the piece of the axes' path from the position `from` to the position `to`. During this piece the tool tip moves from `tip_from`
/// to `tip_to`.
TcpPiece tcp_piece(std::size_t axes, const Axes& from, const Axes& to, Vec3 tip_from, Vec3 tip_to, double feed);

/// Returns how far, mm, the axes may deviate from the corner between two pieces. The tip then deviates from its own path by at most
/// `tolerance`, mm, and the tool from its direction by at most 0.01°. The result is a first-order estimate; it is bounded so that
/// second-order terms cannot matter.
double tcp_tolerance(const TcpPiece& before, const TcpPiece& after, double tolerance, AxisMask rotary);

}  // namespace kadr
