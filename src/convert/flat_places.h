#pragma once
// FlatPlaces: writes some ranges of lines as flat blocks of another control, between lines that are rewritten. The program is run, and what
// it does in those lines is written action by action (convert/flat_program). A range that does the same each time becomes one text.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stop.h"
#include "convert/program_shape.h"
#include "session/session.h"

namespace kadr {

struct FlatPlace {
  TextLines lines;
  bool follows = false;           // no block lies between this range and the one before
  std::string text{};             // of one execution
  std::size_t times = 0;          // how often it was executed
  std::size_t motions = 0;        // in one execution
  bool differs = false;           // it does not do the same each time
  std::optional<Alarm> cannot{};  // the other control cannot express it
  bool probed = false;            // the program has probed before: its figures may be valid for this run only
  bool settled() const { return !differs && !cannot; }
};

/// Runs the program once and writes `places`, which are in order and do not overlap.
///   centres      radius compensation is applied to the coordinates: contours are written out as a whole
///   straight_on  nothing after the last range leads back: the run ends there
///   returns      number of blocks executed
///   alarms       conversion_too_long  for all ranges together; what cannot be expressed is noted in `places`
Result<std::size_t> write_flat_places(Session& source, const ControlDef& to, std::vector<FlatPlace>& places, bool centres, bool straight_on,
                                      const StopToken& stop);

}  // namespace kadr
