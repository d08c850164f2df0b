#pragma once
// Found: what a program's run finds, as a person reads it: of each id the first warning whole, those like it counted and told in one line
// at the end.

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
  ///   every  each of them is printed whole
  Found(const AlarmTexts& texts, Lang lang, std::FILE* to, bool every) : texts_(texts), lang_(lang), to_(to), every_(every) {}

  void tell(const AlarmReport& report);
  /// The lines of those that were only counted; once, when all is told.
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
