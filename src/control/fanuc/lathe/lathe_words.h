#pragma once
// Words of the turning cycles whose numbers count in another way than other words (spec/fanuc-t 1.4, 9.10).

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class BlockContext;
class Emitter;
struct Call;
}  // namespace kadr

namespace kadr::fanuc {

/// Returns the number of a word as its digits read, even if the reader has already counted it in least increments; 0 without the word.
double digits_of(const BlockContext& m, char letter);
/// Returns the least increment of the control in mm: 0.001 mm, in G20 0.0001 in (spec/fanuc 1.3).
double least_increment(const BlockContext& m);
/// Returns a length in mm of a word that is written without a decimal point, in least increments: 0.001 mm, in G20 0.0001 in (P, Q, D of
/// the cycles). A number with a point is a length in the unit in force. Returns 0 without the word.
double step_of(const BlockContext& m, char letter);
/// Checks that a word has no decimal point (spec/fanuc-t 1.4). alarms point_not_allowed (PS0007)
Status no_point(const BlockContext& m, char letter);
/// Checks the words of a thread's block on Fanuc's lathes: no corner (3.4), and Q without a decimal point (1.4).
///   alarms  corner_in_thread (PS0050), point_not_allowed (PS0007)
Status check_thread_words(const BlockContext& m, const Call& call);
/// Returns the start angle of a thread in degrees: Q without a point counts 0.001° (spec/fanuc-t 8.1).
double start_angle_of(const BlockContext& m);
/// Returns the length of a thread's run-out in leads: that of the last first block of G76, before it that of the parameter, which are one
/// datum (spec/fanuc-t 8.4, 9.9); 0 after M24 of a Haas (spec/haas-st 5).
double run_out_leads(const BlockContext& m);
/// Returns the mean lead in mm of a thread to the programmed point `to` whose lead changes by K per revolution (G34, spec/fanuc-t 8.2). The
/// lead belongs to the axis with the longer travel.
///   alarms  thread_lead_change (PS0313): the lead becomes 0 or negative
Result<double> mean_lead(const BlockContext& m, double lead, const Axes& to, AxisMask named);

}  // namespace kadr::fanuc
