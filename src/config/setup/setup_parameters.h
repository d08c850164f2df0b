#pragma once
// Reads the values that the set-up states for parameters, of an axis of the channel or of the channel itself. The rooms machine and motion,
// which process what the control commands, use these values. A value with an index takes precedence over a value without index, and a
// single bit over the whole value (as in ParameterStore). A parameter that the set-up does not state is 0.

#include <string>
#include <vector>

#include "config/setup/setup.h"

namespace kadr {

/// A bit of a parameter, given by its number and its name.
struct ParameterBit {
  int number;
  const char* name;
};

class SetupParameters {
 public:
  /// Stores the set-up, which must exist longer than this object. `axes`: names of the channel's axes. Axis numbers continue from one
  /// channel to the next (nct 1.2).
  SetupParameters(const Setup& setup, const std::vector<std::string>& axes);

  /// Returns the number of the channel's first axis.
  std::size_t first_axis() const { return first_; }
  double of_channel(const char* parameter) const { return value(parameter, channel_); }
  bool of_channel(const char* parameter, ParameterBit bit) const { return value(parameter, channel_, bit); }
  double of_axis(const char* parameter, std::size_t axis) const { return value(parameter, axes_[axis]); }
  bool of_axis(const char* parameter, std::size_t axis, ParameterBit bit) const { return value(parameter, axes_[axis], bit); }

 private:
  using Indices = std::vector<std::string>;  // indices under which the set-up may state a value, the most specific index first
  double value(const char* parameter, const Indices& indices) const;
  bool value(const char* parameter, const Indices& indices, ParameterBit bit) const;

  const Setup& setup_;
  std::size_t first_ = 1;
  Indices channel_;
  std::vector<Indices> axes_;
};

}  // namespace kadr
