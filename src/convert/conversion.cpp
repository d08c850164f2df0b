// From control to control. For cli/convert; tested by tests/convert.py, tests/convert.

#include "convert/conversion.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/setup_check.h"
#include "convert/flat_program.h"
#include "convert/source_comments.h"
#include "out/program/words.h"

namespace kadr {
namespace {

bool has_key(const ControlDef& def, const char* name) {
  const nlohmann::json table = {{name, nlohmann::json::object()}};
  return !fault_of(table, table, &def);
}

bool is_system(const CodeRow& row) { return row.function == Function::fixture || row.function == Function::work_zero || row.function == Function::work_system || row.function == Function::table_system; }

/// Rows of the work zeros by number, whatever the control calls them.
std::map<int, AxisValues> zeros_of(const Setup& setup, const ControlDef& def) {
  std::map<int, AxisValues> zeros = setup.zeros;
  for (const CodeRow& row : def.codes)
    if (is_system(row) && row.arg > 0)
      if (const auto found = setup.work_offsets.find(row.code); found != setup.work_offsets.end()) zeros[row.arg] = found->second;
  return zeros;
}

OffsetsInForce offsets_of(const Control& control) {
  OffsetsInForce now;
  double length = 0, radius = 0;
  for (const InForce& one : control.in_force()) {
    if (one.kind == InForce::Kind::offset) radius = one.value;
    if (one.kind == InForce::Kind::length_offset) length = one.value;
    if (one.kind == InForce::Kind::code && (one.code == "G43" || one.code == "G44")) now.length_sign = one.code == "G43" ? 1 : -1;
  }
  now.radius_number = std::uint32_t(radius);
  now.length_number = std::uint32_t(length != 0 ? length : radius);
  return now;
}

bool has_systems(const ControlDef& def) { return std::any_of(def.codes.begin(), def.codes.end(), is_system); }

FlatSource source_of(const Session& session) {
  FlatSource source{session.control().axes(), {}, has_systems(session.def())};
  for (const auto& [number, values] : zeros_of(session.setup(), session.def()))
    for (std::size_t a = 0; a < source.axes.size() && a < max_axes; ++a)
      if (const auto found = values.find(source.axes[a]); found != values.end()) source.zeros[number][a] = found->second;
  return source;
}

/// One way of saying it.
class Writing {
 public:
  Writing(const ConversionSpec& spec, ConvertedAs as) : spec_(spec), blocks_(*spec.to, [this](std::string_view line) { made_.text += line; }), comments_(spec.source_text) { made_.as = as; }

  tl::expected<ConversionTry, std::string> write() {
    auto opened = spec_.source();
    if (!opened) return tl::unexpected(opened.error());
    session_ = std::move(*opened);
    const FlatWay way = made_.as == ConvertedAs::contours ? FlatWay::contours : made_.as == ConvertedAs::lengths ? FlatWay::lengths : FlatWay::plain;
    Control& control = session_->control();
    control.hand_over_each_block();
    FlatProgram flat(blocks_, source_of(*session_), way);
    flat_ = &flat;
    Outlets& outlets = session_->outlets();
    outlets.stop = spec_.stop;
    if (way == FlatWay::contours) {
      outlets.programmed = [this](const Action& action) { take(action, nullptr); };
      outlets.step = [](const Step&) {};
    } else {
      outlets.step = [this](const Step& step) { take(step.action, &step); };
    }
    note(flat.begin(session_->stand(), control.placement()));
    while (!made_.cannot_say && session_->go_on() == Session::State::running) {}
    if (!made_.cannot_say) note(flat.finish());
    for (const std::string& comment : comments_.rest()) blocks_.comment(comment), (void)blocks_.end();
    return std::move(made_);
  }

 private:
  void note(const Status& status) {
    if (!status && !made_.cannot_say) made_.cannot_say = status.error(), made_.at = at_;
  }

  void take(const Action& action, const Step* step) {
    if (made_.cannot_say) return;
    const Origin& origin = action.origin;
    if (origin.number != at_.number || origin.line != at_.line || origin.file != at_.file) {
      note(flat_->end_block());
      at_ = origin;
      bool may_change = origin.file != 0;
      if (origin.file == 0) {
        for (const std::string& comment : comments_.up_to(origin.line)) blocks_.comment(comment), note(blocks_.end());
        may_change = comments_.names_rows();
      }
      if (may_change || has_changed_) now_ = offsets_of(session_->control());  // it costs more than the block itself
      has_changed_ = may_change;
      if (origin.has_block && origin.file == 0 && origin.line != numbered_) blocks_.set_number(origin.block);
      numbered_ = origin.line;
    }
    note(flat_->take(action, step, now_));
  }

