#pragma once
// The page of a cut part: a large view from the front right above, and six side views; coloured by tool, age, deviation or load.

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
  std::string caption;              // a line below the title: what was removed, and the cell size
  std::vector<std::string> legend;  // by colour number: "T1"; for PartColour::tool
};

struct PartDeviation {
  std::vector<float> of_point;  // mm, above 0 outside the target part
  double within = 0;            // mm; a smaller deviation counts as none
};

/// Where how much was removed.
struct PartLoad {
  SweepRates rates;
  std::vector<Vec3> heaviest;  // positions of the heaviest lines; the first is number 1
};

/// Where something collided with the material.
struct CollisionPlace {
  Vec3 at;
  std::uint32_t line = 0;
};

struct PartScene {
  const Surface& surface;
  Box3 box;  // of the blank
  PartColour colour = PartColour::tool;
  std::vector<std::uint8_t> colours;  // for PartColour::tool: by sweep, the number in the legend
  PartTitle title;
  PartDeviation deviation;  // for PartColour::deviation
  PartLoad load{};          // for PartColour::load
  std::vector<CollisionPlace> collisions{};
};

/// Draws the page; the ending of the file's name (.svg, .png) selects the format. The caller keeps the file.
///   returns  an error sentence
tl::expected<void, std::string> draw_part_page(const ResultFile& file, const PartScene& scene);

}  // namespace kadr
