#pragma once
// Every tolerance of the engine: name, unit, reason (style.md 9). What a control states as its own
// tolerance (arc radius difference, feed limits) is a row of its file, not here.

namespace kadr::tol {

inline constexpr double same_point = 1e-6;     // mm: far below any programmed step, far above rounding
inline constexpr double same_angle = 1e-9;     // degrees: rounding of a whole turn in double, times a thousand
inline constexpr double whole_number = 1e-6;   // an expression that must give an integer may miss it by rounding
inline constexpr double whole_turns = 1e-4;    // turns: Z/K of a helix written with three decimals, 2С42 6.6.6
inline constexpr double ellipse_chord = 5e-4;  // mm: half the least increment of the controls, an ellipse as chords
inline constexpr double tangential = 1e-6;     // radians: two elements meet without a corner, NCT 15.5.0
inline constexpr double circular = 0.05;       // mm: a circle's arc whose radii differ by what a program's decimals and N1339 leave
inline constexpr double least_radius = 1e-3;   // mm: the controls' least increment; speed in the middle of a spiral is that at this radius
inline constexpr double least_speed = 1e-6;    // mm/s: a motion that limits would stop goes on; no program has such a feed
inline constexpr double exact_path = 5e-4;     // mm: an arc followed exactly, half the least increment of the controls
inline constexpr double level = same_point;    // mm: two levels of a cycle closer than this are one

// Area milling (path/area). The path is made of exact lines and arcs; polygons serve only to find out which, and to measure areas.
inline constexpr double contour_curve = 2e-3;  // mm: an SVG curve as arcs; a fifth of what the controls allow an arc
inline constexpr double contour_gap = 0.01;    // mm: ends of a drawing closer than this meet; drawings are rounded to 0.001 or 0.01
inline constexpr double area_chord = 2e-4;     // mm: an arc as chords in a polygon; well below the least increment of the controls
inline constexpr double area_wall = 2e-3;      // mm the path may come too near to a wall: chords, and words rounded to 0.001
inline constexpr double area_cusp = 0.01;      // mm: what is left between two passes and lower than this is no cusp

}  // namespace kadr::tol