  const ConversionSpec& spec_;
  ConversionTry made_;
  BlockMaker blocks_;
  SourceComments comments_;
  std::unique_ptr<Session> session_;
  FlatProgram* flat_ = nullptr;
  Origin at_;
  std::uint32_t numbered_ = 0;  // the line
  bool has_changed_ = true;     // the block before may have changed what is in force
  OffsetsInForce now_;
};

}  // namespace

Setup corresponding_setup(const Setup& setup, const ControlDef& from, const ControlDef& to, bool plain) {
  Setup made;
  made.start = setup.start, made.start_in_work = setup.start_in_work;
  made.machine = setup.machine, made.axis_limits = setup.axis_limits;
  made.skip = setup.skip, made.optional_stop = setup.optional_stop;
  made.spindles = setup.spindles;
  made.feed_override = setup.feed_override, made.rapid_override = setup.rapid_override, made.spindle_override = setup.spindle_override;
  made.tool = setup.tool;
  made.clock = setup.clock;
  if (has_key(to, "probe")) made.probe = setup.probe;
  if (plain) return made;
  if (has_key(to, "offsets")) made.offsets = setup.offsets;
  const std::map<int, AxisValues> zeros = zeros_of(setup, from);
  if (has_key(to, "zeros")) made.zeros = zeros;
  else
    for (const CodeRow& row : to.codes)
      if (is_system(row) && row.arg > 0)
        if (const auto found = zeros.find(row.arg); found != zeros.end()) made.work_offsets[row.code] = found->second;
  return made;
}

std::string setup_text(const Setup& setup) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  const auto put_axes = [](nlohmann::ordered_json& to, const AxisValues& values) {
    to = nlohmann::ordered_json::object();
    for (const auto& [axis, value] : values) to[axis] = value;
  };
  if (!setup.start.empty()) put_axes(all["start"], setup.start);
  for (const auto& [name, values] : setup.work_offsets) put_axes(all["work_offsets"][name], values);
  for (const auto& [number, values] : setup.zeros) put_axes(all["zeros"][std::to_string(number)], values);
  for (const auto& [number, offset] : setup.offsets) {
    nlohmann::ordered_json& row = all["offsets"][std::to_string(number)];
    row = nlohmann::ordered_json::object();
    for (const auto& [name, value] : {std::pair{"length", offset.length}, {"length_wear", offset.length_wear}, {"radius", offset.radius}, {"radius_wear", offset.radius_wear}})
      if (value != 0) row[name] = value;
  }
  if (setup.tool != 0) all["tool"] = setup.tool;
  if (!setup.skip.empty()) all["skip"] = setup.skip;
  if (setup.optional_stop) all["optional_stop"] = true;
  return all.dump(1) + "\n";
}

double usual_tolerance(const ControlDef& from, const ControlDef& to) {
  return std::sqrt(3.0) / 2 * std::max(Words(from, 'X').increment(), Words(to, 'X').increment());
}

tl::expected<Converted, std::string> converted(const ConversionSpec& spec) {
  Converted all;
  CompareRules rules;
  rules.stop = spec.stop;
  rules.tolerance = all.tolerance = spec.tolerance;
  for (const ConvertedAs as : {ConvertedAs::as_it_stands, ConvertedAs::contours, ConvertedAs::lengths, ConvertedAs::plain}) {
    if (as == ConvertedAs::as_it_stands && spec.flat) continue;
    ConversionTry one;
    one.as = as;
    if (as == ConvertedAs::as_it_stands) {
      one.text = spec.source_text;
    } else {
      auto written = Writing(spec, as).write();
      if (!written) return tl::unexpected(written.error());
      one = std::move(*written);
    }
    if (!one.cannot_say && !spec.stop.asked()) {
      auto a = spec.source();
      if (!a) return tl::unexpected(a.error());
      auto b = spec.target(one.text, as == ConvertedAs::plain);
      if (!b) return tl::unexpected(b.error());
      one.proof = compare_sessions(std::move(*a), std::move(*b), rules);
    }
    const bool is_proven = !one.cannot_say && one.proof.equal() && !one.proof.stopped_a && !one.proof.stopped_b;
    all.tries.push_back(std::move(one));
    if (spec.stop.asked()) break;
    if (is_proven) {
      all.taken = all.tries.size() - 1;
      break;
    }
  }
  return all;
}

}  // namespace kadr
