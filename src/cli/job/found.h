#pragma once
// Found: prints the findings of a run for the user. The first warning of each id is printed in full; further ones are counted and summed
// up in one line at the end.

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
  ///   to     stream to print to: stderr, or a file without colours
  ///   every  print every finding in full
  Found(const AlarmTexts& texts, Lang lang, std::FILE* to, bool every) : texts_(texts), lang_(lang), to_(to), every_(every) {}

  void tell(const AlarmReport& report);
  /// Prints the lines that sum up the counted findings; call it once, at the end.
  void finish();

 private:
  struct Repeated {
    std::size_t more = 0;
    std::vector<std::uint32_t> lines;  // program lines of the first few of these findings, each line once
  };
  void print(const std::string& text) const;

  const AlarmTexts& texts_;
  const Lang lang_;
  std::FILE* const to_;
  const bool every_;
  std::map<std::pair<std::string, AlarmId>, Repeated> repeated_;  // findings that occur several times, by file name and alarm id
};

}  // namespace kadr::cli
