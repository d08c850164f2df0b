// Reads DXF (ASCII): LINE, ARC, CIRCLE, LWPOLYLINE, and POLYLINE with bulges, from the ENTITIES section. $INSUNITS gives the unit. An
// entity on a layer whose name begins with "open" is an edge without a wall. Other entities (texts, dimensions) are ignored.

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "base/units.h"
#include "config/drawing/drawing.h"

namespace kadr {
namespace {

struct Pair {
  int code = -1;
  std::string_view value;
  std::uint32_t line = 0;  // line number of the pair's value in the file
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

/// Returns the length in mm of a unit of $INSUNITS; 0 for a unit in which no part is drawn, so that the caller rejects it.
double unit_of(int insunits) {
  switch (insunits) {
    case 0:
    case 4: return 1;  // mm per unit; the unit 0 means "not stated", and Kadr assumes mm
    case 1: return mm_per_inch;
    case 2: return 12 * mm_per_inch;
    case 5: return 10;
    case 6: return 1000;
    case 13: return 0.001;
    default: return 0;
  }
}

bool names_open(std::string_view layer) {
  return layer.size() >= 4 && (layer[0] | 32) == 'o' && (layer[1] | 32) == 'p' && (layer[2] | 32) == 'e' && (layer[3] | 32) == 'n';
}

/// An entity while its pairs (group code and value) are read.
struct Entity {
  std::string_view type;
  std::uint32_t line = 0;
  bool open = false;
  std::map<int, double> value;  // by group code: values of the codes that occur once per entity
  struct Vertex {
    Vec2 at;
    double bulge = 0;
  };
  std::vector<Vertex> vertices;  // vertices of a polyline; used only for LWPOLYLINE
  bool closed() const { return std::fmod(of(70), 2) == 1; }
  double of(int code) const {
    const auto found = value.find(code);
    return found == value.end() ? 0 : found->second;
  }
};

class DxfReader {
 public:
  explicit DxfReader(std::string_view text) : rest_(text) {}

  DrawingResult read() {
    while (next()) {
      const auto wrong = pair_.code == 0 ? begin() : pair();
      if (wrong) return drawing_fault(pair_.line, *wrong);
      if (ended_) break;
    }
    if (fault_) return drawing_fault(line_, *fault_);
    finish();
    finish_polyline();
    return edges_.take();
  }

 private:
  std::optional<std::string_view> row() {
    if (rest_.empty()) return std::nullopt;
    const std::size_t end = rest_.find('\n');
    const std::string_view row = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    return row;
  }

  bool next() {
    const auto code = row();
    if (!code || (code->empty() && rest_.empty())) return false;
    const auto value = row();
    int number = 0;
    const auto [end, error] = std::from_chars(code->data(), code->data() + code->size(), number);
    if (error != std::errc() || end != code->data() + code->size() || !value) {
      fault_ = alarm(AlarmId::contour_syntax, {}, *code);
      return false;
    }
    pair_ = {number, *value, line_};
    return true;
  }

  std::optional<double> number() const {
    double value = 0;
    const auto [end, error] = fast_float::from_chars(pair_.value.data(), pair_.value.data() + pair_.value.size(), value);
    if (error != std::errc() || end != pair_.value.data() + pair_.value.size()) return std::nullopt;
    return value;
  }

  /// Code 0 ends the previous entity and starts the next one.
  std::optional<Alarm> begin() {
    if (entity_.type != "SECTION") finish();
    if (pair_.value == "EOF") ended_ = true;
    if (pair_.value == "ENDSEC") in_entities_ = false;
    entity_ = {pair_.value, pair_.line, false, {}, {}};
    if (pair_.value != "VERTEX") finish_polyline();
    return std::nullopt;
  }

  std::optional<Alarm> pair() {
    if (entity_.type == "SECTION" && pair_.code == 2) in_entities_ = pair_.value == "ENTITIES";
    if (pair_.code == 9) header_ = pair_.value;
    if (pair_.code == 70 && header_ == "$INSUNITS" && !in_entities_) return set_unit();
    if (!in_entities_) return std::nullopt;
    if (pair_.code == 8) entity_.open = names_open(pair_.value);
    const bool used = (pair_.code >= 10 && pair_.code <= 59) || pair_.code == 70 || pair_.code == 230;
    if (!used || !is_contour(entity_.type)) return std::nullopt;
    const auto value = number();
    if (!value) return alarm(AlarmId::contour_syntax, {}, pair_.value);
    return entity_.type == "LWPOLYLINE" ? vertex_value(*value) : (entity_.value[pair_.code] = *value, std::nullopt);
  }

