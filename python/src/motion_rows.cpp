// Stores motions as rows of bytes. Used by run.cpp; tested by tests/python_binding.py.

#include "motion_rows.h"

#include <algorithm>

namespace kadr::python {

/// Returns the chunk to which the next row is appended. If a snapshot shares that chunk, it is copied first.
std::string& MotionRows::last_chunk() {
  if (count_ % rows_of_chunk == 0) chunks_.push_back(std::make_shared<std::string>());
  else if (chunks_.back().use_count() > 1) chunks_.back() = std::make_shared<std::string>(*chunks_.back());
  return *chunks_.back();
}

void MotionRows::add(const Step& step, const Motion& motion, std::uint32_t tool, int channel) {
  const Origin& origin = step.action.origin;
  MotionRow row{.begins = step.begins,
                .seconds = step.time.seconds,
                .length = step.time.length,
                .feed = step.time.feed,
                .line = origin.line,
                .block = origin.has_block ? static_cast<std::int32_t>(origin.block) : -1,
                .tool = tool,
                .file = origin.file,
                .kind = static_cast<std::uint8_t>(motion.kind),
                .channel = static_cast<std::uint8_t>(channel)};
  if (is_arc(motion.kind)) row.center_x = motion.center.x, row.center_y = motion.center.y, row.turns = motion.turns;
  std::string& to = last_chunk();
  const auto put = [&to](const void* from, std::size_t size) { to.append(static_cast<const char*>(from), size); };
  put(&row, sizeof row);
  for (const Axes* axes : {&step.from.work, &motion.to, &step.from.machine, &motion.machine}) put(axes->data(), axes_ * sizeof(double));
  ++count_;
}

void MotionRows::append_to(std::string& bytes) const {
  for (const auto& chunk : chunks_) bytes += *chunk;
}

}  // namespace kadr::python
