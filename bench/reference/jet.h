#pragma once
// Jet: a number with its gradient and Hessian with respect to a few variables. It computes the derivatives of a formula automatically.

#include <array>
#include <cstddef>

namespace kadr::reference {

template <std::size_t N>
struct Jet {
  double value = 0;
  std::array<double, N> by{};
  std::array<std::array<double, N>, N> bend{};

  Jet() = default;
  Jet(double constant) : value(constant) {}  // NOLINT: constants stand in formulas
  Jet(double at, std::size_t variable) : value(at) { by[variable] = 1; }

  friend Jet operator+(Jet x, const Jet& y) { return x.add(y, 1); }
  friend Jet operator-(Jet x, const Jet& y) { return x.add(y, -1); }
  friend Jet operator*(const Jet& x, const Jet& y) {
    Jet z(x.value * y.value);
    for (std::size_t i = 0; i < N; ++i) {
      z.by[i] = x.by[i] * y.value + x.value * y.by[i];
      for (std::size_t j = 0; j < N; ++j)
        z.bend[i][j] = x.bend[i][j] * y.value + x.by[i] * y.by[j] + x.by[j] * y.by[i] + x.value * y.bend[i][j];
    }
    return z;
  }
  friend Jet operator/(const Jet& x, const Jet& y) { return x * y.inverse(); }

 private:
  Jet& add(const Jet& y, double times) {
    value += times * y.value;
    for (std::size_t i = 0; i < N; ++i) {
      by[i] += times * y.by[i];
      for (std::size_t j = 0; j < N; ++j) bend[i][j] += times * y.bend[i][j];
    }
    return *this;
  }
  Jet inverse() const {
    Jet z(1 / value);
    for (std::size_t i = 0; i < N; ++i) {
      z.by[i] = -by[i] * z.value * z.value;
      for (std::size_t j = 0; j < N; ++j) z.bend[i][j] = (-bend[i][j] + 2 * by[i] * by[j] * z.value) * z.value * z.value;
    }
    return z;
  }
};

}  // namespace kadr::reference
