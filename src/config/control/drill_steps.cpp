// The operations of each drilling cycle (spec/nct/18.1). DrillingRun (control/fanuc) executes these operations, and `kadr explain` prints
// them. Used by control/fanuc/drilling/drilling_run, out/text/explain/cycle_text.

#include "config/control/drill_steps.h"

#include <algorithm>
#include <iterator>

#include "base/code_literals.h"

namespace kadr {
namespace {

using enum DrillStep;

constexpr DrillCycle drill_cycles[] = {
    //  code  operations                                                                                         manual
    {73_g, {approach, stop, break_chips, retract}},                                                                       // 18.1.1
    {74_g, {approach, stop, cut_fixed, pause, cw, back_fixed, ccw, clear}},                                               // 18.1.2
    {76_g, {approach, stop, cut, pause, orient, shift_out, retract, shift_back, cw}},                                     // 18.1.3
    {81_g, {approach, stop, cut, retract}},                                                                               // 18.1.5
    {82_g, {approach, stop, cut, pause, retract}},                                                                        // 18.1.6
    {83_g, {approach, stop, clear_chips, retract}},                                                                       // 18.1.7
    {84_g, {approach, stop, cut_fixed, pause, ccw, back_fixed, cw, clear}},                                               // 18.1.8
    {84.2_g, {approach, stop, catch_spindle, tap_down, pause, tap_up, clear}},                                            // 18.1.9, 18.1.10
    {84.3_g, {approach, stop, catch_spindle, tap_down, pause, tap_up, clear}},                                            // 18.1.9, 18.1.10
    {85_g, {approach, stop, cut, back, clear}},                                                                           // 18.1.11
    {86_g, {approach, stop, cut, halt, retract, cw}},                                                                     // 18.1.12
    {87_g, {approach, stop, cut, halt, manual, retract, cw}},                                                             // 18.1.13 A
    {bored_by_hand, {approach, stop, cut, halt, manual, retract, cw}},                                                    // spec/haas 8.6
    {only_back, {orient, shift_out, approach, stop, shift_back, cw, cut, orient, shift_out, initial, shift_back, cw}},    // spec/haas 8.6
    {back_boring, {orient, shift_out, approach, stop, shift_back, cw, cut, orient, shift_out, initial, shift_back, cw}},  // 18.1.13 B
    {88_g, {approach, stop, cut, pause, halt, manual, retract, cw}},                                                      // 18.1.14
    {89_g, {approach, stop, cut, pause, back, clear}},                                                                    // 18.1.15
};

}  // namespace

const DrillCycle* drill_cycle(std::int32_t code) {
  const auto* const found =
      std::find_if(std::begin(drill_cycles), std::end(drill_cycles), [&](const DrillCycle& c) { return c.code == code; });
  return found == std::end(drill_cycles) ? nullptr : found;
}

}  // namespace kadr
