#pragma once
// What lathes have besides the functions of mills (spec/fanuc-t, spec/haas-st): T with geometry and wear, tables of turning tools, drilling
// on the face and on the side, and the turning cycles G70 to G76 in two blocks or in one block. Lengths along X are radii.

#include <cstdint>
#include <optional>

#include "base/result.h"
#include "base/span.h"
#include "base/vec.h"

namespace kadr {
class BlockContext;
class Emitter;
class Interpreter;
struct Call;
struct CodeRow;
}  // namespace kadr

namespace kadr::fanuc {

class Fanuc;

/// Sets the data of the turning cycles to the values of the parameters, in which the control stores them (spec/fanuc-t 9.1, 13).
void start_turning_memory(Fanuc& fanuc);

/// Executes T: the turret turns to the tool, and the offset takes effect (spec/fanuc-t 4.1).
///   alarms  turret_number; offset_number_large (PS0030)
Status turret(Emitter& m, const Call& call);
/// Ends the tool offset without a motion: a reset, if 5003#6 is set (spec/fanuc-t 1.2). The caller then updates the frames.
void end_turret_offset(BlockContext& m);
/// Returns the number of the imaginary tip as it acts: on the second turret (G68) the tips on the two sides of the nose change places
/// (spec/fanuc-t 11.3).
std::uint8_t nose_in_force(const BlockContext& m, std::uint8_t tip);
/// Executes G10 without L, and that with the L of is_turret_table(): sets the tool offsets (spec/fanuc-t 4.3, spec/haas-st 3).
///   alarms  table_kind_unknown (PS0031), offset_value (PS0032), word_missing
Status set_turret_offset(Emitter& m, const Call& call);
/// Returns true if the word L of G10 means the table of turning tools: L1, L10 and L11 on a Haas.
bool is_turret_table(const BlockContext& m, std::uint32_t l);

/// Returns true if the control is that of a Haas lathe.
bool is_haas(const BlockContext& m);
/// Returns true for a drilling cycle of a Haas along X: G241 to G249, G195, G196 (spec/haas-st 7.2, 7.3).
bool drills_on_side(const CodeRow& row);
/// Called after each executed M code of a Haas: M23 switches the run-out of threads on, M24 off (spec/haas-st 5).
void note_run_out(Fanuc& fanuc, const CodeRow& row);

/// Executes G83 to G85 on the face and G87 to G89 on the side (spec/fanuc-t 10).
Status turned_drilling(Emitter& m, const Call& call);

/// Executes a block with G70 … G76 (spec/fanuc-t 9). call.row->arg is 707 for G70 … 767 for G76.
Status turned_cycle(Interpreter& m, const Call& call);

/// Executes the second block of a cycle, or its only block: lathe_finish() of G70, lathe_rough() of G71 and G72, lathe_pattern() of G73
/// (spec/fanuc-t 9.2 to 9.6).
Status lathe_finish(Interpreter& m, const Call& call);
Status lathe_rough(Interpreter& m, const Call& call);
Status lathe_pattern(Interpreter& m, const Call& call);
/// Executes a block with G74 or G75 (9.7, 9.8), and one with G76 (9.9).
Status lathe_groove(Emitter& m, const Call& call);
Status lathe_thread(Emitter& m, const Call& call);

}  // namespace kadr::fanuc
