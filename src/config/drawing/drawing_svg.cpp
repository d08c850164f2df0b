// Reads SVG: the elements path, rect, circle, ellipse, line, polygon, polyline, with their transforms. Y is reversed so that it points
// upwards, and the origin is the lower left corner of the page. A page width with a unit, together with viewBox, gives the scale; without a
// unit, one user unit is 1 mm. An element or group of class "open", or with an id that begins with "open", is an edge without a wall.

#include <algorithm>
#include <cstring>
#include <optional>
#include <pugixml.hpp>

#include "base/units.h"
#include "config/drawing/drawing_svg_pen.h"

namespace kadr {
namespace {

using svg::Matrix;

constexpr int deepest_group = 100;  // greatest nesting depth of SVG groups

/// A length as a number, and the size of its unit in mm; `unit` is 0 if the text states no unit.
struct Length {
  double value = 0;
  double unit = 0;
};

std::optional<Length> length_of(const char* text) {
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (end == text || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit(end);
  constexpr struct {
    std::string_view name;
    double mm;
  } units[] = {
      {"", 0}, {"mm", 1}, {"cm", 10}, {"in", mm_per_inch}, {"pt", mm_per_inch / 72}, {"pc", mm_per_inch / 6}, {"px", mm_per_inch / 96},
      {"%", 0}};
  for (const auto& known : units)
    if (unit == known.name) return Length{value, known.mm};
  return std::nullopt;
}

/// Returns the matrix of one function of a transform list.
std::optional<Matrix> function_matrix(std::string_view name, const std::vector<double>& n) {
  const auto turned = [](double deg) {
    const SinCos t = sincos_deg(deg);
    return Matrix{t.cos, t.sin, -t.sin, t.cos, 0, 0};
  };
  if (name == "matrix" && n.size() == 6) return Matrix{n[0], n[1], n[2], n[3], n[4], n[5]};
  if (name == "translate" && (n.size() == 1 || n.size() == 2)) return Matrix{1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0};
  if (name == "scale" && (n.size() == 1 || n.size() == 2)) return Matrix{n[0], 0, 0, n.back(), 0, 0};
  if (name == "rotate" && n.size() == 1) return turned(n[0]);
  if (name == "rotate" && n.size() == 3) return Matrix{1, 0, 0, 1, n[1], n[2]} * turned(n[0]) * Matrix{1, 0, 0, 1, -n[1], -n[2]};
  if (name == "skewX" && n.size() == 1) return Matrix{1, 0, std::tan(n[0] * rad_per_deg), 1, 0, 0};
  if (name == "skewY" && n.size() == 1) return Matrix{1, std::tan(n[0] * rad_per_deg), 0, 1, 0, 0};
  return std::nullopt;
}

std::optional<Matrix> transform_of(std::string_view text) {
  Matrix all;
  for (;;) {
    const std::size_t at = text.find_first_not_of(" ,\t\r\n");
    if (at == std::string_view::npos) return all;
    const std::size_t bracket = text.find('(', at), close = text.find(')', at);
    if (bracket == std::string_view::npos || close == std::string_view::npos || close < bracket) return std::nullopt;
    std::string_view name = text.substr(at, bracket - at);
    name = name.substr(0, name.find_last_not_of(" \t\r\n") + 1);
    std::vector<double> numbers;
    if (!svg::read_numbers(text.substr(bracket + 1, close - bracket - 1), numbers)) return std::nullopt;
    const auto one = function_matrix(name, numbers);
    if (!one) return std::nullopt;
    all = all * *one;
    text.remove_prefix(close + 1);
  }
}

bool marks_open(const pugi::xml_node& node) {
  if (std::strncmp(node.attribute("id").value(), "open", 4) == 0) return true;
  const std::string padded = std::string(" ") + node.attribute("class").value() + " ";
  return padded.find(" open ") != std::string::npos;
}

class SvgReader {
 public:
  explicit SvgReader(std::string_view text) : text_(text) {}

  DrawingResult read() {
    pugi::xml_document document;
    const auto parsed =
        document.load_buffer(text_.data(), text_.size(), pugi::parse_minimal | pugi::parse_escapes | pugi::parse_wconv_attribute);
    if (!parsed) return drawing_fault(line_at(parsed.offset), alarm(AlarmId::contour_syntax, {}, parsed.description()));
    const pugi::xml_node root = document.document_element();
    if (std::strcmp(root.name(), "svg") != 0) return drawing_fault(1, alarm(AlarmId::contour_syntax, {}, root.name()));
    if (!set_page(root)) return drawing_fault(line_of(root), alarm(AlarmId::contour_unit, {}, root.attribute("width").value()));
    if (const auto wrong = children(root, page_, false, 0)) return tl::unexpected(*wrong);
    return edges_.take();
  }

 private:
  using Wrong = std::optional<DrawingFault>;

  std::uint32_t line_at(std::ptrdiff_t offset) const {
    const auto end = text_.begin() + std::min(offset, static_cast<std::ptrdiff_t>(text_.size()));
    return static_cast<std::uint32_t>(1 + std::count(text_.begin(), end, '\n'));
  }
  /// Returns the line number of a node. The nodes are visited in the order of the text, so each line end is counted once only.
  std::uint32_t line_of(const pugi::xml_node& node) {
    const std::ptrdiff_t offset = std::max(node.offset_debug(), counted_);
    line_ += static_cast<std::uint32_t>(std::count(text_.begin() + counted_, text_.begin() + offset, '\n'));
    counted_ = offset;
    return line_;
  }
  Wrong wrong(const pugi::xml_node& node, const char* text) {
    return DrawingFault{alarm(AlarmId::contour_syntax, {}, text), line_of(node)};
  }

  /// Sets the transformation of the page, which converts user units to mm and makes Y point upwards.
  bool set_page(const pugi::xml_node& root) {
    std::vector<double> box;
    if (root.attribute("viewBox") && (!svg::read_numbers(root.attribute("viewBox").value(), box) || box.size() != 4)) return false;
    const auto width = root.attribute("width") ? length_of(root.attribute("width").value()) : Length{};
    const auto height = root.attribute("height") ? length_of(root.attribute("height").value()) : Length{};
    if (!width || !height) return false;
    if (box.empty()) box = {0, 0, 0, height->value};
    double scale = width->unit > 0 ? width->unit : 1;
    if (width->unit > 0 && box[2] > 0) scale = width->value * width->unit / box[2];
    page_ = Matrix{scale, 0, 0, -scale, -scale * box[0], scale * (box[1] + box[3])};
    return scale > 0;
  }

  Wrong children(const pugi::xml_node& parent, const Matrix& matrix, bool open, int depth) {
    if (depth > deepest_group) return wrong(parent, parent.name());
    for (const pugi::xml_node& node : parent.children()) {
      const std::string_view name = node.name();
      const bool group = name == "g" || name == "svg" || name == "a";
      const bool shape = name == "path" || name == "rect" || name == "circle" || name == "ellipse" || name == "line" || name == "polygon" ||
                         name == "polyline";
      if (!group && !shape) continue;
      const auto own = transform_of(node.attribute("transform").value());
      if (!own) return wrong(node, node.attribute("transform").value());
      const bool is_open = open || marks_open(node);
      edges_.at(line_of(node));
      edges_.open(is_open);
      if (const auto fault = group ? children(node, matrix * *own, is_open, depth + 1) : draw(node, matrix * *own)) return fault;
    }
    return std::nullopt;
  }

  Wrong draw(const pugi::xml_node& node, const Matrix& matrix) {
    svg::Pen pen(edges_, matrix);
    const std::string_view name = node.name();
    const auto value = [&](const char* key) { return node.attribute(key).as_double(); };
    if (name == "path") {
      const std::string_view d = node.attribute("d").value();
      const std::size_t bad = svg::draw_path(d, pen);
      if (bad != std::string_view::npos) return wrong(node, std::string(d.substr(std::min(bad, d.size()), 24)).c_str());
    } else if (name == "circle") pen.ellipse({{value("cx"), value("cy")}, value("r"), value("r")});
    else if (name == "ellipse") pen.ellipse({{value("cx"), value("cy")}, value("rx"), value("ry")});
    else if (name == "line") pen.line({value("x1"), value("y1")}, {value("x2"), value("y2")});
    else if (name == "rect") rect(node, pen);
    else return points(node, pen, name == "polygon");
    return std::nullopt;
  }

  static void rect(const pugi::xml_node& node, svg::Pen& pen) {
    const auto value = [&](const char* key) { return node.attribute(key).as_double(); };
    const double x = value("x"), y = value("y"), w = value("width"), h = value("height");
    double rx = node.attribute("rx") ? value("rx") : value("ry"), ry = node.attribute("ry") ? value("ry") : value("rx");
    rx = std::max(0.0, std::min(rx, w / 2)), ry = std::max(0.0, std::min(ry, h / 2));
    const bool rounded_corners = rx > 0 && ry > 0;
    if (!rounded_corners) rx = ry = 0;
    const auto corner = [&](double cx, double cy, double from) {
      if (rounded_corners) pen.ellipse({{cx, cy}, rx, ry, 0, from, 90});
    };
    pen.line({x + rx, y}, {x + w - rx, y});
    corner(x + w - rx, y + ry, -90);
    pen.line({x + w, y + ry}, {x + w, y + h - ry});
    corner(x + w - rx, y + h - ry, 0);
    pen.line({x + w - rx, y + h}, {x + rx, y + h});
    corner(x + rx, y + h - ry, 90);
    pen.line({x, y + h - ry}, {x, y + ry});
    corner(x + rx, y + ry, 180);
  }

  Wrong points(const pugi::xml_node& node, svg::Pen& pen, bool closed) {
    std::vector<double> n;
    if (!svg::read_numbers(node.attribute("points").value(), n) || n.size() % 2 != 0) return wrong(node, "points");
    const std::size_t count = n.size() / 2;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
      const std::size_t j = (i + 1) % count;
      pen.line({n[2 * i], n[2 * i + 1]}, {n[2 * j], n[2 * j + 1]});
    }
    return std::nullopt;
  }

  std::string_view text_;
  Matrix page_;
  EdgeList edges_;
  std::uint32_t line_ = 1;
  std::ptrdiff_t counted_ = 0;
};

}  // namespace

DrawingResult read_svg(std::string_view text) { return SvgReader(text).read(); }

}  // namespace kadr
