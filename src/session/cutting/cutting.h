#pragma once
// Cutting: the steps of a run, carried out on the part: which tool goes where, what it takes away, what it must not have touched.
//
//   Step ─ ToolWay ─▶ pieces ─▶ Stock (in batches) ─▶ Touch ─▶ CutFinding
//
// Pieces are cut in batches: findings come when their batch is done. Until the work system of the blank is known (the first motion at feed)
// pieces are kept.

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "config/tool_library.h"
#include "session/cutting/tool_way.h"
#include "stock/cut_result.h"
#include "stock/stock.h"

namespace kadr {

struct CutJob {
  std::shared_ptr<const Blank> blank;
  std::vector<std::shared_ptr<const Blank>> fixtures;  // never to be cut
  ToolLibrary tools;
  /// By tool: how long it really is, where the control's table says so under its own number. Others are as long as the control believes.
  std::map<std::uint32_t, double> lengths;
  std::shared_ptr<const MachineTree> machine;  // as its file describes it; nullptr: it does not
  double cell = 0.5;                           // mm
  int threads = 1;
  std::optional<std::uint8_t> system;  // of ToolWay
  bool wants_coolant = false;          // cutting without it is a warning
  std::uint32_t tool = 0;              // in the spindle at the start
  SpindleDir spindle = SpindleDir::stop;
  bool starts_known = false;  // the set-up says where the tool stands at the start; else it is known when each of X, Y, Z has been named
  double until = 1e300;       // s of the program: what comes later is not cut
  StopToken stop;
};

class Cutting {
 public:
  Cutting(const CutJob& job, const AxisRoles& roles);

  /// Called with each finding of a batch, in the order of the program.
  std::function<void(const CutFinding&)> on_finding;

  /// `longer`: s that the machine takes beyond Step::time.
  ///   returns  alarm tool_without_shape: nothing of the step is cut
  Status consume(const Step& step, double longer);
  /// All that has come is cut.
  void finish();
  /// After finish(), with the volume of the surface of what is left.
  CutResult result(double left, double error_bound) const;
  /// Line of the program that a sweep of the stock comes from; 0 for of_blank.
  std::uint32_t line_of(std::int32_t sweep) const { return sweep < 0 ? 0 : line_of_sweep_[std::size_t(sweep)]; }
  const Stock& stock() const { return stock_; }

 private:
  /// A motion whose pieces are in the batch.
  struct Moved {
    Origin origin;
    std::size_t first_sweep = 0;
    std::uint32_t tool = 0;
    std::size_t use = 0;             // of result_.tools
    AlarmId fault = AlarmId::count;  // of its cutting part, if that takes anything away; count: none
    bool cuts = false, lacks_coolant = false;
    double begins = 0, seconds = 0, length = 0;
  };
  struct Kept {
    Moved moved;
    std::vector<WayPiece> pieces;
    std::uint16_t shape;
  };
  void note(const Action& action);
  bool place_known(const Motion& motion);
  std::optional<std::uint16_t> shape_of_tool();
  AlarmId fault_of(const Motion& motion, const std::vector<WayPiece>& pieces) const;
  void add(const Moved& moved, const std::vector<WayPiece>& pieces, std::uint16_t shape);
  void shift_by_length();
  void release_kept();
  void cut();
  void count_removed();
  void tell(const std::vector<Touch>& touches, bool of_fixture);
  static AlarmId fault_of_touch(const Moved& moved, ToolPart part, bool of_fixture);
  void keep(const CutFinding& finding);
  std::size_t use_of(std::uint32_t tool);

  CutJob job_;
  ToolWay way_;
  Stock stock_;
  std::vector<std::unique_ptr<Stock>> fixtures_;
  std::set<std::uint32_t> without_coolant_;                      // lines
  std::vector<std::pair<std::uint32_t, std::uint16_t>> shapes_;  // tool → Stock::add_tool
  AxisMask unknown_ = 0;                                         // of X, Y, Z: where the tool stands along them nobody has said
  std::uint32_t tool_;
  SpindleDir spindle_;
  Coolant coolant_ = Coolant::off;
  std::vector<WayPiece> pieces_;
  std::vector<Kept> kept_;
  std::vector<Moved> batch_;
  std::deque<std::uint32_t> line_of_sweep_;  // a million grow without being moved
  Vec3 zero_;
  bool zero_known_ = false;
  struct Rate {
    double volume = 0, seconds = 0, length = 0;
    std::size_t use = 0;
  } rate_;
  CutResult result_;
};

}  // namespace kadr
