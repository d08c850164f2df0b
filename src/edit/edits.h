#pragma once
// Edits: what is to be changed in a program, and nothing else. The words of the command line and of the page are read by read_edit().

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "config/setup/setup.h"
#include "edit/plane_map.h"

namespace kadr {

/// A factor for feeds or spindle speeds.
struct Factor {
  std::optional<std::uint32_t> tool{};  // the tool in the spindle for which the factor applies; nullopt: all tools
  double factor = 1;
};

/// New block numbers: first, first + step, first + 2 step …
struct Numbering {
  std::uint32_t first = 10, step = 10;
};

/// A work system by its code: G54, or G54.1 with P3.
struct SystemCode {
  std::int32_t code = 0;                      // ten times the number of the G code
  std::optional<std::uint32_t> further = {};  // the number after P; nullopt: the code stands alone
  friend bool operator==(const SystemCode&, const SystemCode&) = default;
};

/// Lines of the program's file, counted from 1.
struct EditLines {
  std::uint32_t first = 0, last = 0;
  friend bool operator==(const EditLines&, const EditLines&) = default;
};

struct Edits {
  std::optional<Numbering> numbering;
  bool no_numbers = false, no_comments = false, no_spaces = false, no_empty_lines = false;  // what is removed
  bool spaces = false;                                                                      // a space is put between words
  std::vector<Factor> feeds, speeds;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> tools;   // numbers of tools: old, new
  std::vector<std::pair<SystemCode, SystemCode>> work_systems;  // old, new
  AxisValues shift;                                             // mm, by name of the axis: added to positions in work coordinates
  std::optional<PlaneMap> plane;                                // all positions in work coordinates are mapped in the XY plane
  int maps = 0;                                                 // how many such maps are asked for
  bool copies = false;                                          // a pattern is asked for, even one of a single place
  std::vector<PlaneMap> places;                                 // further places at which lines are repeated
  std::optional<EditLines> copied;                              // the lines that are repeated; nullopt: all that cuts, tool by tool
  std::optional<EditLines> reverses;                            // the lines of a contour that runs backwards
  // Lines whose course is repeated or reversed. edited() finds them.
  std::vector<EditLines> pieces;

  bool empty() const {
    return !numbering && !no_numbers && !no_comments && !no_spaces && !no_empty_lines && !spaces && feeds.empty() && speeds.empty() &&
           tools.empty() && work_systems.empty() && shift.empty() && !plane && !copies && !reverses;
  }
};

/// Returns the factor for this tool; 1 if no factor applies to it. A factor for a tool takes precedence over one for all tools.
double factor_for(const std::vector<Factor>& factors, std::uint32_t tool);

// Each of these functions reads one word of a user and returns an error sentence if the word is wrong.

/// Reads `80%` or `T3=80%`.
tl::expected<Factor, std::string> read_factor(std::string_view text);
/// Reads `10` (first number and step) or `100:5`.
tl::expected<Numbering, std::string> read_numbering(std::string_view text);
/// Reads `3=7` or `T3=T7`.
tl::expected<std::pair<std::uint32_t, std::uint32_t>, std::string> read_tools(std::string_view text);
/// Reads `G54=G55` or `G54=G54.1P3`.
tl::expected<std::pair<SystemCode, SystemCode>, std::string> read_systems(std::string_view text);
/// Reads `X10`, `Z-0.5`: the name of an axis and a distance in mm.
tl::expected<std::pair<std::string, double>, std::string> read_shift(std::string_view text);

/// Reads `X`, `Y`, `X=50` or `Y=-3.5`: the axis that changes its sign, and the line about which it does.
tl::expected<PlaneMap, std::string> read_mirror(std::string_view text);
/// Reads `90` or `30@10,20`: degrees, counter-clockwise, and the centre.
tl::expected<PlaneMap, std::string> read_rotation(std::string_view text);
/// Reads `3x2:30,20`: columns, rows and their distances in mm; or `6@60` or `6@60:10,20`: how many, degrees from one to the next, and the
/// centre. Returns the places without the first one, where the program is already.
tl::expected<std::vector<PlaneMap>, std::string> read_places(std::string_view text);
/// Reads `12-40`: lines of the file.
tl::expected<EditLines, std::string> read_lines(std::string_view text);

/// Adds the edit that a user asks for by the name of an option of `kadr edit`, without its hyphens, and a word: "feed" and "T3=80%".
tl::expected<void, std::string> add_edit(Edits& edits, std::string_view name, std::string_view word);
/// Returns how many edits of positions are asked for. Their order would matter, so that only one of them may be made at a time.
int places_edited(const Edits& edits);

}  // namespace kadr
