// Part program: converts moves to the text of a program for one control, with the control's word formats and code table (ControlDef).
// Compares the moves with those that the control executes from the text. This file is used by cli/mill and tested by
// tests/out/part_program_test.cpp.

#include "out/program/part_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/tolerance.h"
#include "out/program/codes.h"
#include "out/program/klartext_part.h"
#include "out/program/words.h"
#include "path/pocketing/edge.h"

namespace kadr {
namespace {

using area::Move;
using area::MoveKind;

// greatest distance between an arc and the lines that replace it, mm: half of the controls' arc tolerance
constexpr double written_chord = 0.005;
constexpr double shortest_arc = 10;  // length of an arc in least increments below which a line replaces the arc
constexpr int block_steps[] = {10, 5, 1};

constexpr int any = any_argument;

class ProgramWriter {
 public:
  ProgramWriter(const ControlDef& def, const Technology& technology) : def_(def), technology_(technology) {}

  Result<PartProgram> write(const std::vector<Move>& moves) {
    KADR_TRY(begin());
    for (const Move& move : moves) KADR_TRY(motion(move));
    KADR_TRY(finish());
    KADR_TRY(number_blocks());
    return PartProgram{std::move(text_), std::move(written_)};
  }

  Result<std::string> write_bare() {
    std::string modes;
    if (def_.behaviour.lathe == Lathe::none) {
      want({{Function::plane_xy, any}, {Function::select_plane, 17}}, modes);
      want({{Function::absolute, any}}, modes);
    } else {
      want({{Function::plane_zx, any}, {Function::select_plane, 18}}, modes);
    }
    want({{Function::millimetre, any}}, modes);
    want({{Function::feed_per_minute, any}}, modes);
    put(modes);
    KADR_TRY(finish());
    KADR_TRY(number_blocks());
    return std::move(text_);
  }

 private:
  Status need(std::initializer_list<FunctionArg> functions, std::string& block) {
    const auto code = code_of(def_, functions);
    if (!code) return fail(alarm(AlarmId::function_has_no_code, {}, traits_of(functions.begin()->first).name));
    add(block, *code);
    return {};
  }
  void want(std::initializer_list<FunctionArg> functions, std::string& block) {
    if (const auto code = code_of(def_, functions)) add(block, *code);
  }
  static void add(std::string& block, std::string_view word) {
    if (!block.empty()) block += ' ';
    block += word;
  }
  /// Appends the word of a feed or a speed. The number of the word is the value itself, or, if the control has a table of codes for such
  /// values, the code of the value.
  Status coded(std::string& block, char letter, const std::map<std::int32_t, double>& codes, double value) {
    if (codes.empty()) return word(block, letter, value);
    const auto code = code_below(codes, value);
    if (!code) return fail(alarm(AlarmId::word_has_no_room, {}, letter, value));
    return word(block, letter, *code);
  }
  Status word(std::string& block, char letter, double value) {
    const auto text = Words(def_, letter).word(value);
    if (!text) return fail(text.error());
    add(block, *text);
    return {};
  }
  void put(const std::string& block) {
    if (!block.empty()) blocks_.push_back(block);
  }

  Status begin() {
    std::string plane, codes;
    KADR_TRY(need({{Function::plane_xy, any}, {Function::select_plane, 17}}, plane));
    KADR_TRY(need({{Function::absolute, any}}, plane));
    put(plane);
    want({{Function::millimetre, any}}, codes);
    want({{Function::feed_per_minute, any}}, codes);
    if (def_.behaviour.arc_centers == ArcCenters::by_code) KADR_TRY(need({{Function::centers_incremental, any}}, codes));
    put(codes);
    std::string tool, spindle;
    if (technology_.tool > 0) {
      KADR_TRY(tool_word(tool));
      want({{Function::change_tool, any}, {Function::exchange_tool, any}}, tool);
      put(tool);
    }
    if (technology_.speed > 0) {
      KADR_TRY(coded(spindle, 'S', def_.speed_codes, technology_.speed));
      KADR_TRY(need({{Function::spindle_cw, any}, {Function::spindle_code, 3}}, spindle));
      put(spindle);
    }
    std::string coolant;
    if (technology_.coolant) KADR_TRY(need({{Function::coolant_flood, any}}, coolant));
    put(coolant);
    return {};
  }

