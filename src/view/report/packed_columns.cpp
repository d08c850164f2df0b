// Packs the numbers of a report (PackedColumns). Used by view/report/page_report; tested by tests/view/packed_columns_test.cpp;
// web/src/report/data.ts reads the format.

#include "view/report/packed_columns.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "stock/mesh/zlib_library.h"
#include "texts/view.h"

namespace kadr {
namespace {

constexpr int packing_level = 9;  // best compression of zlib, because a report is written once and sent often
constexpr double max_steps = 2e9;

}  // namespace

void PackedColumns::put_u32(std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes_.push_back(char(value >> (8 * i) & 0xff));
}

void PackedColumns::put_f64(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  put_u32(std::uint32_t(bits));
  put_u32(std::uint32_t(bits >> 32));
}

void PackedColumns::put(std::span<const std::int32_t> column) {
  const std::size_t at = bytes_.size(), count = column.size();
  bytes_.resize(at + 4 * count);
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t value = std::uint32_t(column[i]), step = value - last;
    const std::uint32_t folded = (step << 1) ^ (0 - (step >> 31));
    for (std::size_t b = 0; b < 4; ++b) bytes_[at + b * count + i] = char(folded >> (8 * b) & 0xff);
    last = value;
  }
}

std::int32_t in_steps(double value, double unit) {
  if (!std::isfinite(value)) return 0;
  return std::int32_t(std::llround(std::clamp(value / unit, -max_steps, max_steps)));
}

double unit_for(double unit, double most) { return std::isfinite(most) ? std::max(unit, most / max_steps) : unit; }

tl::expected<std::string, std::string> zlib_packed(std::string_view bytes) {
  const Zlib* const zlib = zlib_library();
  z_stream stream{};
  if (zlib == nullptr ||
      zlib->deflateInit2_(&stream, packing_level, Z_DEFLATED, 15, 9, Z_DEFAULT_STRATEGY, ZLIB_VERSION, int(sizeof stream)) != Z_OK)
    return tl::unexpected(translated(texts::view::zlib_missing));
  std::string packed;
  bool good = true;
  while (good) {
    const std::size_t most = 1U << 30;  // greatest size in bytes that fits the counters of zlib
    const std::string_view now = bytes.substr(0, most);
    bytes.remove_prefix(now.size());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(now.data()));
    stream.avail_in = uInt(now.size());
    do {
      char piece[1 << 16];
      stream.next_out = reinterpret_cast<Bytef*>(piece);
      stream.avail_out = sizeof piece;
      good = zlib->deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH) != Z_STREAM_ERROR;
      packed.append(piece, sizeof piece - stream.avail_out);
    } while (good && stream.avail_out == 0);
    if (bytes.empty()) break;
  }
  zlib->deflateEnd(&stream);
  if (!good) return tl::unexpected(translated(texts::view::zlib_fails));
  return packed;
}

}  // namespace kadr
