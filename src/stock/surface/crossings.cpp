// Finds for each crossed cell edge the end of the material interval on its lattice line, and the normal there. Used by stock/surface.

#include "stock/surface/crossings.h"

#include <algorithm>
#include <cmath>

#include "stock/surface/turned_normal.h"

namespace kadr {
namespace {

struct LineEnd {
  float at;
  std::int32_t by;
  bool found = false;
  // True if the end of a material interval is between a full and an empty brick, inside the blank: neither of these bricks stores the
  // number of the sweep that cut there.
  bool seam = false;
};

/// Extent of all bodies of a tool in mm, measured from the tip.
struct ToolExtent {
  double widest, bottom, top;
};

ToolExtent extent_of(const ToolFaces& tool) {
  ToolExtent all{0, 1e30, -1e30};
  for (const BodyFaces& body : tool)
    all = {std::max(all.widest, body.widest), std::min(all.bottom, body.bottom), std::max(all.top, body.top)};
  return all;
}

}  // namespace

struct Crossings::Finder {
  /// The further intervals of one family, sorted by line. The list is built at its first use.
  class FurtherByLine {
   public:
    void forget() { made_ = false; }
    template <class Visit>
    void each(const BrickLines& lines, int line, const Visit& visit) {
      if (lines.further.empty()) return;
      if (!made_) make(lines);
      for (std::uint32_t i = first_[std::size_t(line)]; i < first_[std::size_t(line) + 1]; ++i) visit(lines.further[order_[i]]);
    }

   private:
    void make(const BrickLines& lines) {
      made_ = true;
      first_.fill(0);
      for (const FurtherInterval& f : lines.further) ++first_[std::size_t(f.line) + 1];
      for (std::size_t i = 0; i < brick_lines; ++i) first_[i + 1] += first_[i];
      order_.resize(lines.further.size());
      std::array<std::uint32_t, brick_lines + 1> next = first_;
      for (std::size_t i = 0; i < lines.further.size(); ++i) order_[next[std::size_t(lines.further[i].line)]++] = std::uint32_t(i);
    }
    bool made_ = false;
    std::array<std::uint32_t, brick_lines + 1> first_{};
    std::vector<std::uint32_t> order_;
  };

  const Stock& stock;
  const std::vector<ToolFaces>& tools;
  const BricksAround& around;
  Vec3 corner, from_lattice;  // corner of the brick in mm: in work coordinates, and relative to the lattice's corner
  float cell, edge, families_agree;
  std::array<std::array<FurtherByLine, 3>, 8> further{};

  // Numbers of the sweeps that may have cut at the faces between this brick and its neighbours; found at the first use.
  std::vector<std::uint32_t> sweeps_near{};
  bool near_known = false;

