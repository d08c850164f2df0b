#pragma once
// The page of a cut part. It contains a large view from the front, right and above, and six side views. The colour of the surface shows
// either the tool that cut it, the order in time of the cuts, the deviation from the target part, or the removal rate.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "config/alarm_texts.h"
#include "out/picture/load_colour.h"
#include "out/trace/result_file.h"
#include "stock/surface/surface.h"

namespace kadr {

enum class PartColour : std::uint8_t { tool, age, deviation, load };

struct PartTitle {
  std::string file, control;
  Lang lang = Lang::en;
  std::string caption;  // text below the title, which states the removed volume and the cell size
  // texts of the legend when the surface is coloured by tool, e.g. "T1"; the index is the number of the colour
  std::vector<std::string> legend;
};

struct PartDeviation {
  std::vector<float> of_point;  // deviation of each surface point, mm; positive: the point is outside the target part
  double within = 0;            // greatest deviation that counts as none, mm
};

/// The removal rates, and the positions with the heaviest load.
struct PartLoad {
  SweepRates rates;
  std::vector<Vec3> heaviest;  // positions of the program lines with the greatest removal rates, in descending order of the rate
};

/// The position at which a tool or holder collided with the material.
struct CollisionMark {
  Vec3 at;
  std::uint32_t line = 0;
};

struct PartScene {
  const Surface& surface;
  Box3 box;  // bounding box of the blank
  PartColour colour = PartColour::tool;
  std::vector<std::uint8_t> colours;  // for each sweep, the index of its tool in the legend; used for PartColour::tool
  PartTitle title;
  PartDeviation deviation;  // for PartColour::deviation
  PartLoad load{};          // for PartColour::load
  std::vector<CollisionMark> collisions{};
};

/// Draws the page. The ending of the file's name (.svg, .png) selects the format. Afterwards the caller must call ResultFile::keep(), which
/// moves the complete file to its final path.
///   returns  an error sentence if the page cannot be drawn
tl::expected<void, std::string> draw_part_page(const ResultFile& file, const PartScene& scene);

}  // namespace kadr
