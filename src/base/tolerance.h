#pragma once
// Every tolerance of the engine, with its unit and its reason (CONTRIBUTING.md, "Numbers"). A tolerance that a control itself specifies
// (difference of an arc's radii, limits of the feed) is a row of the control's file, not here.

namespace kadr::tol {

inline constexpr double same_point = 1e-6;     // mm: far below any programmed step, far above rounding
inline constexpr double same_angle = 1e-9;     // degrees: a thousand times the rounding error of 360° in a double
inline constexpr double whole_number = 1e-6;   // an expression that must give an integer may miss it by this much through rounding
inline constexpr double whole_turns = 1e-4;    // revolutions: Z/K of a helix written with three decimals, 2С42 6.6.6
inline constexpr double ellipse_chord = 5e-4;  // mm: an ellipse approximated by chords; half the least increment of the controls
inline constexpr double tangential = 1e-6;     // radians: two elements that differ by less meet without a corner, NCT 15.5.0
inline constexpr double circular = 0.05;  // mm: difference of radii in an arc that still counts as circular (decimals of a program, N1339)
inline constexpr double least_radius =
    1e-3;  // mm: the controls' least increment; near the centre of a spiral, speed is computed at this radius
inline constexpr double least_speed = 1e-6;  // mm/s: floor for a motion that limits would bring to a stop; no program has such a feed
inline constexpr double exact_path = 5e-4;   // mm: an arc that must be followed exactly; half the least increment of the controls
inline constexpr double level = same_point;  // mm: two levels of a canned cycle closer than this are the same

// Area milling (path/area). The path consists of exact lines and arcs; polygons serve only to select them and to measure areas.
inline constexpr double contour_curve = 2e-3;  // mm: an SVG curve approximated by arcs; a fifth of what the controls allow for an arc
inline constexpr double contour_gap = 0.01;    // mm: ends in a drawing closer than this are joined; drawings are rounded to 0.001 or 0.01
inline constexpr double area_chord = 2e-4;     // mm: an arc approximated by chords of a polygon; well below the controls' least increment
inline constexpr double area_wall = 2e-3;      // mm by which the path may come too near to a wall (chords, words rounded to 0.001)
inline constexpr double area_cusp = 0.01;      // mm: remaining stock between two passes lower than this is no cusp

}  // namespace kadr::tol
