#pragma once
// Dialect: what a control does that no row of its file can say (`dialect = "…"` in controls/*.toml). One object a channel; the interpreter
// asks it block by block or motion by motion, never word by word. Each default is what all controls do: ISO 6983. A control whose file says
// everything has these defaults (make_iso_dialect()). Its functions are in five interfaces; what needs one of them takes that one.

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

// Each stands in the folder of its name.
std::unique_ptr<Dialect> make_s2c42_dialect();
std::unique_ptr<Dialect> make_correctors_dialect(const BlockContext& m, const Setup& setup);
std::unique_ptr<Dialect> make_grbl_dialect(const Setup& setup);
std::unique_ptr<Dialect> make_mach3_dialect(const RunLimits& limits);
std::unique_ptr<Dialect> make_linuxcnc_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits);
std::unique_ptr<Dialect> make_nct_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);

/// Of a control whose file says everything: each answer is the default.
std::unique_ptr<Dialect> make_iso_dialect();

/// The dialect that the control's file names. `commons`: variables that all channels of the machine share.
std::unique_ptr<Dialect> make_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);

}  // namespace kadr
