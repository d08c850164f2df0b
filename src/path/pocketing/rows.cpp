// This file computes parallel passes (rows of the schemes zigzag and comb), clipped by the boundary loops of a field. A section of the
// boundary joins two consecutive crossings of rows with a loop. Neighbouring rows whose ends are joined by such sections form a cell. A
// cell is cut without lifting the tool: along a row, along the boundary, and along the next row.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "path/pocketing/milling_passes.h"

namespace kadr::area {
namespace {

// Distance, mm, of the first and the last row from the border of the area. It makes these rows cross the loops.
constexpr double nudge = 2e-5;

/// A point at which a row crosses a loop.
struct Crossing {
  double x = 0;
  std::size_t loop = 0, edge = 0;
  double part = 0;
  std::size_t next = 0;  // index of the next crossing along the boundary loop
};
struct Span {
  std::size_t left = 0, right = 0;  // indices of the crossings at the left end and the right end of the row
  std::size_t above = none, below = none;
  bool done = false;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// Appends an edge. An arc is divided into pieces along which y only rises or only falls.
void add_monotone(Edges& loop, const Edge& e) {
  if (is_line(e)) {
    loop.push_back(e);
    return;
  }
  const Circle c = circle_of(e);
  std::vector<double> cuts{0, 1};
  for (const double side : {1.0, -1.0}) {
    const double part = nearest_part(e, c.centre + Vec2{0, side * c.radius});
    if (part > tol::tangential && part < 1 - tol::tangential) cuts.push_back(part);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) loop.push_back(section(e, cuts[i - 1], cuts[i]));
}

class Rows {
 public:
  Rows(const Field& field, const Job& job, double inset) : field_(field), job_(job), follow_(inset <= 0) {
    std::vector<Edges> loops = field.reach;
    if (inset > 0) loops = inner_loops(inset);
    for (const Edges& loop : loops) {
      loops_.emplace_back();
      for (const Edge& e : loop) add_monotone(loops_.back(), area::rotated(e, -job.angle));
    }
    for (const Edges& loop : field.work)
      for (const Edge& e : loop) range_.take(area::rotated(e, -job.angle));
    if (inset > 0) {
      range_.least.y += inset;
      range_.most.y -= inset;
    }
    for (const Edge& e : field.walls) walls_.push_back(area::rotated(e, -job.angle));
  }

  Result<Passes> passes() {
    if (const double height = range_.most.y - range_.least.y; height > job_.step * double(max_passes))
      return fail(alarm(AlarmId::mill_too_long, {}, double(max_passes)));
    cross_all();
    link_crossings();
    link_spans();
    Passes passes = comb() ? comb_passes() : zigzag_passes();
    for (Pass& pass : passes)
      for (Edge& e : pass.path) e = area::rotated(e, job_.angle);
    return passes;
  }

 private:
  bool comb() const { return job_.scheme >= Scheme::comb; }

  std::vector<Edges> inner_loops(double inset) const {
    Carriers carriers;
    for (const Edges& loop : field_.reach) carriers.add(loop, inset);
    std::vector<Edges> loops;
    for (const Polygon& p : grown(field_.reach_area, -inset, tol::area_chord))
      if (Edges loop = carriers.recovered(p, true); loop.size() > 1) loops.push_back(std::move(loop));
    return loops;
  }

  static double crossing_part(const Edge& e, double y) {
    if (is_line(e)) return (y - e.from.y) / (e.to.y - e.from.y);
    const Circle c = circle_of(e);
    const double up = y - c.centre.y, half = std::sqrt(std::max(0.0, (c.radius - up) * (c.radius + up)));
    const double side = at(e, 0.5).x > c.centre.x ? 1 : -1;
    return nearest_part(e, {c.centre.x + side * half, y});
  }

  void cross_row(double y) {
    std::vector<std::size_t> row;
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t i = 0; i < loops_[l].size(); ++i) {
        const Edge& e = loops_[l][i];
        if ((e.from.y > y) == (e.to.y > y)) continue;
        const double part = crossing_part(e, y);
        row.push_back(crossings_.size());
        crossings_.push_back({at(e, part).x, l, i, part, 0});
      }
    std::sort(row.begin(), row.end(), [&](std::size_t a, std::size_t b) { return crossings_[a].x < crossings_[b].x; });
    rows_.emplace_back();
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      rows_.back().push_back(spans_.size());
      spans_.push_back({row[i], row[i + 1]});
    }
  }

