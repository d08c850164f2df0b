#pragma once
// Lanes: eight single-precision numbers that are computed in parallel, as one vector of the processor (Wide) or as two vectors (Pair).
//
// Code that is written once for both types, as `template <class V>`, gives the same result with either type, bit for bit: +, -, *, / and
// the square root are rounded alike on all processors, and the compiler never fuses two operations (-ffp-contract=off).
//
// A function that uses lanes is compiled for the processors that have such vectors. Small functions are inlined into their callers
// (KADR_IN_LANES). Large functions that are called from several places are not (KADR_OWN_FUNCTION): inlining them everywhere would give
// 2.7 MB of code. The functions for Wide are compiled only in tilted_cut_wide.cpp, where the compiler may use AVX2. Functions in that file
// that are not templates of V are inlined too, so that no other file calls a function that needs AVX2 (tests/wide_lanes.py).

#include <cmath>
#include <cstdint>

// Switches off a warning of GCC that passing vectors by value depends on AVX: here vectors are never passed by value.
#pragma GCC diagnostic ignored "-Wpsabi"

#define KADR_IN_LANES inline __attribute__((always_inline))
#define KADR_OWN_FUNCTION __attribute__((noinline))

namespace kadr::lanes {

inline constexpr int lane_count = 8;

// ---- functions for one vector of 32 bytes

using Wide = float __attribute__((vector_size(32), may_alias));
// Result of a comparison: all bits of a lane are set if the comparison is true, else none.
using WideMarks = std::int32_t __attribute__((vector_size(32), may_alias));

KADR_IN_LANES Wide choose(const WideMarks& m, const Wide& a, const Wide& b) { return m ? a : b; }
KADR_IN_LANES WideMarks choose(const WideMarks& m, const WideMarks& a, const WideMarks& b) { return m ? a : b; }
KADR_IN_LANES Wide least(const Wide& a, const Wide& b) { return a < b ? a : b; }
KADR_IN_LANES Wide most(const Wide& a, const Wide& b) { return a > b ? a : b; }
KADR_IN_LANES bool any(const WideMarks& m) {
  using Words = long long __attribute__((vector_size(32)));
  const Words w = (Words)m;
  const auto both = __builtin_shufflevector(w, w, 0, 1) | __builtin_shufflevector(w, w, 2, 3);
  return (both[0] | both[1]) != 0;
}
KADR_IN_LANES Wide square_root(const Wide& v) {
  return Wide{__builtin_sqrtf(v[0]), __builtin_sqrtf(v[1]), __builtin_sqrtf(v[2]), __builtin_sqrtf(v[3]),
              __builtin_sqrtf(v[4]), __builtin_sqrtf(v[5]), __builtin_sqrtf(v[6]), __builtin_sqrtf(v[7])};
}

// ---- functions for two vectors of 16 bytes

using Quad = float __attribute__((vector_size(16), may_alias));
using QuadMarks = std::int32_t __attribute__((vector_size(16), may_alias));

struct PairMarks {
  QuadMarks low, high;
};
struct Pair {
  Quad low, high;
};

#define KADR_PAIR_OPERATOR(Result, Operand, op)                                                                       \
  KADR_IN_LANES Result operator op(const Operand& a, const Operand& b) { return {a.low op b.low, a.high op b.high}; } \
  KADR_IN_LANES Result operator op(const Operand& a, float b) { return {a.low op b, a.high op b}; }                   \
  KADR_IN_LANES Result operator op(float a, const Operand& b) { return {a op b.low, a op b.high}; }
KADR_PAIR_OPERATOR(Pair, Pair, +)
KADR_PAIR_OPERATOR(Pair, Pair, -)
KADR_PAIR_OPERATOR(Pair, Pair, *)
KADR_PAIR_OPERATOR(Pair, Pair, /)
KADR_PAIR_OPERATOR(PairMarks, Pair, <)
KADR_PAIR_OPERATOR(PairMarks, Pair, <=)
KADR_PAIR_OPERATOR(PairMarks, Pair, >)
KADR_PAIR_OPERATOR(PairMarks, Pair, >=)
#undef KADR_PAIR_OPERATOR
KADR_IN_LANES Pair operator-(const Pair& a) { return {-a.low, -a.high}; }
KADR_IN_LANES PairMarks operator&(const PairMarks& a, const PairMarks& b) { return {a.low & b.low, a.high & b.high}; }
KADR_IN_LANES PairMarks operator|(const PairMarks& a, const PairMarks& b) { return {a.low | b.low, a.high | b.high}; }
KADR_IN_LANES PairMarks operator~(const PairMarks& a) { return {~a.low, ~a.high}; }

KADR_IN_LANES Pair choose(const PairMarks& m, const Pair& a, const Pair& b) { return {m.low ? a.low : b.low, m.high ? a.high : b.high}; }
KADR_IN_LANES PairMarks choose(const PairMarks& m, const PairMarks& a, const PairMarks& b) {
  return {m.low ? a.low : b.low, m.high ? a.high : b.high};
}
KADR_IN_LANES Pair least(const Pair& a, const Pair& b) { return {a.low < b.low ? a.low : b.low, a.high < b.high ? a.high : b.high}; }
KADR_IN_LANES Pair most(const Pair& a, const Pair& b) { return {a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high}; }
KADR_IN_LANES bool any(const PairMarks& m) {
  using Words = long long __attribute__((vector_size(16)));
  const Words w = (Words)(m.low | m.high);
  return (w[0] | w[1]) != 0;
}
KADR_IN_LANES Quad square_root(const Quad& v) {
  return Quad{__builtin_sqrtf(v[0]), __builtin_sqrtf(v[1]), __builtin_sqrtf(v[2]), __builtin_sqrtf(v[3])};
}
KADR_IN_LANES Pair square_root(const Pair& v) { return {square_root(v.low), square_root(v.high)}; }

// ---- functions for both types, Wide and Pair

template <class V>
using MarksOf = decltype(V{} < V{});

KADR_IN_LANES void load(const float* from, Wide& v) { v = *reinterpret_cast<const Wide*>(from); }
KADR_IN_LANES void load(const std::int32_t* from, WideMarks& v) { v = *reinterpret_cast<const WideMarks*>(from); }
KADR_IN_LANES void load(const float* from, Pair& v) {
  v = {*reinterpret_cast<const Quad*>(from), *reinterpret_cast<const Quad*>(from + 4)};
}
KADR_IN_LANES void load(const std::int32_t* from, PairMarks& v) {
  v = {*reinterpret_cast<const QuadMarks*>(from), *reinterpret_cast<const QuadMarks*>(from + 4)};
}
KADR_IN_LANES void store(float* to, const Wide& v) { *reinterpret_cast<Wide*>(to) = v; }
KADR_IN_LANES void store(std::int32_t* to, const WideMarks& v) { *reinterpret_cast<WideMarks*>(to) = v; }
KADR_IN_LANES void store(float* to, const Pair& v) { *reinterpret_cast<Quad*>(to) = v.low, *reinterpret_cast<Quad*>(to + 4) = v.high; }
KADR_IN_LANES void store(std::int32_t* to, const PairMarks& v) {
  *reinterpret_cast<QuadMarks*>(to) = v.low, *reinterpret_cast<QuadMarks*>(to + 4) = v.high;
}
/// Loads eight numbers from an address that is divisible by 32.
template <class T>
KADR_IN_LANES T lanes_at(const auto* from) {
  T v;
  load(from, v);
  return v;
}
KADR_IN_LANES Wide spread_of(float v, const Wide&) { return Wide{v, v, v, v, v, v, v, v}; }
KADR_IN_LANES Pair spread_of(float v, const Pair&) { return {Quad{v, v, v, v}, Quad{v, v, v, v}}; }
KADR_IN_LANES WideMarks spread_of(std::int32_t v, const WideMarks&) { return WideMarks{v, v, v, v, v, v, v, v}; }
KADR_IN_LANES PairMarks spread_of(std::int32_t v, const PairMarks&) { return {QuadMarks{v, v, v, v}, QuadMarks{v, v, v, v}}; }
/// Returns lanes that all contain the number `v`.
template <class V>
KADR_IN_LANES V spread(auto v) {
  return spread_of(v, V{});
}

template <class V>
KADR_IN_LANES V within(const V& value, const V& low, const V& high) {
  return least(most(value, low), high);
}
template <class V>
KADR_IN_LANES V root(const V& square) {
  return square_root(most(square, spread<V>(0.f)));
}

}  // namespace kadr::lanes
