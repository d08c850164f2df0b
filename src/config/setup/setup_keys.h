#pragma once
// The keys of a set-up (--setup FILE.json): one table, one row per key. Three things are generated from this table: the check of a file
// (config/setup/setup_check), the page docs/setup.md, and `kadr explain ID setup` (out/text/explain/setup_page). tests/golden/README.md
// defines the meaning of the keys.

#include <cstdint>
#include <span>
#include <string_view>

#include "config/setup/setup.h"
#include "config/texts.h"

namespace kadr {

/// The form that the value of a key must have.
enum class SetupForm : std::uint8_t {
  table,           // a table { … }, with fixed keys or with names as keys (SetupNames)
  tables,          // a list of tables [ { … }, … ]
  number,          //
  whole,           // a whole number
  flag,            // true, false
  text,            //
  one_of,          // one of the words that `words` lists
  number_or_text,  // the value of a parameter: a number or a text
  info,            // info bits of a tool, stated as five letters or as a number
  span,            // a range [least, most]
  numbers,         // a list of numbers [1, 2]
  wholes,          //
  texts,           // a list of texts ["X", "Y"]
  spans,           // a list of ranges [[50, 1000], …]
};

/// The names that are allowed as keys of a table, or as the text of a value.
enum class SetupNames : std::uint8_t {
  fixed,  // the table has no other keys than those that have rows of their own in setup_keys.cpp
  any,
  axis,
  axis_of_any,    // name of an axis of any channel of the control
  axis_or_all,    // name of an axis, or "*" for all axes
  axis_or_plane,  // name of an axis, or "G17", "G18", "G19" for a basic rotation
  offset,         // number of a row of the offset table; the following kinds, up to `channel`, are numbers too
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
  place,        // name of a magazine pocket, magazine/pocket: "10/1"
  signal,       // name of a signal of the machine's logic
  shift,        // "G92", "G52"
};

/// What a control must have so that the key applies to it. The control's file states whether it has this (config/setup/setup_names).
enum class SetupNeeds : std::uint8_t {
  nothing,
  work_offsets,   // the control names its work offsets by their codes: G54 …
  zeros,          // the control names its work offsets by numbers, whose order may differ from that of the codes (2С42: G55 is zero 3)
  correctors,     // axis correctors
  variables,      // the control has variables #n or R0 … R9
  parameters,     // a parameter table
  corner_radius,  // the control has variables for the corner radius in its tool offsets
  turning_lengths,
  lathe_offsets,  // the tool offsets of a lathe have a geometry and a wear for each axis (spec/fanuc-t 4.2)
  tool_management,
  clock,
  ini,  // the control reads an ini file with its settings (spec/linuxcnc 10.1)
  probe,
  diameters,      // the control allows axes that are programmed as diameters
  turning,        // the control may be that of a lathe
  skip_question,  // the control may ask the operator before it skips a block
  machine_axes,   // the control's axes, channels, spindles and machine logic depend on the machine
  kinematics,     // the control knows the rotary axes of the machine from the set-up
};

enum class SetupUnit : std::uint8_t { none, mm, axis, mm_min, mm_s2, seconds, degrees, rev_min, m_min, percent };

/// The permitted range of a number.
struct SetupRange {
  double least = -1e300, most = 1e300;
  // True if the range depends on the quantity (config/range.h); the reader of the key then checks the range, with the unit
  bool by_reader = false;
};

struct SetupKey {
  std::string_view path;  // full name of the key: "offsets.*.length"; `*` stands for a name
  SetupForm form;
  SetupNames names;  // the names that are permitted as keys of a table, or as texts
  SetupRange range;  // permitted range of the numbers
  SetupUnit unit;
  bool null;  // true if the value null is permitted; it means that the key is missing
  SetupNeeds needs;
  std::string_view words;    // the permitted words, separated by blanks; used only for the form one_of
  std::string_view example;  // an example of the value, as JSON
  std::string_view instead;  // key that another type of control has for the same purpose
  PlainText about;
};

std::span<const SetupKey> setup_keys();

/// Returns the row of a key's path, which has `*` in place of names; nullptr if the table has no such row.
const SetupKey* setup_key(std::string_view path);

/// A signal of the machine's logic that has an effect on the control or the machine (nct).
struct SetupSignal {
  std::string_view name;
  PlainText about;
  std::string_view manual;
  bool of_axis = false;  // true if each axis has its own signal of this name, with the axis' name as ending: AP_SYNCR.Z
};
std::span<const SetupSignal> setup_signals();

/// The effect of a signal such as "AP_SYNCR.Z" on an axis (nct 20.2 to 20.4). `axis` is empty for any other signal.
struct AxisSignal {
  AxisLink link = AxisLink::follows;
  std::string_view axis;
};
AxisSignal axis_signal(std::string_view name);

/// Returns the name of a unit for people: "mm/min", «мм/мин»; empty for a number without unit.
const char* name_of(SetupUnit unit, Lang lang);

}  // namespace kadr
