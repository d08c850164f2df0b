#pragma once
// Result: a value, or the alarm that explains why there is no value.

#include <tl/expected.hpp>

#include "base/alarm.h"

namespace kadr {

template <class T>
using Result = tl::expected<T, Alarm>;
using Status = Result<void>;

inline tl::unexpected<Alarm> fail(const Alarm& alarm) { return tl::unexpected<Alarm>(alarm); }

}  // namespace kadr

/// Returns from the enclosing function with the alarm of `expression`, if `expression` has an alarm.
#define KADR_TRY(expression)                                 \
  do {                                                       \
    if (auto status_ = (expression); !status_) [[unlikely]]  \
      return tl::unexpected<::kadr::Alarm>(status_.error()); \
  } while (false)
