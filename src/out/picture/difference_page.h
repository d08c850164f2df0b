#pragma once
// The page of two programs: what both do, what only one of them does, the differences by their numbers; close up those that matter most.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "out/picture/plot_differences.h"
#include "out/trace/result_file.h"

namespace kadr {

/// One of them, as large as it needs.
struct DifferenceCloseup {
  PlotScene scene;
  View view = View::xy;
  Box box;
  std::string caption;
};

/// A difference in words.
struct DifferenceLine {
  std::size_t number = 0;  // 0: none, it speaks of others
  std::string text;
};

struct DifferencePage {
  const PlotScene& scene;  // of the whole; title.file: both programs
  std::string a, b;        // what they are called in the legend
  std::string summary;
  bool equal = false;
  std::vector<DifferenceCloseup> closeups;  // at most two
  std::vector<DifferenceLine> lines;
};

/// Draws; the ending of the name (.svg, .png) says which.
///   returns  an error sentence
tl::expected<void, std::string> draw_difference_page(const ResultFile& file, const DifferencePage& page);

}  // namespace kadr