  void cross_all() {
    const double height = range_.most.y - range_.least.y;
    if (!(height > 2 * nudge)) return cross_row(0.5 * (range_.least.y + range_.most.y));
    const int count = std::max(1, static_cast<int>(std::ceil(height / job_.step - tol::tangential)));
    for (int i = 0; i <= count && !job_.watch.stop.requested(); ++i)
      cross_row(std::clamp(range_.least.y + height * i / count, range_.least.y + nudge, range_.most.y - nudge));
  }

  void link_crossings() {
    std::vector<std::size_t> order(crossings_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto place = [&](std::size_t i) { return std::tuple(crossings_[i].loop, crossings_[i].edge, crossings_[i].part); };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    for (std::size_t begin = 0; begin < order.size();) {
      std::size_t end = begin;
      while (end < order.size() && crossings_[order[end]].loop == crossings_[order[begin]].loop) ++end;
      for (std::size_t i = begin; i < end; ++i) crossings_[order[i]].next = order[i + 1 < end ? i + 1 : begin];
      begin = end;
    }
  }

  /// Links neighbouring rows. The zone is on the left of its loops. A loop therefore leads upwards at the right end of a row, and downwards
  /// at the left end of a row.
  void link_spans() {
    for (std::size_t r = 0; r + 1 < rows_.size(); ++r)
      for (const std::size_t low : rows_[r])
        for (const std::size_t high : rows_[r + 1])
          if (crossings_[spans_[low].right].next == spans_[high].right && crossings_[spans_[high].left].next == spans_[low].left) {
            spans_[low].above = high;
            spans_[high].below = low;
          }
  }

  Vec2 point(std::size_t crossing) const {
    const Crossing& c = crossings_[crossing];
    return at(loops_[c.loop][c.edge], c.part);
  }

  /// Returns the section of the boundary from a crossing to the next crossing along the loop.
  Edges boundary(std::size_t from) const {
    const Crossing &a = crossings_[from], &b = crossings_[a.next];
    const Edges& loop = loops_[a.loop];
    if (a.edge == b.edge && a.part < b.part) return {section(loop[a.edge], a.part, b.part)};
    Edges path{section(loop[a.edge], a.part, 1)};
    for (std::size_t i = (a.edge + 1) % loop.size(); i != b.edge; i = (i + 1) % loop.size()) path.push_back(loop[i]);
    path.push_back(section(loop[b.edge], 0, b.part));
    std::erase_if(path, [](const Edge& e) { return length(e.to - e.from) < tol::same_point; });
    return path;
  }

  /// Returns the section of the boundary between the right or the left ends of two neighbouring rows. The section is traversed upwards if
  /// `up` is true, otherwise downwards.
  Edges side(std::size_t low, std::size_t high, bool right, bool up) const {
    Edges path = boundary(right ? spans_[low].right : spans_[high].left);
    return right == up ? path : reversed(path);
  }

  bool along_wall(const Edges& path) const {
    const double near = job_.radius + job_.allowance + tol::contour_gap;
    for (const Edge& e : path)
      for (const Edge& wall : walls_)
        if (distance(wall, at(e, 0.5)) < near) return true;
    return false;
  }

  static void append(Edges& path, const Edges& more) { path.insert(path.end(), more.begin(), more.end()); }
  Edges row(std::size_t span, bool rightwards) const {
    const Vec2 left = point(spans_[span].left), right = point(spans_[span].right);
    return {rightwards ? Edge{left, right} : Edge{right, left}};
  }

  Vec2 begin_of(std::size_t span, bool rightwards) const { return point(rightwards ? spans_[span].left : spans_[span].right); }
  bool holds_turned(Edges path) const {
    for (Edge& e : path) e = area::rotated(e, job_.angle);
    return path.empty() || holds(field_, path);
  }

  /// Returns all rows of the cell that contains the row `span`, from the lowest row to the highest.
  std::vector<std::size_t> cell_of(std::size_t span) {
    while (spans_[span].below != Span::none) span = spans_[span].below;
    std::vector<std::size_t> cell;
    for (; span != Span::none; span = spans_[span].above) {
      spans_[span].done = true;
      cell.push_back(span);
    }
    return cell;
  }

  /// Returns the path that cuts the rows of a cell back and forth. If the rows are joined along the boundary, the boundary is cut at both
  /// ends of each row.
  Edges through(const std::vector<std::size_t>& cell, bool up, bool right) const {
    Edges path;
    for (std::size_t i = 0; i < cell.size() && !job_.watch.stop.requested(); ++i, right = !right) {
      job_.watch.report_progress(Stage::passes, double(i) / double(cell.size()));
      const auto link = [&](std::size_t from, std::size_t to, bool at_right) { return side(up ? from : to, up ? to : from, at_right, up); };
      append(path, row(cell[i], right));
      if (follow_ && i > 0)
        if (const Edges back = link(cell[i - 1], cell[i], right); along_wall(back)) {
          append(path, reversed(back));
          append(path, back);
        }
      if (i + 1 == cell.size()) break;
      const Edges straight{{path.back().to, begin_of(cell[i + 1], !right)}};
      append(path, !follow_ && holds_turned(straight) ? straight : link(cell[i], cell[i + 1], right));
    }
    return path;
  }

  /// Returns the zigzag passes. Of the cells that are not cut yet, the cell whose start is nearest to the tool is cut next.
  Passes zigzag_passes() {
    Passes passes;
    Vec2 here{job_.direction == Direction::ccw ? range_.most.x : range_.least.x, range_.least.y};
    for (;;) {
      double least = 1e300;
      std::size_t best = Span::none;
      bool up = true, right = true;
      for (std::size_t s = 0; s < spans_.size(); ++s) {
        if (spans_[s].done || (spans_[s].below != Span::none && spans_[s].above != Span::none)) continue;
        for (const bool from_left : {true, false}) {
          const double far = length(point(from_left ? spans_[s].left : spans_[s].right) - here);
          if (far < least - tol::same_point) least = far, best = s, up = spans_[s].below == Span::none, right = from_left;
        }
      }
      if (best == Span::none) return passes;
      std::vector<std::size_t> cell = cell_of(best);
      if (!up) std::reverse(cell.begin(), cell.end());
      passes.push_back({through(cell, up, right)});
      here = passes.back().path.back().to;
    }
  }

  /// Returns the comb passes. In climb milling the uncut material is on the right of the tool, so the tool cuts each row to the left, and
  /// the rows follow each other upwards.
  Passes comb_passes() {
    const bool right = job_.direction == Direction::cw;
    Passes passes;
    for (std::size_t s = 0; s < spans_.size(); ++s) {
      if (spans_[s].done) continue;
      const std::vector<std::size_t> cell = cell_of(s);
      for (std::size_t i = 0; i < cell.size() && !job_.watch.stop.requested(); ++i) {
        job_.watch.report_progress(Stage::passes, double(passes.size()) / double(spans_.size()));
        Edges path;  // The tool moves down at the start of the previous row, where no material is left.
        if (i > 0 && follow_) path = side(cell[i - 1], cell[i], !right, true);
        else if (i > 0) path = {{begin_of(cell[i - 1], right), begin_of(cell[i], right)}};
        if (!holds_turned(path)) path.clear();
        append(path, row(cell[i], right));
        if (i > 0 && follow_)
          if (const Edges back = side(cell[i - 1], cell[i], right, false); along_wall(back)) append(path, back);
        passes.push_back({path, false, true});
      }
    }
    return passes;
  }

  const Field& field_;
  const Job& job_;
  bool follow_;
  std::vector<Edges> loops_;
  Edges walls_;
  Bounds range_;
  std::vector<Crossing> crossings_;
  std::vector<Span> spans_;
  std::vector<std::vector<std::size_t>> rows_;
};

}  // namespace

Result<Passes> row_passes(const Field& field, const Job& job, double inset) { return Rows(field, job, inset).passes(); }

}  // namespace kadr::area
