// Cuts with a tilted tool, with the vectors of AVX2. Used by stock/cut/tilted_cut, which checks that the processor has AVX2.

// All code without lanes is included before the pragma, so that this code is compiled without AVX2. Otherwise the linker could use a copy
// of a function from this file in the whole program, also on processors without AVX2.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "stock/cut/brick_cut.h"
#include "stock/cut/tilted_cut.h"
#include "stock/cut/tilted_over.h"

#if defined(__x86_64__) && defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#elif defined(__x86_64__)
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

#include "stock/cut/tilted_ball_cutter.h"
#include "stock/cut/tilted_cutter.h"
#include "stock/cut/tilted_later.h"

namespace kadr {

#ifdef __EMSCRIPTEN__  // vectors of a browser have 16 bytes, so nobody asks for wider ones
void cut_tilted_wide(TiltedCutter& cutter) { cut_tilted_pair(cutter); }
#else
void cut_tilted_wide(TiltedCutter& cutter) { cutter.cut<Wide>(); }
#endif

}  // namespace kadr

#if defined(__x86_64__) && defined(__clang__)
#pragma clang attribute pop
#elif defined(__x86_64__)
#pragma GCC pop_options
#endif
