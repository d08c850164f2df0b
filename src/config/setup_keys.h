#pragma once
// The keys of a set-up (--setup FILE.json): one table, a row a key. The check of a file (config/setup_check), its documentation
// (docs/setup.md) and `kadr explain ID setup` (out/text/setup_page) are made from it; their meaning is that of tests/golden/README.md.

#include <cstdint>
#include <span>
#include <string_view>

#include "config/setup.h"

namespace kadr {

/// What the value of a key is.
enum class SetupForm : std::uint8_t {
  table,           // { … }; below stand fixed keys, or names (SetupNames)
  tables,          // [ { … }, … ]
  number,          //
  whole,           // a whole number
  flag,            // true, false
  text,            //
  one_of,          // one of the words in `words`
  number_or_text,  // of a parameter
  info,            // bits of a tool, as five letters or a number
  span,            // [least, most]
  numbers,         // [1, 2]
  wholes,          //
  texts,           // ["X", "Y"]
  spans,           // [[50, 1000], …]
};

/// Which names may stand below a table, or as the text of a value.
enum class SetupNames : std::uint8_t {
  fixed,  // the keys that have rows of their own
  any,
  axis,
  axis_of_any,    // of the channels
  axis_or_all,    // or "*"
  axis_or_plane,  // or "G17", "G18", "G19": a basic rotation
  offset,         // numbers of rows …
  corrector,
  zero,
  reference_point,
  spindle,
  tool_row,
  tool_form,
  probe_input,
  channel,
  work_offset,  // "G54", "G54.1 P2", "common"
  variable,     // "#100", "#_ALM", "R2"
  parameter,    // "N0106.X#1"
  place,        // "10/1"
  signal,       // of the machine's logic
  shift,        // "G92", "G52"
};

/// What a control must have to know the key; its file says whether it has it (config/setup_names).
enum class SetupNeeds : std::uint8_t {
  nothing,
  work_offsets,   // G54 … by their codes
  zeros,          // work zeros by number: a code need not have the number's order (2С42: G55 is zero 3)
  correctors,     // axis correctors
  variables,      // #n or R0 … R9
  parameters,     // a table of parameters
  corner_radius,  // variables of the offsets' corner radius
  turning_lengths,
  tool_management,
  clock,
  ini,  // settings of the control stand in an ini file (spec/linuxcnc 10.1)
  probe,
  diameters,      // axes may be programmed in diameters
  skip_question,  // the operator may be asked before a block is skipped
  machine_axes,   // axes, channels, spindles and logic are the machine's
};

enum class SetupUnit : std::uint8_t { none, mm, axis, mm_min, mm_s2, seconds, degrees, rev_min, m_min, percent };

/// Numbers that are allowed.
struct SetupRange {
  double least = -1e300, most = 1e300;
  bool by_reader = false;  // a kind of config/range.h: the reader of the key says it, with its unit
};

struct SetupKey {
  std::string_view path;  // "offsets.*.length": `*` is a name
  SetupForm form;
  SetupNames names;  // below, or of the texts
  SetupRange range;  // of the numbers
  SetupUnit unit;
  bool null;  // null is allowed: as without the key
  SetupNeeds needs;
  std::string_view words;    // of one_of, with blanks between
  std::string_view example;  // JSON
  std::string_view instead;  // what a control without it may have for the same purpose: a key
  std::string_view en, ru;
};

std::span<const SetupKey> setup_keys();

/// The row of a path written with `*` for names; nullptr: there is none.
const SetupKey* setup_key(std::string_view path);

/// A signal of the machine's logic that the control or the machine obeys (nct).
struct SetupSignal {
  std::string_view name, en, ru, manual;
  bool of_axis = false;  // each axis has one: AP_SYNCR.Z
};
std::span<const SetupSignal> setup_signals();

/// What the signal asks of an axis (nct 20.2 to 20.4): "AP_SYNCR.Z". The axis is empty where it is none of these.
struct AxisSignal {
  AxisLink link = AxisLink::follows;
  std::string_view axis;
};
AxisSignal axis_signal(std::string_view name);

/// How a number must be: "zero or above", "0 to 100", "above zero"; empty: any.
struct SetupWords {
  std::string_view en, ru;
};
SetupWords name_of(SetupUnit unit);

}  // namespace kadr
