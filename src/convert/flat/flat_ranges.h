#pragma once
// FlatRange: a range of lines that is expanded into flat blocks (single motions) of the target control, while the lines between the ranges
// are rewritten. The program is run, and each action in these ranges is written (convert/flat/flat_program). A range becomes one text if
// all its executions do the same.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stop_token.h"
#include "convert/program_shape.h"
#include "session/session.h"

namespace kadr {

struct FlatRange {
  TextLines lines;
  bool follows = false;           // true if no block lies between the previous expanded range and this one
  std::string text{};             // text of the flat blocks (single motions) that one execution of the range gives
  std::size_t times = 0;          // number of executions
  std::size_t motions = 0;        // number of motions in one execution of the range
  bool differs = false;           // true if two executions of the range give different texts
  std::optional<Alarm> cannot{};  // alarm that the target control cannot express the range; nullopt: it can
  bool probed = false;  // a probe motion came earlier, so coordinates of this range may depend on what the probe touched in this run
  bool settled() const { return !differs && !cannot; }
};

/// Runs the program once and fills in `places`. The ranges in `places` must be in order and must not overlap.
///   centres      true: cutter compensation is applied to the coordinates, and contours are expanded as a whole
///   straight_on  true: no line after the last range leads back to this range, so the run may end after it
///   returns      number of blocks executed
///   alarms       conversion_too_long if all ranges together are too long; an alarm about a single range is stored in `places`
Result<std::size_t> write_flat_ranges(Session& source, const ControlDef& to, std::vector<FlatRange>& places, bool centres, bool straight_on,
                                      const StopToken& stop);

}  // namespace kadr
