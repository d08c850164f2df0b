#pragma once
// Baseline: a list of findings that are already known, so that only new findings are reported. The list is the output of `kadr check
// --format json`.

#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "out/text/alarm_print.h"

namespace kadr {

class Baseline {
 public:
  /// Reads the list.
  ///   returns  an error sentence if the text is not such a list
  static tl::expected<Baseline, std::string> read(std::string_view json);

  /// Returns true if the finding is known, that is, if the list has the same alarm for the same text in the same file. The line number may
  /// differ. Each finding of the list matches only once.
  bool has(const Finding& finding);
  std::size_t found() const { return found_; }

 private:
  std::map<std::string, int> known_;  // finding → number of occurrences that have not been matched yet
  std::size_t found_ = 0;
};

}  // namespace kadr
