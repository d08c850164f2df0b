#pragma once
// Reads the contour of a milling cycle. The contour is a subprogram: a copy of the interpreter executes it, so that expressions, jumps,
// roundings and calls in it mean what they mean everywhere. Only src/control includes this file.

#include <functional>

#include "action/motion.h"
#include "base/result.h"
#include "base/span.h"
#include "config/drawing/drawing.h"

namespace kadr {

class Interpreter;

/// The path of a subprogram in the plane in force, in work coordinates, mm.
struct Outline {
  Edges edges;   // in the order of the path; an arc of more than half a circle is several edges
  int side = 0;  // of cutter compensation in force on the path: +1 the tool is left of it, -1 right, 0 none
};

/// Executes a subprogram in a copy of the interpreter, and returns its path. The first motion in the plane leads to the start of the
/// contour and is not part of the path; motions along other axes are passed over. The state of `m` stays as it is, so assignments of the
/// subprogram have no effect after it.
///   call     starts the subprogram in the copy, which is in the state of `m`
///   alarms   those of the subprogram's blocks, of its chamfers and roundings; outline_missing: it moves nothing, measures, or has such a
///   cycle itself
Result<Outline> outline_of(Interpreter& m, Span where, const std::function<Status(Interpreter& copy)>& call);

/// Returns the path of the tool's centre along an outline: from the point on the normal to its first edge to the one on the normal to its
/// last edge. Outside corners are passed as `join` says.
///   side    +1: the tool is left of the outline, -1: right
///   alarms  those of cutter compensation: compensation_no_intersection, compensation_interference …
Result<Edges> offset_outline(Interpreter& m, const Edges& outline, double radius, int side, CornerJoin join, Span where);

/// Returns true if the outline ends where it begins.
bool is_closed(const Edges& outline);

}  // namespace kadr
