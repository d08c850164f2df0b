// Draws a comparison of two programs. Used by cli/diff; tested by tests/diff_plot.py and tests/compare/difference_sketch_test.cpp.

#include "compare/difference_plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/comparison_text.h"
#include "texts/comparison.h"

namespace kadr {
namespace {

// Greatest number of points of a path in the main picture, and in a close-up.
constexpr std::size_t max_points = 100'000, most_close_points = 20'000;
// Greatest deviation, mm, of a drawn path in the main picture, and in a close-up.
constexpr double whole_chord = 0.002, close_chord = 1e-5;
// Greatest number of common segments that are stored before a difference, and after it.
constexpr std::size_t most_around = 500;
constexpr std::size_t max_numbers = 500;     // greatest number of differences that are numbered in the picture
constexpr double same_place = 1e-3;          // mm
constexpr std::uint16_t file_of_b = 0x8000;  // bit that is added to ProgramLine::file to mark a file of b

using Part = ComparedPiece::Part;
using Layer = SketchPiece::Layer;

ProgramLine line_of(const Origin& origin, bool of_b) { return {origin.line, std::uint16_t(of_b ? file_of_b | origin.file : origin.file)}; }

Stroke stroke_of(CourseMove move) {
  return move == CourseMove::rapid ? Stroke::rapid : move == CourseMove::probe ? Stroke::probe : Stroke::feed;
}

bool is_of_state(CourseDifference::Kind kind) {
  using Kind = CourseDifference::Kind;
  return kind != Kind::path && kind != Kind::act && kind != Kind::end;
}

PlotTitle plot_title(const DifferenceTitle& title, const Comparison& made) {
  PlotTitle all{title.a + " | " + title.b, title.control, title.lang, {}, LengthUnit::mm, {{0, title.a}, {file_of_b, title.b}}};
  for (const auto& [file, name] : made.files_a) all.files[file] = name_of_file(name);
  for (const auto& [file, name] : made.files_b) all.files[std::uint16_t(file_of_b | file)] = name_of_file(name);
  return all;
}

PlotDifferences layers_of(const DifferenceSketch& sketch, std::vector<PlotNumber> numbers) {
  return {sketch.changed(), sketch.a(), sketch.b(), std::move(numbers)};
}

std::vector<DifferenceLine> lines_of(const DifferenceTitle& title, const Comparison& made) {
  std::vector<DifferenceLine> lines;
  for (const std::string& text : title.lines) lines.push_back({lines.size() + 1, text});
  const std::size_t more = made.differences.size() + made.more - title.lines.size();
  if (more > 0) lines.push_back({0, translated_in(title.lang, texts::comparison::and_more, more)});
  return lines;
}

}  // namespace

std::array<std::string, 2> short_names(const std::string& a, const std::string& b) {
  const std::string its = name_of_file(a), other = name_of_file(b);
  return its == other ? std::array{a, b} : std::array{its, other};
}

DifferencePlot::DifferencePlot(const std::vector<std::string>& frame) : chain_(AxisRoles::of(frame, 0)), whole_(max_points, whole_chord) {}

SketchPiece DifferencePlot::in_picture(const ComparedPiece& piece) const {
  const Layer layer = piece.part == Part::together  ? Layer::same
                      : piece.part == Part::changed ? Layer::changed
                      : piece.of_b                  ? Layer::b
                                                    : Layer::a;
  return {layer, chain_.tip(piece.from), chain_.tip(piece.to), stroke_of(piece.move), line_of(piece.origin, piece.of_b), piece.act};
}

void DifferencePlot::take(const ComparedPiece& piece) {
  const SketchPiece drawn = in_picture(piece);
  const std::size_t side = piece.of_b ? 1 : 0;
  if (!first_[side]) first_[side] = drawn.from, first_line_[side] = drawn.line;
  last_[side] = drawn.to, last_line_[side] = drawn.line;
  if (piece.of_b && piece.part != Part::apart) return;  // both programs follow the same path here, so only the segment of a is drawn
  if (piece.part != Part::together) {
    if (begun_ != piece.number) begin(piece);
    measure(piece, drawn);
  }
  whole_.take(drawn);
  for (Closeup& closeup : closeups_) {
    if (!closeup.sketch || closeup.left == 0) continue;
    const bool its = piece.part != Part::together && piece.number == closeup.number;
    closeup.left = its ? most_around : closeup.left - 1;
    closeup.sketch->take(drawn);
  }
  if (piece.part != Part::together) return;
  recent_.push_back(drawn);
  if (recent_.size() > most_around) recent_.pop_front();
}

void DifferencePlot::begin(const ComparedPiece& piece) {
  begun_ = piece.number;
  for (const std::size_t i : {0U, 1U})
    if (piece.number == i && !closeups_[i].sketch) start(closeups_[i], i);
  if (piece.part != Part::apart || piece.distance <= greatest_) return;
  greatest_ = piece.distance;
  start(closeups_[2], piece.number);
}

void DifferencePlot::start(Closeup& closeup, std::size_t number) {
  closeup.number = number;
  closeup.sketch = std::make_unique<DifferenceSketch>(most_close_points, close_chord);
  closeup.left = most_around;
  for (const SketchPiece& piece : recent_) closeup.sketch->take(piece);
}

void DifferencePlot::measure(const ComparedPiece& piece, const SketchPiece& in_picture) {
  if (piece.part != Part::changed || piece.number >= max_numbers) return;
  if (longest_.size() <= piece.number) longest_.resize(piece.number + 1);
  Longest& longest = longest_[piece.number];
  const double its = length(in_picture.to - in_picture.from);
  if (its > longest.length) longest = {its, 0.5 * (in_picture.from + in_picture.to)};
}

void DifferencePlot::finish(Vec3 zero) {
  zero_ = zero;
  const auto moved = [&](DifferenceSketch& sketch) { sketch.finish(), sketch.move_all(-1.0 * zero); };
  moved(whole_);
  for (Closeup& closeup : closeups_)
    if (closeup.sketch) moved(*closeup.sketch);
}

PlotNumber DifferencePlot::number_of(const CourseDifference& d, std::size_t index) const {
  if (d.kind == CourseDifference::Kind::path) return {index + 1, tip(d.b_far), false};
  const bool moves = is_of_state(d.kind) && index < longest_.size() && longest_[index].length > 0;
  if (moves) return {index + 1, longest_[index].middle - zero_, false};
  return {index + 1, tip(d.a.stand), true};
}

/// Returns the symbols at the starts and ends of both paths; one symbol if both have the same position.
std::vector<PlotMark> DifferencePlot::marks(const Comparison& made) const {
  std::vector<PlotMark> all;
  const auto add = [&](PlotMark mark) {
    mark.at = mark.at - zero_;
    const auto same = [&](const PlotMark& other) { return other.what == mark.what && length(other.at - mark.at) < same_place; };
    if (std::none_of(all.begin(), all.end(), same)) all.push_back(mark);
  };
  for (const std::size_t side : {0U, 1U})
    if (first_[side]) add({PlotMark::What::start, *first_[side], first_line_[side]});
  for (const std::size_t side : {0U, 1U}) {
    const auto& stopped = side == 0 ? made.stopped_a : made.stopped_b;
    if (!last_[side] || (made.lost && !stopped)) continue;
    if (stopped) add({PlotMark::What::stop, *last_[side], line_of(stopped->origin, side == 1)});
    else add({PlotMark::What::end, *last_[side], last_line_[side]});
  }
  return all;
}

DifferenceWindow DifferencePlot::window_on(const Closeup& closeup, const Comparison& made) const {
  const CourseDifference& d = made.differences[closeup.number];
  return window_of(closeup.sketch->box(), tip(d.b_far) - tip(d.a_far), tip(d.b_far), whole_.same().box());
}

/// Returns at most two close-ups, in the order of their differences. The greatest difference is chosen first, then the first two
/// differences. A close-up is left out if it shows no more detail than the main picture.
std::vector<const DifferencePlot::Closeup*> DifferencePlot::chosen(const Comparison& made) const {
  std::vector<const Closeup*> all;
  for (const std::size_t i : {2U, 0U, 1U}) {
    const Closeup& closeup = closeups_[i];
    const bool known = std::any_of(all.begin(), all.end(), [&](const Closeup* other) { return other->number == closeup.number; });
    if (!closeup.sketch || known || all.size() == 2 || closeup.number >= made.differences.size()) continue;
    if (window_on(closeup, made).closer) all.push_back(&closeup);
  }
  std::sort(all.begin(), all.end(), [](const Closeup* a, const Closeup* b) { return a->number < b->number; });
  return all;
}

tl::expected<void, std::string> DifferencePlot::write(const ResultFile& file, const DifferenceTitle& title, const Comparison& made) {
  finish(made.zero);
  const std::vector<const Closeup*> close = chosen(made);
  std::vector<PlotNumber> numbers;
  for (std::size_t i = 0; i < made.differences.size() && i < std::min(title.numbers, max_numbers); ++i)
    numbers.push_back(number_of(made.differences[i], i));
  for (const Closeup* const closeup : close)
    if (closeup->number >= numbers.size()) numbers.push_back(number_of(made.differences[closeup->number], closeup->number));
  const PlotPath none;
  const std::vector<Vec3> zeros = {Vec3{}};
  const PlotTitle plain = plot_title(title, made);
  const PlotDifferences layers = layers_of(whole_, numbers);
  const auto scene_of = [&](const DifferenceSketch& sketch, const PlotDifferences& differences, std::vector<PlotMark> marks) {
    return PlotScene{sketch.same(), none, zeros, std::move(marks), plain, ShadeScale(PlotColour::stroke, sketch.same()), {}, &differences};
  };
  const PlotScene scene = scene_of(whole_, layers, marks(made));
  std::deque<PlotDifferences> close_layers;
  std::vector<DifferenceCloseup> closeups;
  for (const Closeup* const closeup : close) {
    const CourseDifference& d = made.differences[closeup->number];
    const DifferenceWindow window = window_on(*closeup, made);
    const bool is_fine = whole_.error() <= window.finest;
    close_layers.push_back(layers_of(*closeup->sketch, numbers));
    closeups.push_back({is_fine ? scene_of(whole_, layers, {}) : scene_of(*closeup->sketch, close_layers.back(), {}), window.view,
                        window.box, std::to_string(closeup->number + 1) + "   " + title.place(d)});
  }
  return draw_difference_page(
      file, {scene, title.a, title.b, summary_of(made, title.lang), made.equal(), std::move(closeups), lines_of(title, made)});
}

}  // namespace kadr