  /// Returns the directions of the sweep if the tool is tilted, else nullptr.
  const TiltedEnds* ends_of(std::int32_t by) const {
    return stock.sweep(std::size_t(by)).leans ? &stock.tilted_ends(std::size_t(by)) : nullptr;
  }
  LineEnd end_on(const LatticeEdge& e, bool leaves);
  Vec3 place_of(const LatticeEdge& e, const LineEnd& end) const;
  void find_cut(const LatticeEdge& e, bool leaves, LineEnd& end);
  void find_sweeps_near();
  Crossing crossing_at(const LatticeEdge& e, bool leaves, const LineEnd& end) const;
};

/// Returns the end of a material interval, on the lattice line of a cell edge, that is nearest to the end point of the cell edge that is
/// material. Exactly one of the two end points is material.
LineEnd Crossings::Finder::end_on(const LatticeEdge& e, bool leaves) {
  const int f = e.family, u = (f + 1) % 3, v = (f + 2) % 3;
  const auto p = [&](int axis) { return e.point[std::size_t(axis)]; };
  const float first = (float(p(f)) + 0.5f) * cell, last = first + cell;
  const int line = p(v) % brick_edge * brick_edge + p(u) % brick_edge;
  const int next_bricks = (p(u) == brick_edge) << u | (p(v) == brick_edge) << v;
  LineEnd best{}, seam{};
  float nearest = 1e30f;
  for (int half = 0; half <= int(p(f) == brick_edge - 1); ++half) {
    const std::size_t q = std::size_t(next_bricks | half << f);
    if (around.state[q] == Stock::State::empty) continue;
    const float offset = half ? edge : 0.f;
    const auto see = [&](float from, float to, std::int32_t from_by, std::int32_t to_by) {
      if (from >= to) return;
      const float at = (leaves ? to : from) + offset;
      if (at < first - families_agree || at > last + families_agree) return;
      const std::int32_t by = leaves ? to_by : from_by;
      if (leaves ? half == 0 && to >= edge : half == 1 && from <= 0) {
        seam = {at, by, true, true};
        return;
      }
      const float far = leaves ? at - first : last - at;
      if (far < nearest) nearest = far, best = {at, by, true, false};
    };
    if (around.state[q] == Stock::State::full) {
      see(0, edge, of_blank, of_blank);
      continue;
    }
    const BrickLines& lines = around.brick[q]->family[std::size_t(f)];
    see(lines.from[line], lines.to[line], lines.from_by[line], lines.to_by[line]);
    further[q][std::size_t(f)].each(lines, line, [&](const FurtherInterval& i) { see(i.from, i.to, i.from_by, i.to_by); });
  }
  LineEnd end = best.found ? best : seam;
  end.at = std::clamp(end.at, first, last);
  return end;
}

Vec3 Crossings::Finder::place_of(const LatticeEdge& e, const LineEnd& end) const {
  Vec3 at;
  for (int d = 0; d < 3; ++d) along(at, d) = d == e.family ? double(end.at) : (e.point[std::size_t(d)] + 0.5) * double(cell);
  return at;
}

/// Finds the sweeps that may have cut in or next to the brick. The boxes around the paths of the sweeps decide.
void Crossings::Finder::find_sweeps_near() {
  near_known = true;
  std::vector<ToolExtent> extents;
  for (const ToolFaces& tool : tools) extents.push_back(extent_of(tool));
  const double room = double(cell), reach = double(edge) + room;
  stock.each_sweep([&](std::size_t i, const KeptSweep& s) {
    const ToolExtent& tool = extents[s.tool];
    // Sweeps of turning tools are not searched, so an end of an interval between two bricks keeps the number of_blank, as if no sweep had
    // cut there.
    bool near = !stock.tool(s.tool).turns();
    // Extent of the tool for any direction of its axis.
    const double anywhere = std::max({tool.widest, std::fabs(tool.bottom), std::fabs(tool.top)}) + tool.widest;
    for (int d = 0; d < 3 && near; ++d) {
      const double least = double(std::min(s.from[d], s.to[d])) + (s.leans ? -anywhere : d == 2 ? tool.bottom : -tool.widest);
      const double most = double(std::max(s.from[d], s.to[d])) + (s.leans ? anywhere : d == 2 ? tool.top : tool.widest);
      near = least <= along(from_lattice, d) + reach && most >= along(from_lattice, d) - room;
    }
    if (near) sweeps_near.push_back(std::uint32_t(i));
  });
}

/// Finds the sweep that cut an end of material between two bricks. Such an end belongs to the blank only if the blank ends there. Otherwise
/// a sweep cut there, but an emptied brick no longer stores the sweep's number: the first sweep that cut there is used.
void Crossings::Finder::find_cut(const LatticeEdge& e, bool leaves, LineEnd& end) {
  const Vec3 at = place_of(e, end), in_space = at + corner;
  std::vector<LineRange> ranges;
  stock.blank().cross(e.family, along(in_space, (e.family + 1) % 3), along(in_space, (e.family + 2) % 3), ranges);
  end.seam = std::none_of(ranges.begin(), ranges.end(), [&](const LineRange& r) {
    return std::fabs((leaves ? r.to : r.from) - along(in_space, e.family)) < double(families_agree);
  });
  if (!end.seam) return;
  if (!near_known) find_sweeps_near();
  for (const std::uint32_t i : sweeps_near) {
    const KeptSweep sweep = stock.sweep(i);
    if (!cut_at(sweep, tools[sweep.tool], {at + from_lattice, e.family, leaves}, ends_of(std::int32_t(i)))) continue;
    end.by = std::int32_t(i);
    return;
  }
}

Crossing Crossings::Finder::crossing_at(const LatticeEdge& e, bool leaves, const LineEnd& end) const {
  const Vec3 at = place_of(e, end);
  Vec3 normal;
  if (end.by == of_blank) {
    if (end.seam) along(normal, e.family) = leaves ? 1 : -1;
    else normal = stock.blank().normal(at + corner, e.family, leaves);
  } else {
    const KeptSweep sweep = stock.sweep(std::size_t(end.by));
    const CutPlace place{at + from_lattice, e.family, leaves};
    const ToolShape& tool = stock.tool(sweep.tool);
    normal = tool.turns() ? turned_normal(sweep, tool, place, stock.lattice().origin())
                          : cut_normal(sweep, tools[sweep.tool], place, ends_of(end.by));
  }
  return {{float(at.x), float(at.y), float(at.z)}, {float(normal.x), float(normal.y), float(normal.z)}, end.by};
}

Crossings::Crossings() : slots_(std::size_t(3) * signs_edge * signs_edge * signs_edge) {}

void Crossings::take(const Stock& stock, const std::vector<ToolFaces>& tools, std::size_t brick, const BricksAround& around,
                     const BrickSigns& signs) {
  const Lattice& lattice = stock.lattice();
  all_.clear();
  lost_.clear();
  const Vec3 corner = lattice.corner(brick);
  Finder finder{
      stock, tools, around, corner, corner - lattice.origin(), float(lattice.cell()), float(lattice.edge()), stock.families_agree()};
  each_unlike_edge(signs, brick_edge, [&](const LatticeEdge& e, bool leaves) {
    LineEnd end = finder.end_on(e, leaves);
    if (!end.found) {
      end = {(float(e.point[std::size_t(e.family)]) + 1.f) * finder.cell, of_blank, false, true};
      lost_.push_back(e);
    }
    if (end.seam && end.by == of_blank) finder.find_cut(e, leaves, end);
    slots_[slot_of(e)] = std::uint16_t(all_.size());
    all_.push_back(finder.crossing_at(e, leaves, end));
  });
  for (const LatticeEdge& e : lost_) mend(e, signs);
}

/// Completes a crossing on whose lattice line no interval of material ends. A line that lies in a surface may be cut away although the
/// lines along Z close to it are not cut away. In this case the crossing of an adjacent cell edge, with material on the same side, is used.
void Crossings::mend(const LatticeEdge& e, const BrickSigns& signs) {
  const std::size_t f = std::size_t(e.family);
  const auto sign = [&](const std::array<int, 3>& p) { return signs.at(p[0], p[1], p[2]); };
  for (std::size_t turn = 1; turn < 3; ++turn)
    for (const int step : {-1, 1}) {
      LatticeEdge neighbour = e;
      int& place = neighbour.point[(f + turn) % 3];
      place += step;
      if (place < 0 || place > brick_edge) continue;
      std::array<int, 3> end = neighbour.point, own_end = e.point;
      ++end[f], ++own_end[f];
      if (sign(neighbour.point) == sign(end) || sign(neighbour.point) != sign(e.point)) continue;
      const bool lost =
          std::any_of(lost_.begin(), lost_.end(), [&](const LatticeEdge& l) { return l.family == e.family && l.point == neighbour.point; });
      if (lost) continue;
      const Crossing& like = of(neighbour);
      Crossing& own = all_[slots_[slot_of(e)]];
      own.at[f] = like.at[f], own.normal = like.normal, own.by = like.by;
      return;
    }
}

}  // namespace kadr
