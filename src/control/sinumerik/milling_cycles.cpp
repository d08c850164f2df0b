// POCKET1 to POCKET4, CYCLE61, CYCLE71, SLOT1 and LONGHOLE (spec/sinumerik 14.5). The manual does not document the path within a pocket:
// start level, depths, walls and end point are those of the cycle, the path between is Kadr's own clearing. Used by control/sinumerik.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/cycles/pocket_rings.h"
#include "control/sinumerik/mill_steps.h"

namespace kadr::sinumerik {
namespace {

/// Works out the steps of one call.
class MillMaker {
 public:
  MillMaker(Interpreter& m, const std::vector<Value>& arguments, Span where) : m_(m), arguments_(arguments), where_(where) {}

  std::vector<MillStep> steps;

  Status run(const std::string& name) {
    const PlaneAxes plane = m_.modal.axes;
    if (m_.transform.leaves(plane) || m_.transform.distorts(plane))
      return fail(alarm(AlarmId::not_together, where_, "SCALE", std::string_view(name)));
    const auto radius = sinumerik_of(m_).cutter_radius(m_, where_);
    if (!radius) return fail(radius.error());
    radius_ = *radius;
    retract_ = number(0), reference_ = number(1);
    level_ = reference_ + std::fabs(number(2));
    const bool relative = (name == "SLOT1" || name == "LONGHOLE") && given(4) && number(4) != 0;
    if (!(retract_ >= reference_) || !(relative || number(3) < reference_)) return fail(alarm(AlarmId::cycle_reference_plane, where_));
    const Axes& at = m_.position.programmed;
    const Vec2 here{at[plane.first], at[plane.second]};
    if (at[plane.normal] < retract_) straight(MillStep::Kind::rapid, here, retract_);
    if (name == "CYCLE71") return face();
    if (name == "SLOT1" || name == "LONGHOLE") return slots(name == "SLOT1");
    return pocket(name == "POCKET3");
  }

 private:
  bool given(std::size_t i) const { return i < arguments_.size() && !arguments_[i].omitted; }
  double number(std::size_t i) const { return given(i) ? arguments_[i].number : 0; }

  void straight(MillStep::Kind kind, Vec2 to, double height, double feed = 0) { steps.push_back({kind, to, height, feed, {}, 0}); }
  void arc(bool cw, Vec2 to, Vec2 centre, double turns) {
    steps.push_back({cw ? MillStep::Kind::arc_cw : MillStep::Kind::arc_ccw, to, height_, feed_, centre, turns});
  }

