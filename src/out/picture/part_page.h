#pragma once
// The page of a cut part: a large view from the front right above, and six side views. The surface is coloured by tool, age, deviation or
// load.

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
  std::string caption;              // text below the title: the volume removed, and the cell size
  std::vector<std::string> legend;  // labels by colour number, for PartColour::tool: "T1"
};

struct PartDeviation {
  std::vector<float> of_point;  // deviation of each surface point, mm; positive: outside the target part
  double within = 0;            // mm; a smaller deviation counts as 0
};

/// The removal rates, and the positions of the heaviest load.
struct PartLoad {
  SweepRates rates;
  std::vector<Vec3> heaviest;  // positions of the program lines with the greatest removal rate; the first is number 1
};

/// The position of a collision with the material.
struct CollisionMark {
  Vec3 at;
  std::uint32_t line = 0;
};

struct PartScene {
  const Surface& surface;
  Box3 box;  // bounding box of the blank
  PartColour colour = PartColour::tool;
  std::vector<std::uint8_t> colours;  // legend number of each sweep's tool, for PartColour::tool
  PartTitle title;
  PartDeviation deviation;  // for PartColour::deviation
  PartLoad load{};          // for PartColour::load
  std::vector<CollisionMark> collisions{};
};

/// Draws the page; the ending of the file's name (.svg, .png) selects the format. The caller calls ResultFile::keep().
///   returns  an error sentence
tl::expected<void, std::string> draw_part_page(const ResultFile& file, const PartScene& scene);

}  // namespace kadr
