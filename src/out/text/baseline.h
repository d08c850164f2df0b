#pragma once
// Baseline: what is known already, so that only what is new is told. A list of `kadr check --format json`.

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

  /// The finding is known: the same fault of the same text in the same file, wherever its line stands by now. Each known one is
  /// found once.
  bool has(const Finding& finding);
  std::size_t found() const { return found_; }

 private:
  std::map<std::string, int> known_;  // how often
  std::size_t found_ = 0;
};

}  // namespace kadr
