#pragma once
// Parameters of the set-up, as the rooms after the control read them: for an axis of the channel, or for the channel itself. A value with
// an index takes precedence over one without, and a bit over the whole value (as in ParameterStore). A parameter that is not given is 0.

#include <string>
#include <vector>

#include "config/setup/setup.h"

namespace kadr {

/// A bit, by its number and its name.
struct ParameterBit {
  int number;
  const char* name;
};

class SetupParameters {
 public:
  /// `axes`: names of the channel's axes. Axis numbers continue through the channels (nct 1.2). The set-up must outlive this object.
  SetupParameters(const Setup& setup, const std::vector<std::string>& axes);

  /// Returns the number of the channel's first axis.
  std::size_t first_axis() const { return first_; }
  double of_channel(const char* parameter) const { return value(parameter, channel_); }
  bool of_channel(const char* parameter, ParameterBit bit) const { return value(parameter, channel_, bit); }
  double of_axis(const char* parameter, std::size_t axis) const { return value(parameter, axes_[axis]); }
  bool of_axis(const char* parameter, std::size_t axis, ParameterBit bit) const { return value(parameter, axes_[axis], bit); }

 private:
  using Indices = std::vector<std::string>;  // the indices under which a value may be given, the most specific one first
  double value(const char* parameter, const Indices& indices) const;
  bool value(const char* parameter, const Indices& indices, ParameterBit bit) const;

  const Setup& setup_;
  std::size_t first_ = 1;
  Indices channel_;
  std::vector<Indices> axes_;
};

}  // namespace kadr
