#pragma once
// Found: prints the findings of a run for the user. The first warning of each id is printed in full. Further warnings with this id are
// counted, and one line at the end sums them up.

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "out/text/alarm_print.h"

namespace kadr::cli {

class Found {
 public:
  ///   to     stream for the output: stderr, or a file without colours
  ///   every  true: every finding is printed in full
  Found(const AlarmTexts& texts, Lang lang, std::FILE* to, bool every) : texts_(texts), lang_(lang), to_(to), every_(every) {}

  void print_report(const AlarmReport& report);
  /// Prints the lines that sum up the counted findings. Call this function once, at the end.
  void finish();

 private:
  struct Repeated {
    std::size_t more = 0;
    std::vector<std::uint32_t> lines;  // program lines of the first of these findings; each line occurs once
  };
  void print(const std::string& text) const;

  const AlarmTexts& texts_;
  const Lang lang_;
  std::FILE* const to_;
  const bool every_;
  std::map<std::pair<std::string, AlarmId>, Repeated> repeated_;  // repeated findings, by file name and alarm id
};

}  // namespace kadr::cli
