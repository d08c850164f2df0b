#pragma once
// Vectors of eight doubles whose elements are calculated in parallel, in 128-bit registers, which every processor has, or in wider ones. A
// lane is one element of a vector.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

// Silences the ABI warning about vectors as arguments and results. The warning does not matter, because these functions are inlined and no
// calling convention applies.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace kadr {

inline constexpr std::size_t lanes = 8;

// Marks a function on lanes: it is inlined into its caller, so that both are compiled for the same instruction set.
#define KADR_LANES [[gnu::always_inline]] inline

using Pair = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));

/// Returns a vector whose lanes are those of `then` where the lane of `sign` is above 0, and those of `otherwise` elsewhere.
template <class V>
KADR_LANES V where_positive(const V& sign, const V& then, const V& otherwise) {
  return sign > 0 ? then : otherwise;
}
KADR_LANES Pair root_of(const Pair& x) { return Pair{std::sqrt(x[0]), std::sqrt(x[1])}; }
KADR_LANES Four root_of(const Four& x) { return Four{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])}; }
KADR_LANES Pair lesser(const Pair& x, const Pair& y) { return x < y ? x : y; }
KADR_LANES Four lesser(const Four& x, const Four& y) { return x < y ? x : y; }
KADR_LANES Pair greater(const Pair& x, const Pair& y) { return x > y ? x : y; }
KADR_LANES Four greater(const Four& x, const Four& y) { return x > y ? x : y; }
KADR_LANES Pair all_of(double x, const Pair&) { return Pair{x, x}; }
KADR_LANES Four all_of(double x, const Four&) { return Four{x, x, x, x}; }
/// read_lanes() reads floats and converts them to doubles; write_lanes() converts doubles to floats and writes them. The address may have
/// any alignment.
KADR_LANES void read_lanes(const float* from, Pair& x) { x = Pair{from[0], from[1]}; }
KADR_LANES void read_lanes(const float* from, Four& x) {
  float __attribute__((vector_size(16))) narrow;
  std::memcpy(&narrow, from, sizeof narrow);
  x = __builtin_convertvector(narrow, Four);
}
KADR_LANES void write_lanes(const Pair& x, float* to) { to[0] = static_cast<float>(x[0]), to[1] = static_cast<float>(x[1]); }
KADR_LANES void write_lanes(const Four& x, float* to) {
  const float __attribute__((vector_size(16))) narrow = __builtin_convertvector(x, float __attribute__((vector_size(16))));
  std::memcpy(to, &narrow, sizeof narrow);
}
KADR_LANES double sum_of(const Pair& x) { return x[0] + x[1]; }
KADR_LANES double sum_of(const Four& x) { return (x[0] + x[2]) + (x[1] + x[3]); }
KADR_LANES double product_of(const Pair& x) { return x[0] * x[1]; }
KADR_LANES double product_of(const Four& x) { return (x[0] * x[2]) * (x[1] * x[3]); }
KADR_LANES double least_of(const Pair& x) { return std::min(x[0], x[1]); }
KADR_LANES double least_of(const Four& x) { return std::min(std::min(x[0], x[2]), std::min(x[1], x[3])); }

/// A vector of twice the length, stored as two halves. A single vector wider than the registers would be split and reassembled in memory.
template <class Half>
struct Doubled {
  Half low = {}, high = {};

  Doubled() = default;
  KADR_LANES Doubled(const Half& l, const Half& h) : low(l), high(h) {}
  /// Reads the eight numbers from an address of any alignment.
  KADR_LANES explicit Doubled(const double* from) {
    std::memcpy(static_cast<void*>(&low), from, sizeof low);
    std::memcpy(static_cast<void*>(&high), from + sizeof low / sizeof *from, sizeof high);
  }

  KADR_LANES explicit Doubled(const float* from) { read_lanes(from, *this); }
  KADR_LANES static Doubled all(double x) { return all_of(x, Doubled()); }
  KADR_LANES friend Doubled all_of(double x, const Doubled&) { return {all_of(x, Half()), all_of(x, Half())}; }
  KADR_LANES friend void read_lanes(const float* from, Doubled& x) {
    read_lanes(from, x.low);
    read_lanes(from + sizeof(Half) / sizeof(double), x.high);
  }
  KADR_LANES friend void write_lanes(const Doubled& x, float* to) {
    write_lanes(x.low, to);
    write_lanes(x.high, to + sizeof(Half) / sizeof(double));
  }
  KADR_LANES void to(float* where) const { write_lanes(*this, where); }
  KADR_LANES void to(double* where) const {
    std::memcpy(where, &low, sizeof low);
    std::memcpy(where + sizeof low / sizeof *where, &high, sizeof high);
  }

