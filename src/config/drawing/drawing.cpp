// Reads contours: converts drawings to edges (lines and arcs). Used by cli, config, path; tested by tests/config/drawing_test.cpp.

#include "config/drawing/drawing.h"

#include <cmath>

#include "base/tolerance.h"

namespace kadr {
namespace {

Vec2 around(Vec2 centre, double radius, double deg) {
  const SinCos turn = sincos_deg(deg);
  return centre + radius * Vec2{turn.cos, turn.sin};
}

/// Returns true if the text starts like a DXF file: with a pair of lines whose first line is a number, usually 0 or 999.
bool looks_like_dxf(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t\r\n");
  if (at == std::string_view::npos) return false;
  const std::string_view first = text.substr(at, text.find_first_of("\r\n", at) - at);
  return first == "0" || first == "999";
}

}  // namespace

void EdgeList::add(const Edge& edge) {
  if (failed_) return;
  for (const double value : {edge.from.x, edge.from.y, edge.to.x, edge.to.y})
    if (!(std::abs(value) <= limits::contour_reach)) {
      failed_ = true;
      fault_ = {alarm(AlarmId::contour_reach, {}, value, limits::contour_reach), line_};
      return;
    }
  if (!(std::abs(edge.bulge) <= 1 + tol::tangential)) {
    failed_ = true;
    fault_ = {alarm(AlarmId::contour_reach, {}, edge.bulge, 1.0), line_};
    return;
  }
  if (length(edge.to - edge.from) < tol::same_point) return;
  if (edges_.size() == limits::drawing_edges) {
    failed_ = true;
    fault_ = {alarm(AlarmId::contour_too_large, {}, double(limits::drawing_edges)), line_};
    return;
  }
  edges_.push_back(edge);
  edges_.back().line = line_;
  edges_.back().open = open_;
  if (std::abs(edge.bulge) * length(edge.to - edge.from) < tol::same_point) edges_.back().bulge = 0;
}

void EdgeList::line(Vec2 from, Vec2 to) { add({from, to}); }

void EdgeList::bulged(Vec2 from, Vec2 to, double bulge) {
  if (!(std::abs(bulge) > 1)) return add({from, to, bulge});
  const Vec2 delta = to - from;
  // Middle of the arc. Its distance from the chord (sagitta) is bulge · chord / 2.
  const Vec2 middle = 0.5 * (from + to) + (bulge / 2) * Vec2{delta.y, -delta.x};
  const double half = std::tan(std::atan(bulge) / 2);
  add({from, middle, half});
  add({middle, to, half});
}

void EdgeList::arc(Vec2 centre, double radius, double from_deg, double to_deg) {
  if (!std::isfinite(from_deg) || !std::isfinite(to_deg) || !std::isfinite(radius)) {
    // An edge with the coordinate NaN fails the check against contour_reach, so the drawing is rejected
    return add({centre, {std::nan(""), 0}});
  }
  const double sweep = std::max(-360.0, std::min(360.0, to_deg - from_deg));
  const int pieces = std::abs(sweep) > 180 ? 2 : 1;
  const double bulge = std::tan(sweep / pieces / 4 * rad_per_deg);
  for (int i = 0; i < pieces; ++i)
    add({around(centre, radius, from_deg + sweep * i / pieces), around(centre, radius, from_deg + sweep * (i + 1) / pieces), bulge});
}

void EdgeList::arc_between(Vec2 from, Vec2 to, Vec2 centre, bool ccw) {
  const double begin = angle_deg(from - centre);
  double sweep = angle_deg(to - centre) - begin;
  if (ccw && sweep <= tol::same_angle) sweep += 360;
  if (!ccw && sweep >= -tol::same_angle) sweep -= 360;
  if (std::abs(sweep) <= 180) return add({from, to, std::tan(sweep / 4 * rad_per_deg)});
  const double bulge = std::tan(sweep / 8 * rad_per_deg);
  const Vec2 middle = around(centre, length(from - centre), begin + sweep / 2);
  add({from, middle, bulge});
  add({middle, to, bulge});
}

DrawingResult EdgeList::take() {
  if (failed_) return tl::unexpected(fault_);
  if (edges_.empty()) return drawing_fault(0, alarm(AlarmId::contour_empty, {}));
  return std::move(edges_);
}

DrawingResult read_drawing(std::string_view text) {
  if (text.size() > limits::drawing_bytes) return drawing_fault(0, alarm(AlarmId::contour_too_large, {}, double(limits::drawing_edges)));
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t at = text.find_first_not_of(" \t\r\n");
  if (at != std::string_view::npos && text[at] == '<') return read_svg(text);
  return looks_like_dxf(text) ? read_dxf(text) : read_drawing_text(text);
}

}  // namespace kadr
