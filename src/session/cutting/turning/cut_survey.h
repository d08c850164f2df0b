#pragma once
// CutSurvey: what the tools of a run do, seen before the cut. It decides whether the part is cut exactly, as a body of revolution
// (session/cutting/turned_run), or on the lattice. It is used by cli/cut_guess.

#include <cstdint>
#include <functional>
#include <map>

#include "config/tools/tool_library.h"
#include "session/cutting/lathe_path.h"

namespace kadr {

class CutSurvey {
 public:
  /// True if a row of the control's offset table tells the form of a turning tool.
  using TellsInsert = std::function<bool(std::uint32_t row, std::uint32_t tool)>;

  /// `tools`: must outlive this object. `tool`: the tool in the spindle at the start.
  CutSurvey(const AxisRoles& roles, const ToolLibrary& tools, TellsInsert tells_insert, std::uint32_t tool);

  void take(const Step& step);

  /// Motions at feed of one kind, and the first of them.
  struct Motions {
    std::size_t count = 0;
    Origin first{};
    std::uint32_t tool = 0;
  };
  const Motions& turning() const { return turning_; }    // of turning tools in a plane through the axis
  const Motions& beside() const { return beside_; }      // of turning tools outside these planes
  const Motions& milling() const { return milling_; }    // of tools of revolution off the axis, without drills
  const Motions& drilling() const { return drilling_; }  // of drills off the axis
  const Motions& rotating() const { return rotating_; }  // of any tool, along a rotary axis
  /// True if a rotary axis has moved, at feed or at rapid.
  bool has_rotated() const { return has_rotated_; }
  /// Returns the rows of the offset table that tell the form of tools which `tools` does not contain, by number of the tool.
  const std::map<std::uint32_t, std::uint32_t>& rows() const { return rows_; }

  /// True if every motion at feed removes a body of revolution, and a turning tool is among the tools.
  bool is_turned() const {
    return turning_.count > 0 && beside_.count == 0 && milling_.count == 0 && drilling_.count == 0 && !has_rotated_;
  }
  /// True if a tool cuts what is no body of revolution: it mills, or the part is turned to a position (C axis) and drilled off its axis.
  bool mills() const { return milling_.count > 0 || rotating_.count > 0 || (has_rotated_ && drilling_.count > 0); }

 private:
  enum class Kind { unknown, turning, drill, mill };
  Kind kind_of(std::uint32_t row);

  LathePath path_;
  AxisRoles roles_;
  const ToolLibrary& tools_;
  TellsInsert tells_insert_;
  std::uint32_t tool_;
  Motions turning_, beside_, milling_, drilling_, rotating_;
  bool has_rotated_ = false;
  std::map<std::uint32_t, std::uint32_t> rows_;
};

}  // namespace kadr
