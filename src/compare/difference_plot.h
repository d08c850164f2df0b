#pragma once
// DifferencePlot: a comparison as a picture. Takes its pieces as it goes, in constant memory, and close up those of the first two
// differences and of the greatest one.

#include <array>
#include <deque>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "compare/comparison.h"
#include "compare/difference_sketch.h"
#include "compare/difference_window.h"
#include "out/picture/difference_page.h"

namespace kadr {

/// Of two files, without their folders where that tells them apart.
std::array<std::string, 2> short_names(const std::string& a, const std::string& b);

struct DifferenceTitle {
  std::string a, b;     // what the programs are called
  std::string control;  // of both
  Lang lang = Lang::en;
  std::vector<std::string> lines{};  // the differences in words, as many as stand below the picture
  std::size_t numbers = 0;           // differences whose numbers stand in it; those close up have theirs anyway
  /// Where a difference begins: "part.nc:6 | new.nc:6-7".
  std::function<std::string(const CourseDifference&)> place;
};

class DifferencePlot {
 public:
  ///   frame  names of the axes (common_frame)
  explicit DifferencePlot(const std::vector<std::string>& frame);

  void take(const ComparedPiece& piece);

  /// After the last piece, once. Draws; the ending of the name (.svg, .png) says which.
  ///   returns  an error sentence
  tl::expected<void, std::string> write(const ResultFile& file, const DifferenceTitle& title, const Comparison& made);

 private:
  /// A difference with what both do before and after it.
  struct Closeup {
    std::size_t number = 0;                    // from 0
    std::unique_ptr<DifferenceSketch> sketch;  // nullptr: there is none
    std::size_t left = 0;                      // pieces in common that are still taken
  };
  /// Of a difference: the longest piece that is changed.
  struct Longest {
    double length = 0;
    Vec3 middle;
  };

  void begin(const ComparedPiece& piece);
  void start(Closeup& closeup, std::size_t number);
  void measure(const ComparedPiece& piece, const SketchPiece& in_picture);
  SketchPiece in_picture(const ComparedPiece& piece) const;

  void finish(Vec3 zero);
  PlotNumber number_of(const CourseDifference& d, std::size_t index) const;
  std::vector<PlotMark> marks(const Comparison& made) const;
  DifferenceWindow window_on(const Closeup& closeup, const Comparison& made) const;
  std::vector<const Closeup*> chosen(const Comparison& made) const;
  Vec3 tip(const Axes& machine) const { return chain_.tip(machine) - zero_; }

  Chain chain_;
  DifferenceSketch whole_;
  std::deque<SketchPiece> recent_;   // what both have done last
  std::array<Closeup, 3> closeups_;  // of the first two differences and of the greatest
  double greatest_ = 0;
  std::optional<std::size_t> begun_;  // the last difference that a piece has come of
  std::vector<Longest> longest_;      // of the first differences
  Vec3 zero_;
  std::array<std::optional<Vec3>, 2> first_, last_;  // places of a and of b
  std::array<ProgramLine, 2> first_line_, last_line_;
};

}  // namespace kadr
