// The behaviour of Mach3 that no row of its file can describe: after a probe motion the probe returns from the point of contact, and M40
// opens the file of probed points (10.7.12.1). Tested by tests/cases/mach3/probe.cases.

#include "control/dialect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "control/files/file_writer.h"
#include "control/functions/cutter_compensation.h"
#include "control/interpreter.h"

namespace kadr::mach3 {
namespace {

/// Name of the file of probed points in the program memory. INFERRED: Mach3 asks the operator for a name (OpenDigFile); Kadr always uses
/// the name `points.txt`, and empties the file first.
constexpr std::string_view points_file = "points.txt";
constexpr files::FileMode emptied{.creates = true, .takes_existing = true, .appends = false};

class Mach3 final : public Dialect {
 public:
  explicit Mach3(const RunLimits& limits)
      : points_({.root = limits.files,
                 .writing = limits.writes_files ? files::OutputWriting::files : files::OutputWriting::nothing,
                 .untouched = limits.untouched}) {}

  bool lines_follow(const BlockContext&) const override { return true; }
  bool contour_follows(const BlockContext& m) const override { return continues_contour(m.modal); }

  void before_function(Emitter& m, Function function) override {
    if (function == Function::probe) begin_ = m.position.work;
  }

  Status accept_answer(Emitter& m, const ProbeAnswer& answer) override {
    KADR_TRY(m.note_answer(answer));
    KADR_TRY(write_point(m));
    double travel = 0;
    for (std::size_t a = 0; a < m.axis_count; ++a) travel += (answer.at[a] - begin_[a]) * (answer.at[a] - begin_[a]);
    travel = std::sqrt(travel);
    const double part = travel > 0 ? std::min(1.0, m.def.behaviour.probe_retract / travel) : 0;
    if (part == 0) return {};
    back_ = Back{};
    back_->origin = m.origin;
    for (std::size_t a = 0; a < m.axis_count; ++a) {
      const double by = part * (begin_[a] - answer.at[a]);
      if (by != 0) back_->named |= AxisMask{1} << a;
      m.position.work[a] += by;
      m.position.machine[a] += by;
    }
    m.position.programmed = m.transform.to_programmed(m.position.work);
    return {};
  }

  /// Emits the return of the probe: "The probe is drawn straight back from the point at the end of the command." INFERRED: the return is at
  /// rapid. The motion is emitted before the first block that does more than assign variables.
  void begin_block(Emitter& m) override {
    if (!back_ || sets_variables_only(*m.block)) return;
    const Back back = *std::exchange(back_, std::nullopt);
    const Origin now = std::exchange(m.origin, back.origin);
    (void)m.straight(MotionKind::rapid, m.position.programmed, back.named);
    m.origin = now;
  }

  /// Executes M40, which opens the file of probed points, and other M codes. INFERRED: a second M40 has no effect while the file is open.
  Status machine_code(Interpreter& m, const Call& call) override {
    constexpr std::int32_t opens = 400;  // M40, in tenths
    if (call.word->code == opens && !points_.is_open()) {
      KADR_TRY(placed(points_.open({.path = std::string(points_file),
                                    .shown = std::string(points_file),
                                    .rule = emptied,
                                    .exists = AlarmId::file_exists,
                                    .missing = AlarmId::file_missing,
                                    .running = {}}),
                      call.where));
      note();
    }
    return m.emit_machine_function(call);
  }

  const WrittenFiles& files_written() const override { return written_; }

  std::shared_ptr<const DialectState> snapshot() const override { return std::make_shared<Memory>(begin_, back_, points_.memory()); }
  Status restore(BlockContext&, const DialectState& from) override {
    const auto& memory = static_cast<const Memory&>(from);
    begin_ = memory.begin;
    back_ = memory.back;
    KADR_TRY(points_.resume_from(memory.points));
    note();
    return {};
  }

 private:
  /// The return of the probe to the start of its motion, stored until begin_block() emits it.
  struct Back {
    Origin origin;
    AxisMask named = 0;
  };
  struct Memory : DialectState {
    Memory(const Axes& begin_now, const std::optional<Back>& back_now, files::FileWriter::Memory points_now)
        : begin(begin_now), back(back_now), points(std::move(points_now)) {}
    Axes begin;
    std::optional<Back> back;
    files::FileWriter::Memory points;
  };

  static Status placed(const Status& status, Span where) {
    if (status) return {};
    Alarm alarm = status.error();
    alarm.where = where;
    return fail(alarm);
  }

  /// Writes a probed point to the file: the coordinates X, Y, Z, which are #2000 to #2002. INFERRED: the file has one line per point, with
  /// commas and four decimals.
  Status write_point(const BlockContext& m) {
    if (!points_.is_open()) return {};
    std::string line;
    constexpr std::uint32_t first = 2000, coordinates = 3;
    for (std::uint32_t i = 0; i < coordinates; ++i) {
      const auto value = m.variables.variable(first + i, m.probe_where);
      if (!value) return fail(value.error());
      line += fmt::format("{}{:.4f}", i == 0 ? "" : ",", *value);
    }
    KADR_TRY(placed(points_.write(line + "\n"), m.probe_where));
    note();
    return {};
  }

  void note() { written_ = points_.files(); }

  files::FileWriter points_;
  WrittenFiles written_;
  Axes begin_{};  // start of the probe motion, work coordinates
  std::optional<Back> back_;
};

}  // namespace
}  // namespace kadr::mach3

namespace kadr {

std::unique_ptr<Dialect> make_mach3_dialect(const RunLimits& limits) { return std::make_unique<mach3::Mach3>(limits); }

}  // namespace kadr
