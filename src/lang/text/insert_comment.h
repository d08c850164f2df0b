#pragma once
// Reads the description of a turning tool in a comment: "(T1212 OD TURN CNMG 432 IC908)", "(GROOVING TOOL 4 MM)", «РЕЗЕЦ ПРОХОДНОЙ
// VNMG160404». The result is a proposal, which a person must check.

#include <cstdint>
#include <optional>
#include <string_view>

namespace kadr {

enum class InsertWork : std::uint8_t { none, turning, boring, grooving, threading };

/// What a comment tells of an insert. Lengths in mm, angles in degrees.
struct InsertComment {
  InsertWork work = InsertWork::none;
  bool inside = false;           // the tool works in a bore
  bool face = false;             // a groove in the face
  bool has_code = false;         // true: shape and size are those of an ISO or ANSI designation such as VNMG160404
  std::optional<double> angle;   // included angle of the nose; 0: a round insert
  std::optional<double> corner;  // nose radius
  std::optional<double> edge;    // length of the insert's edge
  std::optional<double> width;   // of a grooving insert
};

/// Returns what the comment tells of an insert; `work` is none if it does not describe a turning tool.
///   text  UTF-8, without its brackets
///   inch  true: numbers without a unit are in inches
InsertComment read_insert_comment(std::string_view text, bool inch);

}  // namespace kadr
