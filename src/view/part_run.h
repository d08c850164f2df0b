#pragma once
// PartRun: cuts a blank with a program, for the page. It finds collisions, the remaining stock, and the state of the part at any instant
// (docs/panel-protocol.md: cut, part).
//
//   PartRequest ─ PartRun::make() ─▶ its own session ─┬─ view/turned_part: a turned part, exactly
//                                                     └─ view/lattice_part: any other part, on a lattice
//
// What is turned is decided as by `kadr cut` (session/cutting/turned_run.h: turned_job_of).

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "session/cutting/cutting.h"
#include "stock/surface/surface.h"
#include "stock/turned/turned_stock.h"
#include "view/opening.h"
#include "view/progress_clock.h"

namespace kadr {

/// The blank, fixtures and tools of a cut. Solids are descriptions for body_of(), in which files are paths in the file system.
struct PartRequest {
  std::string stock;
  std::vector<std::string> fixtures;
  std::vector<std::string> fixture_names;  // names of the fixtures as the page displays them
  ToolLibrary tools;
  double resolution = 0;  // cell size of the stock in mm; 0 if Kadr is to choose it, or if the part is turned
  Vec3 zero;              // machine position of the picture's zero, mm (PathRecord::zero)
};

/// The remaining stock at an instant.
struct PartThen {
  double seconds = 0;  // the instant in s; at most the end of the program
  double stock = 0;    // volume of the blank, mm³
  double left = 0;
  double cell = 0;  // cell size of the displayed stock, mm; of a turned part the greatest deviation of the triangles
  Surface surface;  // surface of the stock, in the work coordinates of the blank; `made_by` holds numbers for maker_of()
  // Of a turned part, the sections by the planes Y0 and X0: polygons with the radius as x and Z as y, mm. Empty if it is cut on a lattice.
  TurnedRegion section, section_y;
  std::vector<Vec2> edges;  // of a turned part, the circles at which its surface has an edge: radius and Z, mm
};

/// The outline of one body of a turning tool in the half plane of the part, relative to the programmed point, mm.
struct ShownInsert {
  std::uint32_t tool = 0;
  ToolPart part = ToolPart::cutting;
  TurnedPolygon outline;
};

class PartRun {
 public:
  static constexpr double max_bytes = 400e6;  // memory limit in bytes for all stocks, including earlier states of the displayed one

  /// Creates a run.
  ///   opened   the program; must outlive this object
  ///   returns  the run, or an error sentence
  static tl::expected<std::unique_ptr<PartRun>, std::string> make(const OpenedProgram& opened, const PartRequest& request,
                                                                  const StopToken& stop);
  virtual ~PartRun() = default;

  /// A function of the client that receives the progress of the run, from 0 to 1. PartRun calls this function several times per second.
  std::function<void(double part)> on_progress;
  std::function<void(const CutFinding&, const AlarmReport&)> on_finding;

  /// Runs the program to its end, or to an alarm.
  ///   returns  an error sentence if the run was stopped, memory ran out, or the shape of a tool is unknown
  virtual tl::expected<void, std::string> execute() = 0;

  // ---- functions that return the results of the run; to be called after execute()
  const CutResult& result() const { return result_; }
  /// Returns the number of alarms, and that of warnings, that the program itself has caused.
  virtual std::size_t alarms() const = 0;
  virtual std::size_t warnings() const = 0;
  /// Sentences about mesh files that were repaired, and about questionable input that was used unchanged.
  const std::vector<std::string>& notes() const { return notes_; }
  virtual PartThen at(double instant) const = 0;
  /// Returns the outlines of the turning tools that were used; empty unless the part is turned exactly.
  virtual std::vector<ShownInsert> inserts() const { return {}; }
  /// Returns the zero of the blank's work coordinates in machine coordinates, mm.
  virtual Vec3 zero() const = 0;
  /// Converts a state of the stock to a binary frame of kind 3.
  std::string frame_of(const PartThen& then) const;

 protected:
  PartRun(const OpenedProgram& opened, const StopToken& stop) : opened_(opened), stop_(stop) {}
  /// The tool that has made a part of the surface, and the line of the program. Tool 65535: no tool has.
  struct Maker {
    std::uint32_t tool = 65535, line = 0;
  };
  virtual Maker maker_of(std::int32_t number) const = 0;
  /// Returns the alarm at which cutting stopped because the shape of a tool is unknown; nullopt if all shapes were known.
  virtual const std::optional<AlarmReport>& without_shape() const = 0;
  virtual double bytes() const = 0;

  tl::expected<void, std::string> open_session(bool starts_known);
  /// Runs the session to its end, or until something ends the run.
  tl::expected<void, std::string> run_session();
  tl::expected<void, std::string> fault() const;
  void report_progress();

  const OpenedProgram& opened_;
  StopToken stop_;
  CutJob job_;
  std::vector<std::string> notes_;
  std::unique_ptr<Session> session_;
  CutResult result_;
  ProgressClock progress_clock_;
  bool too_much_ = false;  // true if the run has exceeded the memory limit
};

}  // namespace kadr
