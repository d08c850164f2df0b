#pragma once
// The page that compares two programs. It shows the path that both programs follow, the paths that only one of them follows, the numbered
// differences, and close-ups of the most important differences.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "out/picture/plot/plot_differences.h"
#include "out/trace/result_file.h"

namespace kadr {

/// A close-up of one difference, scaled to fill its area.
struct DifferenceCloseup {
  PlotScene scene;
  View view = View::xy;
  Box box;
  std::string caption;
};

/// A line of text below the picture, which describes one difference.
struct DifferenceLine {
  std::size_t number = 0;  // number of the difference; 0: the text only states that there are further differences
  std::string text;
};

struct DifferencePage {
  const PlotScene& scene;  // contents of the main picture; title.file contains the names of both programs
  std::string a, b;        // the names of the programs in the legend
  std::string summary;
  bool equal = false;
  std::vector<DifferenceCloseup> closeups;  // close-ups of differences, at most two
  std::vector<DifferenceLine> lines;
};

/// Draws the page. The ending of the file's name (.svg, .png) selects the format.
///   returns  an error sentence if the page cannot be drawn
tl::expected<void, std::string> draw_difference_page(const ResultFile& file, const DifferencePage& page);

}  // namespace kadr