  KADR_LANES friend Doubled operator+(const Doubled& x, const Doubled& y) { return {x.low + y.low, x.high + y.high}; }
  KADR_LANES friend Doubled operator-(const Doubled& x, const Doubled& y) { return {x.low - y.low, x.high - y.high}; }
  KADR_LANES friend Doubled operator*(const Doubled& x, const Doubled& y) { return {x.low * y.low, x.high * y.high}; }
  KADR_LANES friend Doubled operator/(const Doubled& x, const Doubled& y) { return {x.low / y.low, x.high / y.high}; }
  KADR_LANES friend Doubled operator+(double x, const Doubled& y) { return {x + y.low, x + y.high}; }
  KADR_LANES friend Doubled operator-(double x, const Doubled& y) { return {x - y.low, x - y.high}; }
  KADR_LANES friend Doubled operator*(double x, const Doubled& y) { return {x * y.low, x * y.high}; }
  KADR_LANES friend Doubled operator/(double x, const Doubled& y) { return {x / y.low, x / y.high}; }
  KADR_LANES friend Doubled operator*(const Doubled& x, double y) { return y * x; }
  KADR_LANES friend Doubled operator-(const Doubled& x, double y) { return {x.low - y, x.high - y}; }
  KADR_LANES friend Doubled operator-(const Doubled& x) { return {-x.low, -x.high}; }
  KADR_LANES Doubled& operator+=(const Doubled& y) { return *this = *this + y; }
  KADR_LANES Doubled& operator*=(const Doubled& y) { return *this = *this * y; }
  KADR_LANES friend Doubled lesser(const Doubled& x, const Doubled& y) { return {lesser(x.low, y.low), lesser(x.high, y.high)}; }
  KADR_LANES friend Doubled greater(const Doubled& x, const Doubled& y) { return {greater(x.low, y.low), greater(x.high, y.high)}; }
  KADR_LANES friend Doubled where_positive(const Doubled& sign, const Doubled& then, const Doubled& otherwise) {
    return {where_positive(sign.low, then.low, otherwise.low), where_positive(sign.high, then.high, otherwise.high)};
  }
  KADR_LANES friend Doubled root_of(const Doubled& x) { return {root_of(x.low), root_of(x.high)}; }
  // The order of summation is the same for vectors of Pair and of Four, so sums agree to the last bit: ((0+4)+(2+6)) + ((1+5)+(3+7)).
  KADR_LANES friend double sum_of(const Doubled& x) { return sum_of(x.low + x.high); }
  KADR_LANES friend double product_of(const Doubled& x) { return product_of(x.low * x.high); }
  KADR_LANES friend double least_of(const Doubled& x) { return least_of(where_positive(x.high - x.low, x.low, x.high)); }
  KADR_LANES friend double greatest_of(const Doubled& x) { return -least_of(-x); }
};

using NarrowLanes = Doubled<Doubled<Pair>>;
using WideLanes = Doubled<Four>;

// Functions that are not inlined must not have parameters of type WideLanes, because the memory layout of this type depends on the
// processor that the code is compiled for.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
template <class Work>
[[gnu::target("avx2")]] auto with_wide_lanes(const Work& work) {
  return work(WideLanes());
}

/// Calls `work`, an [[gnu::always_inline]] function, with an object of the widest lane type that the processor supports. The results for
/// all lane types are the same to the last bit, which requires -ffp-contract=off.
template <class Work>
auto with_best_lanes(const Work& work) {
  static const bool are_wide = __builtin_cpu_supports("avx2") != 0;
  return are_wide ? with_wide_lanes(work) : work(NarrowLanes());
}
#else
template <class Work>
auto with_best_lanes(const Work& work) {
  return work(NarrowLanes());
}
#endif

}  // namespace kadr
