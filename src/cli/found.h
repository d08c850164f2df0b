#pragma once
// Found: prints what a run finds, for people: the first warning of each id in full; further ones are counted and reported in one line at
// the end.

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
  ///   to     where they are printed: stderr, or a file without colours
  ///   every  print each of them in full
  Found(const AlarmTexts& texts, Lang lang, std::FILE* to, bool every) : texts_(texts), lang_(lang), to_(to), every_(every) {}

  void tell(const AlarmReport& report);
  /// Prints the lines of the findings that were only counted; call it once, at the end.
  void finish();

 private:
  struct Repeated {
    std::size_t more = 0;
    std::vector<std::uint32_t> lines;  // of the first few, each once
  };
  void print(const std::string& text) const;

  const AlarmTexts& texts_;
  const Lang lang_;
  std::FILE* const to_;
  const bool every_;
  std::map<std::pair<std::string, AlarmId>, Repeated> repeated_;  // by file
};

}  // namespace kadr::cli
