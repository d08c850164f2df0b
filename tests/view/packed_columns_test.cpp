// Columns of a report are unpacked exactly as they were packed, whatever numbers they contain.

#include "view/report/packed_columns.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "stock/mesh/zlib_library.h"

namespace kadr::packed_columns_test {
namespace {

/// Unpacks a column as web/src/report/data.ts does.
std::vector<std::int32_t> unpacked(const std::string& bytes, std::size_t at, std::size_t count) {
  std::vector<std::int32_t> column;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t folded = 0;
    for (std::size_t b = 0; b < 4; ++b) folded |= std::uint32_t(std::uint8_t(bytes[at + b * count + i])) << (8 * b);
    value += (folded >> 1) ^ (0 - (folded & 1));
    column.push_back(std::int32_t(value));
  }
  return column;
}

RC_GTEST_PROP(PackedColumnsProperty, AColumnComesOutAgain,
              (const std::vector<std::int32_t>& first, const std::vector<std::int32_t>& second)) {
  PackedColumns to;
  to.put_u32(7);
  to.put(first);
  to.put(second);
  RC_ASSERT(to.bytes().size() == 4 + 4 * (first.size() + second.size()));
  RC_ASSERT(unpacked(to.bytes(), 4, first.size()) == first);
  RC_ASSERT(unpacked(to.bytes(), 4 + 4 * first.size(), second.size()) == second);
}

TEST(PackedColumns, TheFarthestNumbers) {
  const std::vector<std::int32_t> column = {0, INT32_MAX, INT32_MIN, -1, INT32_MAX, 0};
  PackedColumns to;
  to.put(column);
  EXPECT_EQ(unpacked(to.bytes(), 0, column.size()), column);
}

TEST(PackedColumns, StepsOfAUnit) {
  EXPECT_EQ(in_steps(-1.2345, 0.001), -1235);  // rounded away from zero
  EXPECT_EQ(in_steps(std::nan(""), 0.001), 0);
  EXPECT_EQ(in_steps(std::numeric_limits<double>::infinity(), 0.001), 0);
  EXPECT_EQ(in_steps(1e300, 0.001), 2'000'000'000);
  EXPECT_EQ(unit_for(0.001, 1000), 0.001);
  EXPECT_EQ(in_steps(4e9, unit_for(0.001, 4e9)), 2'000'000'000);
  EXPECT_EQ(unit_for(0.001, std::numeric_limits<double>::infinity()), 0.001);
}

TEST(PackedColumns, ZlibTakesItApart) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += char(i * i % 251);
  const auto packed = zlib_packed(text);
  ASSERT_TRUE(packed) << packed.error();
  EXPECT_LT(packed->size(), text.size());
  std::string again(text.size(), '\0');
  const Zlib* const zlib = zlib_library();
  z_stream stream{};
  ASSERT_EQ(zlib->inflateInit2_(&stream, 15, ZLIB_VERSION, int(sizeof stream)), Z_OK);
  std::string bytes = *packed;
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data()), stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(again.data()), stream.avail_out = uInt(again.size());
  EXPECT_EQ(zlib->inflate(&stream, Z_FINISH), Z_STREAM_END);
  zlib->inflateEnd(&stream);
  EXPECT_EQ(again, text);
  EXPECT_TRUE(zlib_packed(""));
}

}  // namespace
}  // namespace kadr::packed_columns_test
