// SvgCanvas: writes a page as SVG while the page is drawn, without a copy of the page in memory. It is used by out/text/page_file.

#include "out/picture/svg_canvas.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/texts.h"
#include "out/picture/cairo_canvas.h"
#include "out/picture/text_width.h"
#include "out/text/base64.h"

namespace kadr {
namespace {

constexpr double farthest = 1e7;  // units of the page: points farther away are not visible, so their coordinates are limited
constexpr int hundredths = 100;   // number of coordinate steps per unit: 0.01 unit is finer than a screen shows at a zoom of 50 times

/// Writes a coordinate without zeros at its end.
char* put_coordinate(char* at, double value) {
  auto n = static_cast<std::int64_t>(std::lround(std::clamp(value, -farthest, farthest) * hundredths));
  if (n < 0) *at++ = '-', n = -n;
  at = fmt::format_to(at, FMT_COMPILE("{}"), n / hundredths);
  const auto rest = static_cast<int>(n % hundredths);
  if (rest == 0) return at;
  *at++ = '.';
  *at++ = static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) *at++ = static_cast<char>('0' + rest % 10);
  return at;
}

std::string svg_number(double value) {
  char room[32];
  return {room, put_coordinate(room, value)};
}

std::string hex(Colour ink) {
  const auto part = [](double value) { return static_cast<unsigned>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(ink.red), part(ink.green), part(ink.blue));
}

/// Returns the SVG attributes of a colour, e.g. ` fill="#0072b2" fill-opacity="0.14"`.
std::string ink_attributes(const char* what, Colour ink) {
  const std::string attribute = fmt::format(" {}=\"{}\"", what, hex(ink));
  return ink.alpha < 1 ? attribute + fmt::format(" {}-opacity=\"{}\"", what, svg_number(ink.alpha)) : attribute;
}

}  // namespace

SvgCanvas::SvgCanvas(std::FILE* file, double width, double height, const PageText& page_text) : text_(file) {
  put(
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" xml:lang=\"{2}\""
                  " font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
                  svg_number(width), svg_number(height), id_of(page_text.lang)));
  put_element("title", page_text.title);
  put_element("desc", page_text.description);
}

int SvgCanvas::finish() {
  if (!finished_) {
    leave_group();
    put("</svg>\n");
    text_.flush();
  }
  finished_ = true;
  return text_.error();
}

void SvgCanvas::put_element(std::string_view tag, std::string_view text) {
  if (text.empty()) return;
  put(fmt::format("<{}>", tag));
  put_escaped(printable(text));
  put(fmt::format("</{}>\n", tag));
}

void SvgCanvas::put_escaped(std::string_view text) {
  while (!text.empty()) {
    const std::size_t plain = std::min(text.find_first_of("<>&\""), text.size());
    put(text.substr(0, plain));
    if (plain == text.size()) return;
    put(text[plain] == '<' ? "&lt;" : text[plain] == '>' ? "&gt;" : text[plain] == '&' ? "&amp;" : "&quot;");
    text.remove_prefix(plain + 1);
  }
}

void SvgCanvas::take_group() {
  if (in_group_ && group_ == pen_) return;
  leave_group();
  group_ = pen_;
  in_group_ = true;
  put("<g");
  if (!pen_.kind.empty()) put(fmt::format(" class=\"{}\"", pen_.kind));
  put(" fill=\"none\"" + ink_attributes("stroke", pen_.ink));
  put(fmt::format(" stroke-width=\"{}\"", svg_number(pen_.width)));
  if (pen_.on > 0) put(fmt::format(" stroke-dasharray=\"{} {}\"", svg_number(pen_.on), svg_number(pen_.off)));
  put(">\n");
}

void SvgCanvas::leave_group() {
  if (in_group_) put("</g>\n");
  in_group_ = false;
}

void SvgCanvas::fill(const Area& area, Colour ink) {
  leave_group();
  put(fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", svg_number(area.x), svg_number(area.y),
                  svg_number(area.width), svg_number(area.height), ink_attributes("fill", ink)));
}

void SvgCanvas::ring(Vec2 centre, double radius, Colour ink, double width) {
  pen(ink, width);
  take_group();
  put(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", svg_number(centre.x), svg_number(centre.y), svg_number(radius)));
}

void SvgCanvas::pixels(const Area& area, const Pixels& picture) {
  leave_group();
  put(fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"data:image/png;base64,", svg_number(area.x),
                  svg_number(area.y), svg_number(area.width), svg_number(area.height)));
  put(base64_of(png_of(picture)));
  put("\"/>\n");
}

void SvgCanvas::clip(const Area& area) {
  leave_group();
  put(
      fmt::format("<clipPath id=\"clip{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\n"
                  "<g clip-path=\"url(#clip{0})\">\n",
                  ++clips_, svg_number(area.x), svg_number(area.y), svg_number(area.width), svg_number(area.height)));
}

void SvgCanvas::unclip() {
  leave_group();
  put("</g>\n");
}

void SvgCanvas::begin(const char* name) {
  leave_group();
  put(fmt::format("<g id=\"{}\">\n", name));
}

void SvgCanvas::end() { unclip(); }

void SvgCanvas::program_line(const ProgramLine& line, std::string_view file_name, bool names_it) {
  line_ = line;
  names_it_ = names_it;
  if (file_name_ != file_name) file_name_ = file_name;
}

void SvgCanvas::move_to(Vec2 p) {
  constexpr std::size_t most = 64;  // greatest number of characters of a point's coordinates in the SVG
  if (!in_path_) {
    take_group();
    put("<path d=\"");
    in_path_ = true;
  }
  char* at = text_.room(most);
  *at++ = 'M';
  at = put_coordinate(at, p.x);
  *at++ = ' ';
  text_.done(put_coordinate(at, p.y));
}

void SvgCanvas::line_to(Vec2 p) {
  constexpr std::size_t most = 64;
  char* at = text_.room(most);
  *at++ = ' ';
  at = put_coordinate(at, p.x);
  *at++ = ' ';
  text_.done(put_coordinate(at, p.y));
}

void SvgCanvas::fill_path() {
  put(fmt::format("Z\"{} stroke=\"none\"/>\n", ink_attributes("fill", pen_.ink)));
  in_path_ = false;
}

void SvgCanvas::stroke() {
  put("\"");
  if (line_.line != 0) {
    if (names_it_) {
      if (line_.file == 0) put(fmt::format(" id=\"l{}\"", line_.line));
      else put(fmt::format(" id=\"s{}l{}\"", line_.file, line_.line));
    }
    put(fmt::format(" data-line=\"{}\"", line_.line));
    if (line_.file != 0) {
      put(" data-file=\"");
      put_escaped(printable(file_name_));
      put("\"");
    }
  }
  put("/>\n");
  in_path_ = false;
}

void SvgCanvas::put_text(Vec2 at, const std::string& text, const TextStyle& style) {
  leave_group();
  const bool spaced = text.find("  ") != std::string::npos;
  put(fmt::format("<text{} x=\"{}\" y=\"{}\" font-size=\"{}\"{}{}{}>", spaced ? " xml:space=\"preserve\"" : "", svg_number(at.x),
                  svg_number(at.y), svg_number(style.size),
                  style.align == Align::centre  ? " text-anchor=\"middle\""
                  : style.align == Align::right ? " text-anchor=\"end\""
                                                : "",
                  style.bold ? " font-weight=\"bold\"" : "", ink_attributes("fill", style.ink)));
  put_escaped(text);
  put("</text>\n");
}

}  // namespace kadr
