#pragma once
// GrblWriter: the actions of any program as lines for a controller of the Grbl family. Every motion is written with its resolved path, in
// the controller's work offset G54, so that no mode, offset or cycle of the program has to be known to the controller.
//
//   Step (machine coordinates, mm, mm/min, s) ──▶ "G1X10Y5F600" with its path and its time
//
// Law (tests/drive/grbl_writer_test.cpp): the controller's path of the lines is the path of the actions, within `chord`.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "action/step.h"
#include "drive/grbl/grbl_settings.h"
#include "drive/grbl/job_line.h"

namespace kadr::drive {

class GrblWriter {
 public:
  static constexpr double chord = 0.002;  // greatest distance of a written chord from the path, mm

  /// `settings`: what the controller has answered after its last reset.
  explicit GrblWriter(const GrblSettings& settings);

  /// Forgets what the controller has in force: it was reset, or the axes were moved otherwise. The next lines state everything.
  void forget();
  /// The feed, mm/min, that replaces all feeds; 0: the programmed feeds.
  void run_dry(double feed) { dry_feed_ = feed; }
  /// If `on`, a spindle that was stopped for a tool change starts again before the next motion.
  void restore_spindle(bool on) { restores_spindle_ = on; }

  /// Returns the lines of an action; none if the controller has nothing to do.
  ///   number   the number that the lines get (JobLine::number)
  ///   returns  an error sentence for an action that such a machine does not have: a rotary axis, a thread, a probe motion
  tl::expected<std::vector<JobLine>, std::string> write(const Step& step, std::uint32_t number);
  /// Returns the lines of a probe motion by hand.
  ///   from, end  machine coordinates, mm; `feed` mm/min
  std::vector<JobLine> probe(const GrblPoint& from, std::size_t axis, double end, double feed);
  /// Number of stops of the program so far: M0, M1, and tool changes.
  std::uint64_t stops() const { return stops_; }

 private:
  using Written = tl::expected<void, std::string>;
  Written motion(const Step& step, const Motion& motion);
  Written spindle(const Spindle& spindle, double pause);
  void switch_spindle();
  void stop_for_tool();
  void coolant(Coolant what);
  void line(const Step& step, const Motion& motion);
  void chords(const Step& step, const Motion& motion);
  bool arc(const Step& step, const Motion& motion);
  void add(std::string text, double seconds, std::vector<GrblPoint> path);
  void add_plain(std::string text, double seconds) { add(std::move(text), seconds, {}); }
  std::string to(const GrblPoint& end);
  double feed_of(const Step& step, const Motion& motion) const;
  std::string feed_word(double feed);
  double seconds_of(const std::vector<GrblPoint>& path, double feed) const;

  GrblPoint shift_{};        // machine coordinates minus the controller's work coordinates, mm
  GrblPoint rate_{};         // greatest feed of each axis, mm/min
  double acceleration_ = 0;  // the least of all axes, mm/s²
  double dry_feed_ = 0;
  std::string spindle_;  // the line that has switched the spindle on; empty: it is off
  double spin_up_ = 0;   // time until it is at its speed, s
  bool spindle_waits_ = false, restores_spindle_ = true;
  std::optional<GrblPoint> at_;  // where the last line ends, machine coordinates; nullopt: not known
  bool has_modes_ = false;       // the modes that the lines need were sent
  int motion_ = -1, plane_ = 17;
  std::string feed_, speed_;    // the last words F and S
  std::vector<JobLine> lines_;  // of the present action
  std::uint32_t number_ = 0;
  std::uint64_t stops_ = 0;
  std::uint32_t changes_tool_ = 0;  // number of the last block with a tool change; 0: none
};

}  // namespace kadr::drive
