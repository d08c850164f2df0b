#pragma once
// JobNeeds: what a program needs of a machine with Grbl, found by executing it. grbl_proof compares it with the controller.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drive/grbl/grbl_settings.h"
#include "session/session.h"

namespace kadr::drive {

struct JobNeeds {
  std::optional<GrblPoint> least, most;   // extents of the path in machine coordinates, mm; nullopt: nothing moves
  GrblPoint start{};                      // position before the first motion, machine coordinates
  std::optional<GrblPoint> first_target;  // end of the first motion
  std::uint32_t first_line = 0;           // its line
  std::string first_text;                 // and its text
  double feed = 0;                        // greatest feed, mm/min
  double speed = 0;                       // greatest spindle speed, rev/min
  bool turns_spindle = false, probes = false;
  std::uint64_t lines = 0, stops = 0;    // lines that are sent, and stops of the program
  double seconds = 0;                    // time of all lines
  std::optional<AlarmReport> alarm;      // the alarm that stopped the run
  std::optional<std::uint32_t> refused;  // a line that may not be sent: a `$` line
  std::string impossible;                // why the machine cannot execute a line of the program; empty: it can
  std::uint32_t impossible_line = 0;     // this line
};

/// Notes the feed and the spindle speed of an action.
void note_speeds(JobNeeds& needs, const Step& step);
/// Notes the path of a motion, and whether it is the first one.
///   path  its points, from its start; not empty
///   line  its line
/// Returns true if it is the first motion.
bool note_path(JobNeeds& needs, const std::vector<GrblPoint>& path, std::uint32_t line);
/// Returns the points of a motion in machine coordinates, from its start; only the start if it has no length. Arcs have chords.
std::vector<GrblPoint> path_of(const Step& step, const Motion& motion);

/// Executes a program of any control, and writes its lines for the controller (GrblWriter) without keeping them. The session has not begun.
JobNeeds needs_of(Session& session, const GrblSettings& settings, const StopToken& stop);

/// Returns the set-up for a program that a panel runs on this controller: rates and accelerations are the controller's; work offsets that
/// the set-up does not state are its too, and its settings are parameters, if the program is for this controller.
///   own  the control of a program for this controller; nullptr: the program is for another control
Setup setup_with_controller(Setup setup, const GrblSettings& settings, const ControlDef* own);

}  // namespace kadr::drive