  static bool is_contour(std::string_view type) {
    return type == "LINE" || type == "ARC" || type == "CIRCLE" || type == "LWPOLYLINE" || type == "POLYLINE" || type == "VERTEX";
  }

  std::optional<Alarm> set_unit() {
    header_ = {};
    const auto value = number();
    unit_ = value ? unit_of(static_cast<int>(std::max(-1.0, std::min(*value, 99.0)))) : 0;
    if (unit_ == 0) return alarm(AlarmId::contour_unit, {}, pair_.value);
    return std::nullopt;
  }

  std::optional<Alarm> vertex_value(double value) {
    auto& vertices = entity_.vertices;
    if (vertices.size() > limits::drawing_edges) return alarm(AlarmId::contour_too_large, {}, double(limits::drawing_edges));
    if (pair_.code == 10) vertices.push_back({{unit_ * value, 0}});
    else if (pair_.code == 20 && !vertices.empty()) vertices.back().at.y = unit_ * value;
    else if (pair_.code == 42 && !vertices.empty()) vertices.back().bulge = value;
    else entity_.value[pair_.code] = value;
    return std::nullopt;
  }

  Vec2 point(int x, int y) const { return {(entity_.of(230) < 0 ? -unit_ : unit_) * entity_.of(x), unit_ * entity_.of(y)}; }

  void finish() {
    if (!in_entities_ || entity_.type.empty()) return;
    edges_.at(entity_.line);
    edges_.open(entity_.open);
    const bool mirrored = entity_.of(230) < 0;  // an extrusion direction towards −Z means that X is mirrored
    if (entity_.type == "LINE")
      edges_.line({unit_ * entity_.of(10), unit_ * entity_.of(20)}, {unit_ * entity_.of(11), unit_ * entity_.of(21)});
    else if (entity_.type == "CIRCLE") edges_.arc(point(10, 20), unit_ * entity_.of(40), 0, 360);
    else if (entity_.type == "ARC") arc(mirrored);
    else if (entity_.type == "LWPOLYLINE") polyline(entity_.vertices, entity_.closed(), mirrored);
    else if (entity_.type == "POLYLINE") {
      in_polyline_ = true;
      polyline_ = entity_;
    } else if (entity_.type == "VERTEX" && in_polyline_ && polyline_.vertices.size() <= limits::drawing_edges)
      polyline_.vertices.push_back({{unit_ * entity_.of(10), unit_ * entity_.of(20)}, entity_.of(42)});
    entity_.type = {};
  }

  void arc(bool mirrored) {
    double from = entity_.of(50), to = entity_.of(51);
    if (!(std::abs(from) <= max_angle && std::abs(to) <= max_angle)) return edges_.line({}, {2 * limits::contour_reach, 0});
    while (to <= from) to += 360;
    if (mirrored) edges_.arc(point(10, 20), unit_ * entity_.of(40), 180 - from, 180 - to);
    else edges_.arc(point(10, 20), unit_ * entity_.of(40), from, to);
  }

  void finish_polyline() {
    if (!in_polyline_) return;
    in_polyline_ = false;
    edges_.at(polyline_.line);
    edges_.open(polyline_.open);
    polyline(polyline_.vertices, polyline_.closed(), polyline_.of(230) < 0);
  }

  void polyline(const std::vector<Entity::Vertex>& vertices, bool closed, bool mirrored) {
    const auto at = [&](std::size_t i) { return mirrored ? Vec2{-vertices[i].at.x, vertices[i].at.y} : vertices[i].at; };
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i)
      edges_.bulged(at(i), at((i + 1) % count), mirrored ? -vertices[i].bulge : vertices[i].bulge);
  }

  static constexpr double max_angle = 36'000;  // greatest angle of an arc, degrees; a real drawing has no arc of a hundred revolutions

  std::string_view rest_;
  std::uint32_t line_ = 0;
  Pair pair_;
  std::string_view header_;
  Entity entity_, polyline_;
  bool in_entities_ = false, in_polyline_ = false, ended_ = false;
  double unit_ = 1;
  std::optional<Alarm> fault_;
  EdgeList edges_;
};

}  // namespace

DrawingResult read_dxf(std::string_view text) { return DxfReader(text).read(); }

}  // namespace kadr
