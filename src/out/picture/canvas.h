#pragma once
// Canvas: the interface for drawing strokes, areas and texts, in the order of the calls. It has two implementations:
// out/picture/svg_canvas writes SVG while drawing, out/picture/cairo_canvas draws pixels.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace kadr {

struct Colour {
  double red, green, blue;
  double alpha = 1;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// 0xRRGGBB
constexpr Colour colour(unsigned rgb, double alpha = 1) {
  return {double(rgb >> 16 & 0xFF) / 255, double(rgb >> 8 & 0xFF) / 255, double(rgb & 0xFF) / 255, alpha};
}

/// A rectangle of the page; y points downwards.
struct Area {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

enum class Align { left, centre, right };

struct TextStyle {
  double size = 13;
  Colour ink = colour(0x20262E);
  Align align = Align::left;
  bool bold = false;
};

/// A line of a program file, from which a drawn stroke comes.
struct ProgramLine {
  std::uint32_t line = 0;  // line number, counted from 1; 0: the stroke comes from no program line
  std::uint16_t file = 0;  // Origin::file
  friend bool operator==(const ProgramLine&, const ProgramLine&) = default;
};

/// A finished pixel image. The pixels are stored row by row from the top. A pixel is 0xAARRGGBB, and its colours are already multiplied by
/// A / 255.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint32_t> argb;
};

class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  virtual void fill(const Area& area, Colour ink) = 0;
  void frame(const Area& area, Colour ink, double width = 1);
  void line(Vec2 a, Vec2 b, Colour ink, double width = 1);
  /// Draws UTF-8 text. Characters that cannot be shown are replaced.
  void text(Vec2 at, std::string_view text, const TextStyle& style);
  virtual void ring(Vec2 centre, double radius, Colour ink, double width) = 0;
  void zero_mark(Vec2 centre, double radius, Colour ink);
  void arrow(Vec2 from, Vec2 to, Colour ink, double width);

  /// Draws a pixel image, scaled so that it fills the area.
  virtual void pixels(const Area& area, const Pixels& picture) = 0;

  virtual void clip(const Area& area) = 0;
  virtual void unclip() = 0;

  /// Sets the colour and the width of all strokes that follow, until the next call.
  virtual void pen(Colour ink, double width) = 0;
  virtual void dashes(double on, double off) = 0;
  void solid() { dashes(0, 0); }
  virtual void move_to(Vec2 p) = 0;
  virtual void line_to(Vec2 p) = 0;
  /// Closes the path and fills it.
  virtual void fill_path() = 0;
  virtual void stroke() = 0;

  // ---- structure of the page that only an SVG stores; for pixel images these functions do nothing

  /// Begins a group of strokes with a name, e.g. "view-xy".
  virtual void begin(const char* /*name*/) {}
  virtual void end() {}
  /// Sets a type of motion, such as "rapid", as the name of all strokes that follow. An empty text means that the strokes have no name.
  virtual void kind(const char* /*name*/) {}
  /// True if the canvas stores the program line of each stroke. Then strokes of different lines must not be joined.
  virtual bool tags_lines() const { return false; }
  /// Sets the program line of the strokes that follow.
  ///   file_name  name of the subprogram file that contains the line
  ///   names_it   true: the next stroke gets the id by which a viewer finds the line
  virtual void program_line(const ProgramLine& /*line*/, std::string_view /*file_name*/, bool /*names_it*/) {}

 private:
  virtual void put_text(Vec2 at, const std::string& text, const TextStyle& style) = 0;
};

}  // namespace kadr
