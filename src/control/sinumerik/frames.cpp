// Frames: TRANS, ROT, SCALE, MIRROR and their additive forms, frames as values (spec/sinumerik 11). Used by control/sinumerik.

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/sinumerik/sinumerik.h"
#include "kinematics/five_axis_transform.h"

namespace kadr::sinumerik {
namespace {

constexpr std::string_view statements[] = {"TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR"};

}  // namespace

bool Sinumerik::is_frame_statement(std::string_view name) {
  return std::find(std::begin(statements), std::end(statements), name) != std::end(statements);
}

/// Puts a programmable frame in force. The tool does not move; its programmed coordinates are those of the new frame.
///   alarms  not_available: the frame shears
Status Sinumerik::set_programmable(Emitter& m, const Frame& frame, Span where) {
  const Frame whole = memory.swivel.is_unchanged() ? frame : chained(memory.swivel, frame);
  auto transform = transform_of(whole);
  const bool in_space = !transform || memory.swivelled_to;  // a swivelled plane turns with the rotary axes of the machine
  if (in_space) transform = scale_in_space(whole);
  if (!transform) return fail(alarm(AlarmId::not_available, where, "ROT"));
  for (std::size_t a = 0; a < 3; ++a)
    if (transform->scale[a] == 0) return fail(alarm(AlarmId::scale_zero, where, std::string_view(m.axis_names[a])));
  memory.programmable = frame;
  const auto switches = m.transform.mirror;  // the switches of the panel mirror outside of every frame
  m.transform = *transform;
  m.transform.mirror = switches;
  m.transform.refresh();
  if (std::exchange(memory.in_space, in_space) || in_space) m.change_frames();
  m.position.programmed = m.transform.to_programmed(m.position.work);
  memory.has_direction = false;
  return {};
}

/// Executes TRANS X10 Y5, AROT RPL=30, SCALE X2 … (spec/sinumerik 11.2).
Status Sinumerik::frame_statement(Interpreter& m, const NamedBlock& block) {
  const NamedItem& first = block.items[0];
  const bool adds = first.name[0] == 'A';
  const std::string kind = adds ? first.name.substr(1) : first.name;
  Frame part;
  FrameParts turn;
  std::array<bool, 3> named{};
  std::optional<double> in_plane;
  const double unit = m.unit_scale();
  for (std::size_t i = 1; i < block.items.size(); ++i) {
    const NamedItem& item = block.items[i];
    if (item.kind != NamedItem::Kind::word) return fail(alarm(AlarmId::statement_not_alone, item.where));
    double value = item.number;
    if (item.has_equals) {
      const auto read = number(m, block, item.value, item.where);
      if (!read) return fail(read.error());
      value = *read;
    }
    if (item.name == "RPL" && kind == "ROT") {
      in_plane = value;
      continue;
    }
    const auto axis = axis_named(m, item.name);
    if (!axis || item.extension >= 0) return fail(alarm(AlarmId::word_unused, item.where, std::string_view(item.name)));
    if (kind == "TRANS") {
      const bool is_length = (m.def.rotary >> *axis & 1U) == 0;
      part.shift[*axis] = value * (is_length ? unit : 1.0);
      continue;
    }
    if (*axis > 2) return fail(alarm(AlarmId::word_unused, item.where, std::string_view(item.name)));
    named[*axis] = true;
    if (kind == "ROT") turn.angles[*axis] = value;
    else turn.scale[*axis] = kind == "SCALE" ? value : -1.0;
  }
  if (in_plane && (named[0] || named[1] || named[2])) return fail(alarm(AlarmId::not_together, first.where, "RPL", "X Y Z"));
  part.linear = in_plane ? rotation_about(m.modal.axes.normal, *in_plane) : matrix_of(turn);
  if (!adds) return set_programmable(m, part, first.where);
  return set_programmable(m, chained(memory.programmable, part), first.where);
}

/// CTRANS(X,10,Y,5), CROT(Z,90), CSCALE(X,2), CMIRROR(X), INVFRAME(F) (spec/sinumerik 11.4).
Result<Value> Sinumerik::frame_function(const std::string& name, const std::vector<Value>& operands, const BlockContext& m, Span where) {
  if (name == "INVFRAME") {
    if (operands.size() != 1 || operands[0].type != Type::frame) return fail(alarm(AlarmId::operand_type, where, "INVFRAME"));
    const auto back = inverse(*operands[0].frame);
    if (!back) return fail(alarm(AlarmId::division_by_zero, where));
    return frame_value(*back);
  }
  const bool shifts = name == "CTRANS" || name == "CFINE", turns = name == "CROT", scales = name == "CSCALE", mirrors = name == "CMIRROR";
  if (!shifts && !turns && !scales && !mirrors) return fail(alarm(AlarmId::function_unknown, where, std::string_view(name)));
  Frame frame;
  FrameParts parts;
  const std::size_t step = mirrors ? 1 : 2;
  for (std::size_t i = 0; i < operands.size(); i += step) {
    const auto axis = operands[i].type == Type::axis ? axis_named(m, operands[i].text) : std::nullopt;
    if (!axis || i + step > operands.size() || (!mirrors && !operands[i + 1].is_number()))
      return fail(alarm(AlarmId::operand_type, where, std::string_view(name)));
    if (shifts) (name == "CFINE" ? frame.fine : frame.shift)[*axis] = operands[i + 1].number;
    else if (*axis > 2) return fail(alarm(AlarmId::operand_type, where, std::string_view(name)));
    else if (turns) parts.angles[*axis] = operands[i + 1].number;
    else parts.scale[*axis] = scales ? operands[i + 1].number : -1.0;
  }
  frame.linear = matrix_of(parts);
  return frame_value(frame);
}

namespace {

Mat3 matrix_in_space(const Matrix& m) {
  return {{Vec3{m[0][0], m[0][1], m[0][2]}, Vec3{m[1][0], m[1][1], m[1][2]}, Vec3{m[2][0], m[2][1], m[2][2]}}};
}

}  // namespace

/// Gives a frame that turns in space to the placement, so that arcs, compensation and cycles act in its plane.
void Sinumerik::place_in_space(Emitter& m) {
  const Frame whole = chained(memory.swivel, memory.programmable);
  FrameParts turn = parts_of(whole.linear);
  turn.scale = {1, 1, 1};
  FiveAxisTransformData data;
  data.zero = in_space(m.frames.origin);
  data.basic = matrix_in_space(memory.active.linear);
  data.has_frame = memory.in_space;
  data.frame = matrix_in_space(matrix_of(turn));
  Axes shift{};
  for (std::size_t a = 0; a < 3; ++a) shift[a] = whole.shift[a] + whole.fine[a];
  data.frame_origin = in_space(shift);
  data.length = in_space(m.frames.length);
  if (memory.swivelled_to || memory.holds_tip) {
    data.machine = rotary;
    data.follows_table = rotary.has_table();
    data.follows_head = rotary.has_head();
    data.controls_tip = memory.holds_tip;
    if (!memory.holds_tip) data.fixed = memory.swivelled_to;
  }
  auto made = std::make_shared<const FiveAxisTransform>(data);
  const auto now = made->turn();
  m.frames.space = std::move(made);
  if (now) m.frames.turn = std::make_shared<const FrameTurn>(FrameTurn{now->rows, data.main, {}});
}

/// Computes machine = origin + length + turn · (shift + work) of the settable frame in force, and the tool length along the normal of the
/// plane (spec/sinumerik 11.1, 13.1).
void Sinumerik::refresh_frames(Emitter& m) {
  const Frame& all = memory.active;
  const Placement before = m.frames;
  for (std::size_t a = 0; a < m.axis_count; ++a) m.frames.origin[a] = m.tables.common[a] + all.shift[a] + all.fine[a];
  m.frames.turn = nullptr;
  m.frames.space = nullptr;
  if (all.linear != unit_matrix && is_rotation(all.linear))
    m.frames.turn = std::make_shared<const FrameTurn>(FrameTurn{matrix_in_space(all.linear).rows, {0, 1, 2}, {}});
  m.frames.length = {};
  if (m.modal.offset_number != 0 && m.modal.offset_number < m.tables.offsets.size()) {
    const ToolOffset& offset = m.tables.offsets[m.modal.offset_number];
    m.use.note(UseKind::length, m.modal.offset_number, m.origin, offset.whole_length() == 0);
    const std::size_t normal = m.modal.axes.normal;
    constexpr std::array<std::array<std::size_t, 2>, 3> others{{{2, 1}, {0, 2}, {1, 0}}};  // lengths 2 and 3, by the axis of length 1
    m.frames.length[normal] = offset.whole_length();
    m.frames.length[others[normal][0] == normal ? others[normal][1] : others[normal][1]] += offset.length_x + offset.length_x_wear;
  }
  if (memory.in_space || memory.holds_tip) place_in_space(m);
  // Equal frames stay the same objects, so that a comparison of placements finds no change.
  if (before.turn && m.frames.turn && *before.turn == *m.frames.turn) m.frames.turn = before.turn;
  if (before.space && m.frames.space &&
      static_cast<const FiveAxisTransform&>(*before.space).data() == static_cast<const FiveAxisTransform&>(*m.frames.space).data())
    m.frames.space = before.space;
}

}  // namespace kadr::sinumerik
