#pragma once
// Baseline: a list of findings already known, so that only new ones are reported. Read from the output of `kadr check --format json`.

#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "out/text/alarm_print.h"

namespace kadr {

class Baseline {
 public:
  ///   returns  an error sentence
  static tl::expected<Baseline, std::string> read(std::string_view json);

  /// Returns true if the finding is known: the same alarm for the same text in the same file, whatever its line number is now. Each known
  /// finding matches only once.
  bool has(const Finding& finding);
  std::size_t found() const { return found_; }

 private:
  std::map<std::string, int> known_;  // number of occurrences by finding
  std::size_t found_ = 0;
};

}  // namespace kadr