  Status tool_word(std::string& block) {
    // factor between tool number and offset number in one word: T0404 is tool 4 with offset number 4
    constexpr double corrector_digits = 100;
    return word(block, 'T', def_.behaviour.tool_and_corrector ? technology_.tool * (corrector_digits + 1) : technology_.tool);
  }

  Status finish() {
    std::string coolant, spindle, end;
    if (technology_.coolant) want({{Function::coolant_off, any}}, coolant);
    put(coolant);
    if (technology_.speed > 0) want({{Function::spindle_stop, any}, {Function::spindle_code, 5}}, spindle);
    put(spindle);
    KADR_TRY(need({{Function::program_end, any}}, end));
    put(end);
    return {};
  }

  Vec3 rounded(Vec3 p) const { return {Words(def_, 'X').rounded(p.x), Words(def_, 'Y').rounded(p.y), Words(def_, 'Z').rounded(p.z)}; }

  Status motion(const Move& move) {
    const Vec3 to = rounded(move.to);
    if (written_.empty()) return first(to);
    if (move.bulge == 0) return line({move.kind, to});
    const Edge arc{{at_.x, at_.y}, {to.x, to.y}, move.bulge};
    const double increment = Words(def_, 'X').increment();
    if (area::length_of(arc) < shortest_arc * increment || length(arc.to - arc.from) < increment) return line({move.kind, to});
    const Vec2 centre = written_centre(arc);
    const double off = std::abs(length(arc.to - centre) - length(arc.from - centre));
    const bool fits =
        Words(def_, 'I').word(centre_value(centre.x, arc.from.x)) && Words(def_, 'J').word(centre_value(centre.y, arc.from.y));
    if (!fits || off > def_.behaviour.arc_radius_difference / 2) return chords(move, arc);
    return circular(move, arc, centre);
  }

