#pragma once
// Draws a milled area in plan view, as SVG or PNG. The picture shows the contours and the path of the tool centre.

#include <string>
#include <tl/expected.hpp>

#include "config/alarm_texts.h"
#include "out/trace/result_file.h"
#include "path/pocketing/mill.h"

namespace kadr {

struct MillPicture {
  const std::vector<area::Zone>& zones;
  const std::vector<area::Move>& moves;
  const std::vector<Vec2>& holes;
  double radius = 0;  // tool radius, mm
  double top = 0;     // Z of the top of the material, mm
  std::string title;
  std::string subtitle;
  Lang lang = Lang::en;
};

/// Draws the picture. The ending of the file's name (.svg, .png) selects the format.
///   returns  an error sentence if the picture cannot be drawn
tl::expected<void, std::string> draw_milling(const ResultFile& file, const MillPicture& picture);

/// Returns the picture as SVG; empty if the memory was not sufficient.
std::string milling_svg(const MillPicture& picture);

}  // namespace kadr
