// Definition and call of cycles (spec/heidenhain 12.1, 12.9). Used by control/heidenhain.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "action/by_kind.h"
#include "control/heidenhain/area_cycles.h"
#include "control/heidenhain/block_run.h"
#include "control/heidenhain/cycle_steps.h"
#include "control/heidenhain/old_cycle_lines.h"

namespace kadr::heidenhain {
namespace {

constexpr int callable[] = {1, 2, 17, 18, 200, 201, 202, 203, 205, 206, 207, 208, 209, 240, 241};

bool is_callable(int cycle) {
  return std::find(std::begin(callable), std::end(callable), cycle) != std::end(callable) || is_area_cycle(cycle) ||
         Heidenhain::is_contour_cycle(cycle);
}

}  // namespace

Status CycleSteps::execute(Emitter& m, const CycleStep& step) {
  Axes to = m.position.programmed;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((step.named >> a & 1U) != 0) to[a] = step.to[a];
  switch (step.kind) {
    case CycleStep::Kind::rapid: return m.straight(MotionKind::rapid, to, step.named);
    case CycleStep::Kind::feed:
    case CycleStep::Kind::arc: {
      const double feed = m.modal.feed;
      const bool known = m.modal.feed_known;
      const FeedMode mode = m.modal.feed_mode;
      if (step.value > 0) m.modal.feed = step.value, m.modal.feed_mode = FeedMode::per_minute, m.modal.feed_known = true;
      Status moved = m.feed_known(m.block->where);
      if (moved && step.kind == CycleStep::Kind::arc)
        heidenhain_of(m).emit_arc(m, step.clockwise ? Turn::cw : Turn::ccw, {step.centre, step.turns}, to, step.named, m.modal.axes);
      else if (moved) moved = m.straight(MotionKind::feed, to, step.named);
      if (moved && step.taps)
        if (Motion* const motion = motion_of(m.batch->back()); motion != nullptr) {
          motion->own_override = motion->no_hold = true;
          motion->in_hole = HoleWork::taps;
        }
      m.modal.feed = feed;
      m.modal.feed_known = known;
      m.modal.feed_mode = mode;
      return moved;
    }
    case CycleStep::Kind::dwell: m.emit(Dwell{step.value}); return {};
    case CycleStep::Kind::spindle:
      if (step.dir == SpindleDir::position) m.emit(Spindle{step.dir, 0, 1, std::nullopt, step.angle});
      else m.emit(Spindle{step.dir, step.dir == SpindleDir::stop ? 0 : step.value > 0 ? step.value : m.modal.rpm});
      return {};
    case CycleStep::Kind::coolant: {
      constexpr double flood = 8, off = 9;
      if (step.value == flood || step.value == off) m.emit(CoolantSwitch{step.value == flood ? Coolant::flood : Coolant::off});
      else if (step.value > 0) m.emit(MachineFunction{static_cast<std::uint32_t>(step.value), {}, {}});
      return {};
    }
  }
  return {};
}

/// The Q parameters of a definition. Those of cycles that wait for their call become the ones that the cycle has (spec/heidenhain 12.1).
Status Heidenhain::take_parameters(BlockContext& m, const KlartextBlock& block) {
  const bool waits = is_callable(block.number);
  if (waits) memory.defined.reset();
  for (const KlartextWord& word : block.words) {
    auto read = value(m, block, word);
    if (!read) return fail(read.error());
    KlartextStep to;
    to.index = static_cast<std::uint16_t>(word.name);
    if (word.text == "MAX") *read = -1;
    else if (word.text == "FU") *read *= m.modal.rpm;  // the speed at the definition
    else if (word.text == "FZ") {
      const auto per_turn = feed_per_turn(m, *read, word.where);
      if (!per_turn) return fail(per_turn.error());
      *read = *per_turn * m.modal.rpm;
    } else if (word.text == "AUTO") *read = memory.tool_feed / m.unit_scale();
    else if (word.text == "PREDEF") {
      const auto known = memory.global_values.find(to.index);
      if (known == memory.global_values.end()) return fail(alarm(AlarmId::variable_not_set, word.where, "PREDEF"));
      *read = known->second;
    }
    if (block.part == KlartextBlock::global_definition) memory.global_values[to.index] = *read;
    else KADR_TRY(set_parameter(to, *read));
    if (waits && to.index < first_builder_q) memory.defined.set(to.index);
  }
  return {};
}

// NOLINTNEXTLINE(readability-function-size): one row for each cycle that acts when it is defined
Status Heidenhain::define_cycle(Interpreter& m, const KlartextBlock& block) {
  const int cycle = block.number;
  const Span where = m.block->where;
  const auto refuse = [&]() -> Status {
    return fail(alarm(AlarmId::not_available, where, std::string_view("CYCL DEF " + std::to_string(cycle))));
  };
  if (block.part < 0) KADR_TRY(take_parameters(m, block));
  if (block.part == KlartextBlock::global_definition) return {};
  switch (cycle) {
    case 7:
    case 8:
    case 10:
    case 11:
    case 26:
    case 247: return frame_cycle(m, block);
    case 9:
      if (block.part > 0)
        if (const auto seconds = last_number(block.text)) m.emit(Dwell{*seconds});
      return {};
    case 12:
      if (block.part > 0) {
        std::string path = block.text;
        const std::size_t begin = path.find("PGM");
        if (begin != std::string::npos) path.erase(0, begin + 3);
        path.erase(0, std::min(path.find_first_not_of(" \t"), path.size()));
        memory.cycle_program = path;
      }
      memory.cycle = 12;
      memory.calls_always = false;
      return {};
    case 14: return block.part == 0 ? Status() : take_contours(block, where);
    case 20: take_contour_data(); return {};
    case 13:
    case 32:
    case 239:  // the load is weighed, the drives are tuned: the path stays as it is
    case 392: m.warn(warning(AlarmId::word_passed_over, where, std::string_view("CYCL DEF " + std::to_string(cycle)))); return {};
    case 19:
      if (block.part < 1) return {};
      {
        Axes angles{};
        bool any = false;
        for (const KlartextWord& word : block.words)
          for (std::size_t i = 0; i < 3; ++i)
            if (word.name == word_name(std::string_view("ABC").substr(i, 1)) && !word.bare) {
              const auto read = value(m, block, word);
              if (!read) return fail(read.error());
              angles[i] = *read;
              any = any || *read != 0;
            }
        if (!any) {
          untilt(m);
          return set_frame(m);
        }
        const Mat3 to = Mat3::about({0, 0, 1}, angles[2]) * Mat3::about({0, 1, 0}, angles[1]) * Mat3::about({1, 0, 0}, angles[0]);
        KADR_TRY(set_axis_angles(m, to, block));
        return tilt(m, to);
      }
    case 220:
    case 221: {
      if (!is_callable(memory.cycle)) return fail(alarm(AlarmId::cycle_undefined, where));
      CycleMaker maker(m, *this, where);
      KADR_TRY(cycle == 220 ? maker.polar_pattern() : maker.cartesian_pattern());
      m.running = std::make_unique<CycleSteps>(std::move(maker.steps));
      return {};
    }
    default: break;
  }
  if (!is_callable(cycle)) return refuse();
  memory.calls_always = false;
  memory.cycle = cycle;
  if (block.part < 0) return {};
  if (block.part == 0) {
    memory.old = memory.old_feed = {};
    memory.old_sense = {};
  }
  return block.part > 0 ? take_old_line(m, block) : Status();
}

/// Executes the cycle in force at the position of the tool; `raised` is the shift of its surface.
Status Heidenhain::call_cycle(Interpreter& m, Span where, double raised) {
  if (memory.cycle < 0) return fail(alarm(AlarmId::cycle_undefined, where));
  if (memory.cycle == 12) return call_program(m, memory.cycle_program, where);
  if (is_contour_cycle(memory.cycle)) return mill_contours(m, where);
  CycleMaker maker(m, *this, where);
  maker.raise_surface(raised);
  KADR_TRY(maker.at_point());
  m.running = std::make_unique<CycleSteps>(std::move(maker.steps));
  return {};
}

/// CYCL CALL, CYCL CALL POS X Y Z, CYCL CALL PAT (spec/heidenhain 12.1).
Status BlockRun::call_at_position() {
  if (read_.part == 2) {
    if (own_.memory.cycle < 0) return fail(alarm(AlarmId::cycle_undefined, m_.block->where));
    CycleMaker maker(m_, own_, m_.block->where);
    KADR_TRY(maker.points(own_.memory.pattern));
    m_.running = std::make_unique<CycleSteps>(std::move(maker.steps));
    return {};
  }
  if (read_.part == 1) {
    Axes to;
    AxisMask named = 0;
    KADR_TRY(target(to, named));
    const std::size_t normal = plane_.normal;
    const AxisMask height = AxisMask{1} << normal;
    const bool above = m_.position.programmed[normal] >= own_.memory.q[203] * m_.unit_scale();
    if ((named & height) != 0) raised_ = to[normal];
    for (const bool in_plane : {above, !above}) {
      const AxisMask part = in_plane ? named & ~height : named & height;
      Axes there = m_.position.programmed;
      for (std::size_t a = 0; a < m_.axis_count; ++a)
        if ((part >> a & 1U) != 0) there[a] = to[a];
      KADR_TRY(straight_to(there, part));
    }
  }
  calls_ = true;
  return {};
}

/// PATTERN DEF: the points of its rows (spec/heidenhain 12.7).
Status Heidenhain::call_pattern(Interpreter& m, const KlartextBlock& block) {
  std::vector<Axes> points;
  for (const PatternRow& row : block.rows) {
    const auto number = [&](std::string_view name, double otherwise = 0) {
      for (const KlartextWord& word : row.words)
        if (word.name == word_name(name)) {
          const auto read = value(m, block, word);
          return read ? *read : undefined;
        }
      return otherwise;
    };
    const double unit = m.unit_scale();
    const Vec2 start{number("X") * unit, number("Y") * unit};
    const auto add = [&](Vec2 at) {
      Axes point{};
      point[0] = at.x;
      point[1] = at.y;
      point[2] = number("Z") * unit;
      points.push_back(point);
    };
    const double count = std::round(number("NUM", 1)), across = std::round(number("NUMX", 1)), up = std::round(number("NUMY", 1));
    if (!(count >= 1 && across >= 1 && up >= 1) || count * across * up > 10'000)
      return fail(alarm(AlarmId::value_out_of_range, row.where, "NUM", count));
    if (row.name == "POS") {
      add(start);
    } else if (row.name == "ROW") {
      for (int i = 0; i < static_cast<int>(count); ++i) add(start + rotated(Vec2{i * number("D") * unit, 0}, number("ROT")));
    } else if (row.name == "CIRC" || row.name == "PITCHCIRC") {
      const double step = row.name == "CIRC" ? 360 / count : number("STEP");
      for (int i = 0; i < static_cast<int>(count); ++i) add(start + rotated(Vec2{number("D") * unit / 2, 0}, number("START") + i * step));
    } else {
      if (number("ROTX") != 0 || number("ROTY") != 0) return fail(alarm(AlarmId::not_available, row.where, "ROTX, ROTY"));
      for (int y = 0; y < static_cast<int>(up); ++y)
        for (int x = 0; x < static_cast<int>(across); ++x) {
          const bool edge = y == 0 || x == 0 || y + 1 == static_cast<int>(up) || x + 1 == static_cast<int>(across);
          if (row.name == "FRAME" && !edge) continue;
          add(start + rotated(Vec2{x * number("DX") * unit, y * number("DY") * unit}, number("ROT")));
        }
    }
  }
  memory.pattern = std::move(points);
  return {};
}

}  // namespace kadr::heidenhain
