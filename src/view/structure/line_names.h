#pragma once
// What a line of a program names: block numbers, programs, labels, variables, tools, cycles. It is found in the text of the line alone.
//
//   N10 G0 X0          block 10 is defined
//   M98 P200           program 200 is referred to
//   #101 = #100 + 1    variable 101 is defined, variable 100 is referred to
//   G81 Z-5 R2         the cycle G81 is called

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"
#include "config/control/control_def.h"

namespace kadr {

enum class NameKind : std::uint8_t {
  block,     // a block number: N10, GOTO 10, G71 P10 Q20
  program,   // a program or subprogram: O200, M98 P200; PROC PART, PART(5)
  label,     // a label of LinuxCNC: O<name>, O100
  variable,  // #100, #<name>
  tool,      // T3
  heading,   // a comment that is alone in its line
  opens,     // the first line of a loop, a condition or a subprogram; the name is equal in its first and last line
  closes,    // its last line
  section,   // a structure block of a conversational program: * - Outer contour
  cycle,     // a code, a name or a block that calls or defines a cycle: "G81", "CYCLE83", "CYCL DEF 200 DRILLING"
  no_cycle,  // a code that cancels the cycle: G80
  remark,    // a comment after words: T2 M6 (DRILL 6.8)
  change,    // a code that changes the tool: M6
  mark       // a label of a program with names, and the jumps to it: CIRCLE6:, REPEAT CIRCLE6
};

struct NamedPlace {
  NameKind kind = NameKind::block;
  bool defines = false;  // true: the place gives the name its meaning or its value; of a cycle: the block is a call of its own, not a mode
  Span where;            // bytes of the line: for a reference, the number or name alone, without its address
  std::string name;      // in a form that is equal for all spellings: "10" for N010, "<depth>" for #<Depth>
};

/// Returns the names of a line, those of a block in the order of their kinds.
///   line  in UTF-8, without its line break; beyond 10,000 bytes it is not searched
std::vector<NamedPlace> names_of_line(const ControlDef& def, std::string_view line);

}  // namespace kadr
