#pragma once
// FlatPlaces: some lines of a program written out, as flat blocks of another control, between others that stay: the program is run and
// what it does at those lines is said, action by action (convert/flat_program). A place that does the same each time becomes one text.

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
  bool follows = false;           // there is no block between it and the place before
  std::string text{};             // of one time
  std::size_t times = 0;          // it was carried out
  std::size_t motions = 0;        // of one time
  bool differs = false;           // not each time the same
  std::optional<Alarm> cannot{};  // the other control cannot say it
  bool probed = false;            // the program has probed before: its figures may be those of this run
  bool settled() const { return !differs && !cannot; }
};

/// Runs the program once and writes `places`, which are in their order and do not overlap.
///   centres      radius compensation is calculated in: contours are places as a whole
///   straight_on  nothing leads back behind the last of them: the run ends there
///   returns  blocks carried out
///   alarms   conversion_too_long  all of them together; what cannot be said stands in the places
Result<std::size_t> write_flat_places(Session& source, const ControlDef& to, std::vector<FlatPlace>& places, bool centres, bool straight_on,
                                      const StopToken& stop);

}  // namespace kadr
