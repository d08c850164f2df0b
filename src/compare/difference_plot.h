#pragma once
// DifferencePlot: draws a comparison of two programs. It collects the segments while the comparison runs, in constant memory. It stores
// more detail of the first two differences and of the greatest difference.

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

/// Returns the names of both files without their folders; with their folders if the names alone are equal.
std::array<std::string, 2> short_names(const std::string& a, const std::string& b);

struct DifferenceTitle {
  std::string a, b;     // names of programs a and b
  std::string control;  // name of the control, the same for both programs
  Lang lang = Lang::en;
  std::vector<std::string> lines{};  // descriptions of the differences, as many as fit below the picture
  std::size_t numbers = 0;           // number of differences that get a number in the picture; differences with a close-up always get one
  /// Returns the program lines at which a difference begins: "part.nc:6 | new.nc:6-7".
  std::function<std::string(const CourseDifference&)> place;
};

class DifferencePlot {
 public:
  ///   frame  names of the axes, as common_frame() returns them
  explicit DifferencePlot(const std::vector<std::string>& frame);

  void take(const ComparedPiece& piece);

  /// Draws the picture. Call this function once, after the last segment. The ending of the file's name (.svg, .png) selects the format.
  ///   returns  an error sentence if the file could not be written
  tl::expected<void, std::string> write(const ResultFile& file, const DifferenceTitle& title, const Comparison& made);

 private:
  /// One difference in detail, with the common path before it and after it.
  struct Closeup {
    std::size_t number = 0;                    // index of the difference in Comparison::differences
    std::unique_ptr<DifferenceSketch> sketch;  // drawing of the close-up; nullptr: there is no such difference
    std::size_t left = 0;                      // number of common segments after the difference that have not arrived yet
  };
  /// The longest segment of a difference in which only the state (feed, tool …) differs.
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
  std::deque<SketchPiece> recent_;   // the last segments that both programs follow, for a close-up that may begin next
  std::array<Closeup, 3> closeups_;  // close-ups of the first two differences, and of the greatest difference
  double greatest_ = 0;
  std::optional<std::size_t> begun_;  // index of the last difference of which a segment has arrived; nullopt: none yet
  std::vector<Longest> longest_;      // longest segments by index of the difference; only for the first differences
  Vec3 zero_;
  std::array<std::optional<Vec3>, 2> first_, last_;  // first and last positions of the paths of a and b
  std::array<ProgramLine, 2> first_line_, last_line_;
};

}  // namespace kadr
