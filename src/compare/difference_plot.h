#pragma once
// DifferencePlot: draws a comparison. Collects its pieces while it runs, in constant memory, and more closely those of the first two
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

/// Returns the names of two files, without their folders if they still differ.
std::array<std::string, 2> short_names(const std::string& a, const std::string& b);

struct DifferenceTitle {
  std::string a, b;     // names of the programs
  std::string control;  // of both programs
  Lang lang = Lang::en;
  std::vector<std::string> lines{};  // the differences in words, as many as fit below the picture
  std::size_t numbers = 0;           // how many differences have their numbers in the picture; those with a close-up always have
  /// Returns where a difference begins: "part.nc:6 | new.nc:6-7".
  std::function<std::string(const CourseDifference&)> place;
};

class DifferencePlot {
 public:
  ///   frame  names of the axes (common_frame)
  explicit DifferencePlot(const std::vector<std::string>& frame);

  void take(const ComparedPiece& piece);

  /// Draws the picture, once, after the last piece; the ending of the file's name (.svg, .png) selects the format.
  ///   returns  an error sentence
  tl::expected<void, std::string> write(const ResultFile& file, const DifferenceTitle& title, const Comparison& made);

 private:
  /// A difference, with what both programs do before and after it.
  struct Closeup {
    std::size_t number = 0;                    // from 0
    std::unique_ptr<DifferenceSketch> sketch;  // nullptr: no such difference
    std::size_t left = 0;                      // common pieces still to be collected
  };
  /// The longest changed piece of a difference.
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
  std::deque<SketchPiece> recent_;   // the last common pieces
  std::array<Closeup, 3> closeups_;  // of the first two differences and of the greatest
  double greatest_ = 0;
  std::optional<std::size_t> begun_;  // the last difference that a piece belonged to
  std::vector<Longest> longest_;      // for the first differences
  Vec3 zero_;
  std::array<std::optional<Vec3>, 2> first_, last_;  // positions of a and of b
  std::array<ProgramLine, 2> first_line_, last_line_;
};

}  // namespace kadr
