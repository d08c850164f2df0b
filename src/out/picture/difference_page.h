#pragma once
// The page that compares two programs: what both do, what only one of them does, and the numbered differences, with close-ups of the most
// important.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "out/picture/plot_differences.h"
#include "out/trace/result_file.h"

namespace kadr {

/// A close-up of one difference, as large as needed.
struct DifferenceCloseup {
  PlotScene scene;
  View view = View::xy;
  Box box;
  std::string caption;
};

/// A difference described in words.
struct DifferenceLine {
  std::size_t number = 0;  // 0: no number, since the line describes other differences
  std::string text;
};

struct DifferencePage {
  const PlotScene& scene;  // the whole picture; title.file names both programs
  std::string a, b;        // the names of the programs in the legend
  std::string summary;
  bool equal = false;
  std::vector<DifferenceCloseup> closeups;  // at most two
  std::vector<DifferenceLine> lines;
};

/// Draws the page; the ending of the file's name (.svg, .png) selects the format.
///   returns  an error sentence
tl::expected<void, std::string> draw_difference_page(const ResultFile& file, const DifferencePage& page);

}  // namespace kadr
