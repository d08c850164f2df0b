#pragma once
// SvgCanvas: an implementation of Canvas that writes SVG while the page is drawn, without a copy of the page in memory. Text remains text
// in the SVG. A stroke contains the program line from which it comes (data-line, data-file). One stroke of each line has an id by which a
// viewer finds the line: l12 for line 12 of the main program, s1l12 for line 12 of the first subprogram file.

#include <cstdio>
#include <string>

#include "config/alarm_texts.h"
#include "out/picture/canvas.h"
#include "out/trace/text_buffer.h"

namespace kadr {

/// The title and the description in the SVG.
struct PageText {
  std::string title;
  std::string description;
  Lang lang = Lang::en;
};

class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(std::FILE* file, double width, double height, const PageText& page_text);
  ~SvgCanvas() override { finish(); }

  /// Writes the end of the page. Returns the errno of a write error; 0 if there was no error.
  int finish();

  void fill(const Area& area, Colour ink) override;
  void ring(Vec2 centre, double radius, Colour ink, double width) override;
  void pixels(const Area& area, const Pixels& picture) override;
  void clip(const Area& area) override;
  void unclip() override;
  void pen(Colour ink, double width) override { pen_.ink = ink, pen_.width = width; }
  void dashes(double on, double off) override { pen_.on = on, pen_.off = off; }
  void move_to(Vec2 p) override;
  void line_to(Vec2 p) override;
  void fill_path() override;
  void stroke() override;

  void begin(const char* name) override;
  void end() override;
  void kind(const char* name) override { pen_.kind = name; }
  bool tags_lines() const override { return true; }
  void program_line(const ProgramLine& line, std::string_view file_name, bool names_it) override;

 private:
  struct Pen {
    Colour ink{0, 0, 0};
    double width = 1, on = 0, off = 0;
    std::string kind;
    friend bool operator==(const Pen&, const Pen&) = default;
  };
  void put_text(Vec2 at, const std::string& text, const TextStyle& style) override;
  void put(std::string_view text) { text_.append(text); }
  void put_escaped(std::string_view text);
  void put_element(std::string_view tag, std::string_view text);
  void take_group();
  void leave_group();

  TextBuffer text_;
  Pen pen_;
  Pen group_;  // pen of the current group: consecutive strokes with the same pen are in one group
  bool in_group_ = false;
  bool in_path_ = false;
  bool finished_ = false;
  ProgramLine line_;
  std::string file_name_;
  bool names_it_ = false;
  unsigned clips_ = 0;
};

}  // namespace kadr
