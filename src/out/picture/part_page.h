#pragma once
// The page of a cut part: large from the front right above, and from six sides; coloured by tool, by age, by deviation, or by load.

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
  std::string caption;              // a line below: what was removed, in what cell
  std::vector<std::string> legend;  // by colour number: "T1"; of PartColour::tool
};

struct PartDeviation {
  std::vector<float> of_point;  // mm, above 0 outside the part that is wanted
  double within = 0;            // mm that are none
};

/// What was taken away where.
struct PartLoad {
  SweepRates rates;
  std::vector<Vec3> heaviest;  // places of the heaviest lines, the first is number 1
};

/// Where something hit the material.
struct CollisionPlace {
  Vec3 at;
  std::uint32_t line = 0;
};

struct PartScene {
  const Surface& surface;
  Box3 box;  // of the blank
  PartColour colour = PartColour::tool;
  std::vector<std::uint8_t> colours;  // of PartColour::tool: by sweep, the number in the legend
  PartTitle title;
  PartDeviation deviation;  // of PartColour::deviation
  PartLoad load{};          // of PartColour::load
  std::vector<CollisionPlace> collisions{};
};

/// The ending of the name says whether .svg or .png. The file is the caller's to keep.
///   returns  an error sentence
tl::expected<void, std::string> draw_part_page(const ResultFile& file, const PartScene& scene);

}  // namespace kadr
