// Writes the moves of area milling as conversational blocks. Used by out/program/part_program; tested by tests/mill.py.

#include "out/program/klartext_part.h"

#include <fmt/format.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "base/tolerance.h"
#include "path/pocketing/edge.h"

namespace kadr {
namespace {

constexpr double length_increment = 1e-4;  // of the control's lengths, mm (spec/heidenhain 1.3)
constexpr double least_arc = 1e-3;         // length of an arc below which a line replaces it, mm
constexpr double most_off = 0.005;         // difference of the radii of a written arc, mm; the control accepts 0.016 (spec/heidenhain 4.1)

double rounded_length(double value) { return std::round(value / length_increment) * length_increment; }

std::string signed_length(double value) {
  std::string text = fmt::format("{:+.4f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "+0" : text;
}

class KlartextWriter {
 public:
  explicit KlartextWriter(const Technology& technology) : technology_(technology) {}

  PartProgram write(const std::vector<area::Move>& moves) {
    put("BEGIN PGM PART MM");
    if (!technology_.comment.empty()) put("; " + technology_.comment);
    std::string tool = "TOOL CALL";
    if (technology_.tool > 0) tool += fmt::format(" {} Z", technology_.tool);
    if (technology_.speed > 0) tool += " S" + signed_length(technology_.speed).substr(1);
    if (tool.size() > 9) put(tool);
    if (technology_.speed > 0) put("M3");
    if (technology_.coolant) put("M8");
    for (const area::Move& move : moves) motion(move);
    if (technology_.coolant) put("M9");
    if (technology_.speed > 0) put("M5");
    put("M30");
    put("END PGM PART MM");
    return {std::move(text_), std::move(written_)};
  }

 private:
  void put(std::string_view block) { text_ += fmt::format("{} {}\n", count_++, block); }

  void motion(const area::Move& move) {
    const Vec3 to{rounded_length(move.to.x), rounded_length(move.to.y), rounded_length(move.to.z)};
    if (written_.empty()) {  // first along Z, because the position of the tool is not known
      put("L Z" + signed_length(to.z) + " R0 FMAX");
      put("L X" + signed_length(to.x) + " Y" + signed_length(to.y) + " FMAX");
      written_.push_back({area::MoveKind::rapid, to});
    } else if (move.bulge == 0 || !arc(move, to)) {
      if (length(to - at_) <= tol::same_point) return;
      std::string block = "L";
      for (const auto& [axis, value, now] : {std::tuple('X', to.x, at_.x), {'Y', to.y, at_.y}, {'Z', to.z, at_.z}})
        if (std::fabs(value - now) > tol::same_point) block += fmt::format(" {}{}", axis, signed_length(value));
      put(block + feed(move.kind));
      written_.push_back({move.kind, to});
    }
    at_ = to;
  }

  /// Writes an arc; false if rounding would change its shape too much.
  bool arc(const area::Move& move, Vec3 to) {
    const Edge edge{{at_.x, at_.y}, {to.x, to.y}, move.bulge};
    if (area::length_of(edge) < least_arc || length(edge.to - edge.from) < length_increment) return false;
    const Vec2 exact = area::circle_of(edge).centre, centre{rounded_length(exact.x), rounded_length(exact.y)};
    if (std::fabs(length(edge.to - centre) - length(edge.from - centre)) > most_off) return false;
    put("CC X" + signed_length(centre.x) + " Y" + signed_length(centre.y));
    put("C X" + signed_length(to.x) + " Y" + signed_length(to.y) + (move.bulge > 0 ? " DR+" : " DR-") + feed(move.kind));
    written_.push_back({move.kind, {to.x, to.y, at_.z}, move.bulge});
    return true;
  }

  std::string feed(area::MoveKind kind) {
    if (kind == area::MoveKind::rapid) return " FMAX";
    const double feed = kind == area::MoveKind::plunge ? technology_.plunge_feed : technology_.feed;
    if (feed == feed_) return {};
    feed_ = feed;
    return " F" + signed_length(feed).substr(1);
  }

  const Technology& technology_;
  std::string text_;
  std::vector<area::Move> written_;
  Vec3 at_;
  double feed_ = -1;
  int count_ = 0;
};

}  // namespace

PartProgram klartext_part_program(const std::vector<area::Move>& moves, const Technology& technology) {
  return KlartextWriter(technology).write(moves);
}

}  // namespace kadr