  /// POCKET3, POCKET4: rings from the middle outwards, at each depth.
  Status pocket(bool rectangle) {
    const std::size_t base = rectangle ? 7 : 5;  // PA, PO
    const std::size_t mid = rectangle ? 10 : 7;
    const double fal = std::fabs(number(mid + 1)), fald = std::fabs(number(mid + 2));
    feed_ = number(mid + 3);
    const double down = number(mid + 4);
    const int kind = static_cast<int>(std::lround(given(mid + 6) ? number(mid + 6) : 1));
    const bool finishes = kind % 10 == 2;
    if (kind % 10 != 1 && kind % 10 != 2) return fail(alarm(AlarmId::not_available, where_, "_VARI"));
    if (kind / 10 > 2) return fail(alarm(AlarmId::not_available, where_, "_VARI"));
    if (!(feed_ > 0) || !(down > 0)) KADR_TRY(m_.feed_known(where_));
    const double wall = finishes ? 0 : fal, bottom = number(3) + (finishes ? 0 : fald);
    const double half_length = rectangle ? number(4) / 2 : number(4), half_width = rectangle ? number(5) / 2 : number(4);
    const double corner = rectangle ? number(6) : number(4);
    const double a = half_length - wall - radius_, b = half_width - wall - radius_;
    const bool tight = rectangle && corner > 0 && corner < radius_ - tol::same_point;
    if (a < -tol::same_point || b < -tol::same_point || tight)
      return fail(alarm(AlarmId::pocket_tool_large, where_, 2 * radius_, 2 * half_length, 2 * half_width));
    const double wanted = number(mid + 7) > 0 ? number(mid + 7) : 1.6 * radius_;
    if (wanted > 2 * radius_) return fail(alarm(AlarmId::value_out_of_range, where_, "_MIDA", wanted));
    width_ = std::min(wanted, 1.7 * radius_);  // beyond it, corners of the rings would leave something
    centre_ = {number(base), number(base + 1)};
    turn_ = sincos_deg(rectangle ? number(9) : 0);
    const int direction = static_cast<int>(std::lround(number(mid + 5)));
    const bool climb_is_ccw = m_.modal.spindle != SpindleDir::ccw;
    cw_ = direction == 2 || (direction == 1 && climb_is_ccw) || (direction == 0 && !climb_is_ccw);
    std::vector<double> all;
    KADR_TRY(add_depths(all, reference_, bottom, finishes ? 0 : number(mid), where_));
    straight(MillStep::Kind::rapid, centre_, retract_);
    straight(MillStep::Kind::rapid, centre_, level_);
    const std::size_t helix = rectangle ? 21 : 17;  // RAD1, DP1
    for (const double height : all) {
      plunge(height, down, kind / 10 == 2 ? std::min(number(helix), std::min(a, b)) : 0, number(helix + 1));
      rings(std::max(a, 0.0), std::max(b, 0.0), std::max(0.0, std::min(corner - wall - radius_, std::min(a, b))));
      if (steps.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
    }
    straight(MillStep::Kind::rapid, centre_, retract_);
    return {};
  }

  /// SLOT1: slots along the rays of a circle, each cleared as a pocket with round ends. LONGHOLE: slots as wide as the cutter, which goes
  /// down at alternate ends. The slots begin at the distance RAD from the centre (spec/sinumerik 14.5).
  Status slots(bool wide) {
    const double count = std::round(number(5)), along = number(6), width = wide ? number(7) : 2 * radius_;
    const std::size_t base = wide ? 8 : 7;  // CPA
    const double bottom = given(4) && number(4) != 0 ? reference_ - std::fabs(number(4)) : number(3);
    if (!(count >= 1) || count > 1000) return fail(alarm(AlarmId::pattern_empty, where_));
    const double down = number(base + 5), mid = number(base + 7), fal = wide ? std::fabs(number(17)) : 0;
    feed_ = number(base + 6);
    if (!(feed_ > 0) || !(down > 0)) KADR_TRY(m_.feed_known(where_));
    const double a = along / 2 - fal - radius_, b = width / 2 - fal - radius_;
    if (a < -tol::same_point || b < -tol::same_point) return fail(alarm(AlarmId::pocket_tool_large, where_, 2 * radius_, along, width));
    if (wide && number(18) != 0 && number(18) != 1) return fail(alarm(AlarmId::not_available, where_, "SLOT1 VARI"));
    width_ = 1.6 * radius_;
    const int direction = wide ? static_cast<int>(std::lround(number(16))) : 0;
    const bool climb_is_ccw = m_.modal.spindle != SpindleDir::ccw;
    cw_ = direction == 2 || (direction == 1 && climb_is_ccw) || (direction == 0 && !climb_is_ccw);
    const double first = number(base + 3), turn = number(base + 4) != 0 ? number(base + 4) : 360 / count;
    std::vector<double> all;
    KADR_TRY(add_depths(all, reference_, bottom, mid, where_));
    for (double i = 0; i < count; ++i) {
      turn_ = sincos_deg(first + i * turn);
      const double middle = number(base + 2) + along / 2;
      centre_ = Vec2{number(base), number(base + 1)} + Vec2{middle * turn_.cos, middle * turn_.sin};
      const double high = i == 0 ? retract_ : level_;
      const Vec2 begin = wide ? centre_ : placed(-a, 0);
      straight(MillStep::Kind::rapid, begin, high);
      straight(MillStep::Kind::rapid, begin, level_);
      double end = -1;
      for (const double height : all) {
        if (wide) {
          plunge(height, down, 0, 0);
          rings(std::max(a, 0.0), std::max(b, 0.0), std::max(b, 0.0));
        } else {
          straight(MillStep::Kind::feed, placed(end * a, 0), height, down);
          end = -end;
          straight(MillStep::Kind::feed, placed(end * a, 0), height, feed_);
        }
        if (steps.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
      }
      straight(MillStep::Kind::rapid, steps.back().to, i + 1 < count ? level_ : retract_);
    }
    return {};
  }

  /// Goes down in the middle: straight, or on a helix.
  void plunge(double height, double feed, double helix_radius, double lead) {
    const double above = steps.empty() ? level_ : steps.back().height;
    height_ = height;
    if (!(helix_radius > tol::same_point)) return straight(MillStep::Kind::feed, centre_, height, feed);
    const Vec2 start = centre_ + Vec2{helix_radius, 0};
    straight(MillStep::Kind::feed, start, above, feed_);
    const double turns = lead > 0 ? std::max(1.0, std::ceil((above - height) / lead - 1e-9)) : 1;
    steps.push_back({cw_ ? MillStep::Kind::arc_cw : MillStep::Kind::arc_ccw, start, height, feed, centre_, turns});
    arc(cw_, start, centre_, 1);
    straight(MillStep::Kind::feed, centre_, height, feed_);
  }

  Vec2 placed(double x, double y) const { return centre_ + Vec2{x * turn_.cos - y * turn_.sin, x * turn_.sin + y * turn_.cos}; }

  void rings(double a, double b, double corner) {
    std::vector<RingMove> moves;
    append_rings(moves, {a, b, corner}, width_, cw_);
    for (const RingMove& move : moves) {
      const Vec2 to = placed(move.to.x, move.to.y);
      if (move.turns == 0) straight(MillStep::Kind::feed, to, height_, feed_);
      else arc(cw_, to, placed(move.centre.x, move.centre.y), move.turns);
    }
  }

  /// CYCLE71: lanes that overrun the face by the tool's radius and FDP.
  Status face() {
    const double length = number(6), width = number(7), bottom = number(3) + std::fabs(number(12));
    if (length == 0 || width == 0) return fail(alarm(AlarmId::value_out_of_range, where_, "_LENG, _WID", 0.0));
    const int kind = static_cast<int>(std::lround(given(14) ? number(14) : 31));
    const int way = kind / 10;
    if (way < 1 || way > 4) return fail(alarm(AlarmId::not_available, where_, "_VARI"));
    feed_ = number(13);
    if (!(feed_ > 0)) KADR_TRY(m_.feed_known(where_));
    centre_ = {number(4), number(5)};
    turn_ = sincos_deg(number(8));
    const bool along_first = way == 1 || way == 3, to_and_fro = way >= 3;
    const double along = along_first ? length : width, across = along_first ? width : length;
    const double step = number(10) > 0 ? number(10) : 1.6 * radius_;
    if (step > 2 * radius_) return fail(alarm(AlarmId::value_out_of_range, where_, "_MIDA", step));
    const double lanes = std::ceil(std::fabs(across) / step - 1e-9);
    if (!(lanes < 10'000)) return fail(alarm(AlarmId::cycle_endless, where_));
    const double over = (radius_ + std::fabs(number(11))) * (along < 0 ? -1 : 1);
    std::vector<double> all;
    KADR_TRY(add_depths(all, reference_, kind % 10 == 2 ? number(3) : bottom, kind % 10 == 2 ? 0 : number(9), where_));
    const auto place = [&](double u, double v) { return along_first ? placed(u, v) : placed(v, u); };
    for (const double height : all)
      for (double lane = 0; lane < lanes; ++lane) {
        const double v = across * (lane + 0.5) / lanes;
        const bool back = to_and_fro && std::fmod(lane, 2) != 0;
        const Vec2 from = place(back ? along + over : -over, v), to = place(back ? -over : along + over, v);
        if (lane == 0 || !to_and_fro) {
          const double high = lane == 0 ? retract_ : level_;
          if (!steps.empty()) straight(MillStep::Kind::rapid, steps.back().to, high);
          straight(MillStep::Kind::rapid, from, high);
          straight(MillStep::Kind::rapid, from, level_);
        }
        straight(MillStep::Kind::feed, from, height, feed_);
        straight(MillStep::Kind::feed, to, height, feed_);
        if (steps.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
      }
    straight(MillStep::Kind::rapid, steps.back().to, retract_);
    return {};
  }

  Interpreter& m_;
  const std::vector<Value>& arguments_;
  Span where_;
  double radius_ = 0, retract_ = 0, reference_ = 0, level_ = 0, feed_ = 0, width_ = 0, height_ = 0;
  Vec2 centre_;
  SinCos turn_{};
  bool cw_ = false;
};

/// Returns the parameters of POCKET3 or POCKET4 for those of the older POCKET1 or POCKET2, which clear the same volume
/// (spec/sinumerik 14.5). INFERRED: their VARI 0, complete machining, clears the pocket to its walls.
std::vector<Value> as_newer_pocket(const std::vector<Value>& old, bool rectangle) {
  const auto number = [&](std::size_t i) { return i < old.size() && !old[i].omitted ? old[i].number : 0.0; };
  const bool relative = number(4) != 0;
  const double depth = relative ? number(1) - std::fabs(number(4)) : number(3);
  const std::size_t place = rectangle ? 8 : 6;   // CPA, CPO
  const std::size_t feeds = rectangle ? 11 : 8;  // FFD, FFP1, MID, CDIR, FAL, VARI
  const bool whole = number(feeds + 5) == 0;
  std::vector<Value> all{real(number(0)), real(number(1)), real(number(2)), real(depth)};
  for (std::size_t i = 5; i < place; ++i) all.push_back(real(number(i)));
  for (std::size_t i = place; i < feeds; ++i) all.push_back(real(number(i)));
  const double allowance = whole ? 0 : number(feeds + 4);
  for (const double each :
       {number(feeds + 2), allowance, 0.0, number(feeds + 1), number(feeds), number(feeds + 3), whole ? 1.0 : number(feeds + 5)})
    all.push_back(real(each));
  return all;
}

/// Returns the parameters of CYCLE71 for those of CYCLE61, which mills the same face in the directions of the axes.
std::vector<Value> as_face(const std::vector<Value>& given) {
  const auto number = [&](std::size_t i) { return i < given.size() && !given[i].omitted ? given[i].number : 0.0; };
  std::vector<Value> all;
  for (std::size_t i = 0; i < 8; ++i) all.push_back(real(number(i)));  // RTP, Z0, SDIS, Z1, X0, Y0, LENG, WID
  const bool has_kind = given.size() > 12 && !given[12].omitted;
  for (const double each : {0.0, number(8), number(9), 0.0, number(10), number(11), has_kind ? number(12) : 31.0})
    all.push_back(real(each));
  return all;
}

}  // namespace

bool Sinumerik::is_milling_cycle(std::string_view name) {
  return name == "POCKET1" || name == "POCKET2" || name == "POCKET3" || name == "POCKET4" || name == "CYCLE71" || name == "CYCLE61" ||
         name == "SLOT1" || name == "LONGHOLE";
}

Status Sinumerik::start_milling(Interpreter& m, const std::string& name, const std::vector<Value>& arguments, Span where) {
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, where, std::string_view(name)));
  for (const Value& each : arguments)
    if (!each.is_number()) return fail(alarm(AlarmId::operand_type, where, std::string_view(name)));
  const bool older = name == "POCKET1" || name == "POCKET2";
  const std::vector<Value> newer = older               ? as_newer_pocket(arguments, name == "POCKET1")
                                   : name == "CYCLE61" ? as_face(arguments)
                                                       : arguments;
  const bool limited = name == "CYCLE61" && arguments.size() > 13 && arguments[13].number != 0;
  if (limited) return fail(alarm(AlarmId::not_available, where, "CYCLE61 _LIM"));
  MillMaker maker(m, newer, where);
  KADR_TRY(maker.run(name == "POCKET1" ? "POCKET3" : name == "POCKET2" ? "POCKET4" : name == "CYCLE61" ? "CYCLE71" : name));
  m.running = std::make_unique<MillSteps>(std::move(maker.steps));
  return {};
}

}  // namespace kadr::sinumerik
