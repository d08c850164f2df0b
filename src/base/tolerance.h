#pragma once
// Every tolerance of the engine, with its unit and its reason (CONTRIBUTING.md, "Numbers"). A tolerance that a control's manual specifies
// (difference of an arc's radii, limits of the feed) is a row of the control's file, not of this one.

namespace kadr::tol {

// mm: points closer than this are the same; far below any programmed step, far above the rounding error of a coordinate
inline constexpr double same_point = 1e-6;
// degrees: angles closer than this are the same; a thousand times the rounding error of 360° in a double
inline constexpr double same_angle = 1e-9;
inline constexpr double whole_number = 1e-6;  // greatest difference between the value of an expression and the integer that it must be
// revolutions: difference from a whole number of revolutions that a helix may have, because its Z and K have three decimals only (2С42
// 6.6.6)
inline constexpr double whole_turns = 1e-4;
// mm: greatest distance between an ellipse and the chords that replace it; half the least increment of the controls
inline constexpr double ellipse_chord = 5e-4;
// radians: two path elements whose directions differ by less than this meet without a corner (NCT 15.5.0)
inline constexpr double tangential = 1e-6;
// mm: an arc whose radii at start and end differ by less than this still counts as circular, because the words of a program are rounded
// (N1339)
inline constexpr double circular = 0.05;
// mm: if the radius of a spiral is smaller than this, its speed is computed as at this radius, which is the controls' least increment
inline constexpr double least_radius = 1e-3;
// mm/s: least speed of a motion that its limits would otherwise bring to a stop; no program has so low a feed
inline constexpr double least_speed = 1e-6;
// mm: greatest deviation from an arc that must be followed exactly; half the least increment of the controls
inline constexpr double exact_path = 5e-4;
inline constexpr double level = same_point;  // mm: two levels of a canned cycle closer than this are the same

// Area milling (path/pocketing). The path consists of exact lines and arcs; polygons serve only to select these lines and arcs and to
// measure areas.
inline constexpr double contour_curve = 2e-3;
// mm: two line ends in a drawing that are closer than this are joined; coordinates in drawings are rounded to 0.001 or 0.01
inline constexpr double contour_gap = 0.01;
// mm: greatest distance between an arc and the chords of the polygon that replaces it; well below the controls' least increment
inline constexpr double area_chord = 2e-4;
inline constexpr double area_wall = 2e-3;  // mm: the path may be too near to a wall by this much (chords, words rounded to 0.001)
inline constexpr double area_cusp = 0.01;  // mm: a ridge of stock between two passes that is lower than this does not count as a cusp

}  // namespace kadr::tol
