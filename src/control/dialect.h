#pragma once
// Dialect: the behaviour of a control that no row of its file can describe (`dialect = "…"` in controls/*.toml). Each channel has one
// object, which the interpreter calls per block or per motion, never per word. The default of each function is the behaviour of all
// controls, by ISO 6983. A control that its file describes completely has only the defaults (make_iso_dialect()). The functions are grouped
// in five interfaces, so that code can depend on the one interface that it needs.

#include <memory>

#include "control/dialect/block_dialect.h"
#include "control/dialect/frame_dialect.h"
#include "control/dialect/motion_dialect.h"
#include "control/dialect/program_dialect.h"
#include "control/dialect/variable_dialect.h"

namespace kadr {

struct Commons;
struct RunLimits;

class Dialect : public ProgramDialect, public BlockDialect, public MotionDialect, public FrameDialect, public VariableDialect {};

// These functions create dialects. Each of them is defined in the folder of its dialect.
std::unique_ptr<Dialect> make_s2c42_dialect();
std::unique_ptr<Dialect> make_correctors_dialect(const BlockContext& m, const Setup& setup);
std::unique_ptr<Dialect> make_grbl_dialect(const Setup& setup);
std::unique_ptr<Dialect> make_mach3_dialect(const RunLimits& limits);
std::unique_ptr<Dialect> make_linuxcnc_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits);
std::unique_ptr<Dialect> make_nct_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);
std::unique_ptr<Dialect> make_sinumerik_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits);
std::unique_ptr<Dialect> make_heidenhain_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits);

/// Creates the dialect of a control that its file describes completely: every function has its default behaviour.
std::unique_ptr<Dialect> make_iso_dialect();

/// Creates the dialect that the control's file names. `commons`: common variables, which all channels of the machine share.
std::unique_ptr<Dialect> make_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);

}  // namespace kadr