  Status chords(const Move& move, const Edge& arc) {
    const double radius = area::circle_of(arc).radius;
    const double step = 2 * std::acos(std::max(0.5, 1 - written_chord / radius));
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(4 * std::atan(arc.bulge)) / step)));
    for (int i = 1; i <= pieces; ++i) {
      const Vec2 p = area::at(arc, double(i) / pieces);
      KADR_TRY(line({move.kind, rounded({p.x, p.y, move.to.z})}));
    }
    return {};
  }

  bool centres_absolute() const { return def_.behaviour.arc_centers == ArcCenters::as_distance; }
  double centre_value(double centre, double from) const { return centres_absolute() ? centre : centre - from; }
  Vec2 written_centre(const Edge& arc) const {
    const Vec2 centre = area::circle_of(arc).centre, base = centres_absolute() ? Vec2{} : arc.from;
    return {base.x + Words(def_, 'I').rounded(centre.x - base.x), base.y + Words(def_, 'J').rounded(centre.y - base.y)};
  }

  Status code(std::string& block, Function function) {
    if (function == motion_) return {};
    motion_ = function;
    return need({{function, any}}, block);
  }

  /// Writes the motion to the first point: first along Z, then along X and Y, because the position of the tool is unknown.
  Status first(Vec3 to) {
    std::string up, across;
    KADR_TRY(code(up, Function::rapid));
    KADR_TRY(word(up, 'Z', to.z));
    KADR_TRY(word(across, 'X', to.x));
    KADR_TRY(word(across, 'Y', to.y));
    put(up);
    put(across);
    at_ = to;
    written_.push_back({MoveKind::rapid, to});
    return {};
  }

  Status line(const Move& move) {
    std::string block, words;
    const Vec3 to = move.to;
    const auto moves = [](double a, double b) { return std::abs(a - b) > tol::same_point; };
    if (moves(to.x, at_.x)) KADR_TRY(word(words, 'X', to.x));
    if (moves(to.y, at_.y)) KADR_TRY(word(words, 'Y', to.y));
    if (moves(to.z, at_.z)) KADR_TRY(word(words, 'Z', to.z));
    if (words.empty()) return {};
    KADR_TRY(code(block, move.kind == MoveKind::rapid ? Function::rapid : Function::linear));
    add(block, words);
    KADR_TRY(feed(block, move.kind));
    written_.push_back({move.kind, to});
    at_ = to;
    put(block);
    return {};
  }

  Status circular(const Move& move, const Edge& arc, Vec2 centre) {
    std::string block;
    KADR_TRY(code(block, arc.bulge > 0 ? Function::arc_ccw : Function::arc_cw));
    KADR_TRY(word(block, 'X', arc.to.x));
    KADR_TRY(word(block, 'Y', arc.to.y));
    KADR_TRY(word(block, 'I', centre_value(centre.x, arc.from.x)));
    KADR_TRY(word(block, 'J', centre_value(centre.y, arc.from.y)));
    KADR_TRY(feed(block, move.kind));
    at_ = {arc.to.x, arc.to.y, at_.z};
    written_.push_back({move.kind, at_, move.bulge});
    put(block);
    return {};
  }

  Status feed(std::string& block, MoveKind kind) {
    if (kind == MoveKind::rapid) return {};
    const double feed = kind == MoveKind::plunge ? technology_.plunge_feed : technology_.feed;
    if (feed == feed_) return {};
    feed_ = feed;
    return coded(block, 'F', def_.feed_codes, feed);
  }

  /// Numbers the blocks N10, N20, …, or in smaller steps if N has too few digits. If no numbers fit, the blocks get none. That is an error
  /// only if the control requires block numbers.
  Status number_blocks() {
    const WordFormat& n = def_.grammar.word('N');
    const bool free = n.whole_digits == 0;
    const double most = free ? 99'999 : std::pow(10.0, n.whole_digits) - 1;
    int step = 0;
    for (const int s : block_steps)
      if (step == 0 && static_cast<double>(blocks_.size()) * s <= most) step = s;
    if (step == 0 && def_.grammar.block_number_required) return fail(alarm(AlarmId::word_has_no_room, {}, 'N', double(blocks_.size())));
    const std::string end = technology_.mark.empty() ? "\n" : " " + technology_.mark + "\n";
    const bool framed = def_.grammar.percent_frames;
    if (def_.grammar.program_start_required || def_.grammar.percent_number || framed) text_ += technology_.mark.empty() ? "%\n" : "%" + end;
    if (framed) text_ += fmt::format("O{:0{}}", 1, def_.behaviour.program_digits) + end;
    if (!technology_.comment.empty()) blocks_.front() += " (" + technology_.comment + ")";
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const int digits = n.drop_zeros ? 1 : n.whole_digits;
      if (step > 0) text_ += fmt::format("N{:0{}} ", (i + 1) * static_cast<std::size_t>(step), digits);
      text_ += blocks_[i] + end;
    }
    if (framed) text_ += "%\n";
    return {};
  }

  const ControlDef& def_;
  const Technology& technology_;
  std::vector<std::string> blocks_;
  std::vector<Move> written_;
  std::string text_;
  Vec3 at_;
  Function motion_ = Function::count;
  double feed_ = -1;
};

}  // namespace

Result<PartProgram> part_program(const ControlDef& def, const std::vector<area::Move>& moves, const Technology& technology) {
  if (def.grammar.klartext_blocks) return klartext_part_program(moves, technology);
  return ProgramWriter(def, technology).write(moves);
}

Result<std::string> bare_program(const ControlDef& def) {
  if (def.grammar.klartext_blocks) return "0 BEGIN PGM NEW MM\n1 M30\n2 END PGM NEW MM\n";
  const Technology nothing;
  return ProgramWriter(def, nothing).write_bare();
}

Status same_moves(const std::vector<area::Move>& written, const std::vector<area::Move>& read) {
  // Greatest difference between the bulges (Move::bulge, the shape of an arc) of two equal arcs that the rounding of words may cause. An
  // arc is at least ten increments long.
  constexpr double bulge_off = 0.1;
  const auto differs = [](const area::Move& a, const area::Move& b) {
    return (a.kind == area::MoveKind::rapid) != (b.kind == area::MoveKind::rapid) || length(a.to - b.to) > tol::same_point * 10 ||
           std::abs(a.bulge - b.bulge) > bulge_off;
  };
  const std::size_t count = std::min(written.size(), read.size());
  for (std::size_t i = 0; i < count; ++i)
    if (differs(written[i], read[i])) return fail(alarm(AlarmId::mill_read_back, {}, written[i].to.x, written[i].to.y));
  if (written.size() == read.size()) return {};
  const Vec3 at = written.empty() ? Vec3{} : written[std::min(count, written.size() - 1)].to;
  return fail(alarm(AlarmId::mill_read_back, {}, at.x, at.y));
}

}  // namespace kadr
