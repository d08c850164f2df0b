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
inline constexpr double level = same_point;    // mm: two levels of a cycle closer than this are one

}  // namespace kadr::tol
