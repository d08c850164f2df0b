// Writes and reads portion files. Used by cli/cut_portion.

#include "stock/portion/portion_file.h"

#include <algorithm>
#include <type_traits>

namespace kadr {
namespace {

// Marks that begin the parts of a file. On a processor with another order of bytes they are other numbers.
constexpr std::uint32_t portion_mark = 0x4b504f52, batch_mark = 0x43555431, batches_end_mark = 0x454e4431, of_brick_mark = 0x42524b31,
                        portion_end_mark = 0x4c415354;
constexpr std::uint64_t most_values = std::uint64_t{1} << 32;  // a longer list is a sign of a damaged file
constexpr std::size_t values_at_once = 1 << 14;                // a damaged length must not reserve memory that the file cannot fill

/// The fixed part of PortionEnd.
struct StoredEnd {
  std::uint64_t fingerprint, triangles, first_brick;
  std::array<float, 3> first_point;
  std::uint32_t is_compared;
};

}  // namespace

template <class T>
void PortionWriter::put(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  complete_ = complete_ && sink_({reinterpret_cast<const char*>(&value), sizeof value});
}

template <class T>
void PortionWriter::put_all(const std::vector<T>& values) {
  put(std::uint64_t(values.size()));
  if (!values.empty()) complete_ = complete_ && sink_({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

void PortionWriter::begin(const PortionHead& head, const std::string& build) {
  put(portion_mark);
  put_all(std::vector<char>(build.begin(), build.end()));
  put(head);
}

void PortionWriter::add(const PortionCut& cut) {
  put(batch_mark);
  put_all(cut.removed);
  put_all(cut.touches);
}

void PortionWriter::finish(const Surface& surface, std::uint64_t fingerprint, const PartComparison* comparison) {
  StoredEnd end{fingerprint, surface.triangle_count(), ~std::uint64_t{0}, {}, comparison != nullptr};
  if (surface.own_points() > 0) {
    const auto after = std::find_if(surface.bricks.begin(), surface.bricks.end(), [](const SurfaceBrick& b) { return b.first_point > 0; });
    end.first_brick = (after - 1)->number;
    std::copy_n(surface.points.begin(), 3, end.first_point.begin());
  }
  put(batches_end_mark);
  put(end);
  if (comparison != nullptr) {
    put(comparison->left_on), put(comparison->gouged);
    put_all(comparison->bricks);
  }
  for (const SurfaceBrick& brick : surface.bricks) put_brick(surface, brick);
  put(portion_end_mark);
}

void PortionWriter::put_brick(const Surface& surface, const SurfaceBrick& brick) {
  std::vector<PortionTriangle> triangles(brick.triangles);
  for (std::size_t t = 0; t < brick.triangles; ++t) {
    triangles[t].is_cut = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t point = surface.triangles[3 * (brick.first_triangle + t) + c];
      std::copy_n(surface.points.begin() + std::ptrdiff_t(3 * point), 3, triangles[t].corners[c].begin());
      if (surface.made_by[point] != of_blank) triangles[t].is_cut = 1;
    }
  }
  put(of_brick_mark);
  put(brick.number);
  put_all(triangles);
}

template <class T>
bool PortionReader::get(T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  return sound_ = sound_ && source_({reinterpret_cast<char*>(&value), sizeof value});
}

template <class T>
bool PortionReader::get_all(std::vector<T>& values) {
  std::uint64_t left = 0;
  values.clear();
  sound_ = get(left) && left < most_values;
  while (sound_ && left > 0) {
    const std::size_t now = std::size_t(std::min<std::uint64_t>(left, values_at_once)), before = values.size();
    values.resize(before + now);
    sound_ = source_({reinterpret_cast<char*>(values.data() + before), now * sizeof(T)});
    left -= now;
  }
  return sound_;
}

std::optional<PortionHead> PortionReader::begin(const std::string& build) {
  std::vector<char> of;
  PortionHead head;
  if (!get(mark_) || mark_ != portion_mark || !get_all(of) || std::string(of.begin(), of.end()) != build || !get(head) || !get(mark_)) {
    sound_ = false;
    return std::nullopt;
  }
  return head;
}

PortionCut PortionReader::next_cut() {
  PortionCut cut;
  if (!sound_ || mark_ != batch_mark) return cut;
  if (!get_all(cut.removed) || !get_all(cut.touches) || !get(mark_)) return {};
  return cut;
}

std::optional<PortionEnd> PortionReader::end() {
  StoredEnd stored{};
  if (!sound_ || mark_ != batches_end_mark || !get(stored)) return std::nullopt;
  PortionEnd end{stored.fingerprint, stored.triangles, stored.first_brick, stored.first_point, {}};
  if (stored.is_compared != 0) {
    PartComparison& held = end.comparison.emplace();
    if (!get(held.left_on) || !get(held.gouged) || !get_all(held.bricks)) return std::nullopt;
  }
  return get(mark_) ? std::optional(std::move(end)) : std::nullopt;
}

bool PortionReader::next(PortionBrick& brick) {
  if (!sound_ || mark_ == portion_end_mark) return false;
  return sound_ = mark_ == of_brick_mark && get(brick.number) && get_all(brick.triangles) && get(mark_);
}

}  // namespace kadr
