#include "config/packed_toml.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <stdexcept>

#include "config/embedded.h"

namespace kadr::packed_toml_test {
namespace {

TEST(PackedToml, BuiltInTablesAreThoseOfTheTexts) {
  int files = 0;
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.name.ends_with(".toml")) continue;
    ++files;
    EXPECT_TRUE(toml::parse(file.text) == unpacked(file.table)) << file.name;
  }
  EXPECT_GT(files, 8);
}

TEST(PackedToml, EveryKindComesBack) {
  const toml::table table = toml::parse(R"(
    empty = ""
    text = "кадр"
    least = -9223372036854775808
    most = 9223372036854775807
    numbers = [0, 127, 128, -1, 0.1, -0.0, 1e300, inf]
    truth = [true, false]
    none = []
    nothing = {}
    deep = { a = [{ b = { c = [[1], []] } }] }
  )");
  EXPECT_TRUE(unpacked(packed(table)) == table);
}

TEST(PackedToml, SomeSectionsAreReadWithoutTheRest) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.name.ends_with(".toml")) continue;
    toml::table whole = toml::parse(file.text);
    if (whole.empty()) continue;
    const std::string first(whole.cbegin()->first.str()), last(std::prev(whole.cend())->first.str());
    const toml::table some = unpacked(file.table, {first, last, "no such section"});
    whole.erase(std::next(whole.cbegin()), first == last ? std::next(whole.cbegin()) : std::prev(whole.cend()));
    EXPECT_TRUE(some == whole) << file.name;
  }
}

TEST(PackedToml, OneListIsReadWithoutTheRest) {
  const std::string bytes = packed(toml::parse(R"(
    before = { a = [1, "x", { b = 0.5 }], c = true, d = -7 }
    list = ["one", "два"]
    text = "list"
  )"));
  EXPECT_EQ(texts_of_list(bytes, "list"), (std::vector<std::string>{"one", "два"}));
  EXPECT_TRUE(texts_of_list(bytes, "text").empty());
  EXPECT_TRUE(texts_of_list(bytes, "nothing").empty());
}

TEST(PackedToml, EachTextOfTheTablesIsHandedOver) {
  std::string all;
  each_text(packed(toml::parse(R"(
    [first]
    args = 2
    en = "a"
    [second]
    list = ["no"]
    ru = "б"
  )")),
            [&](std::string_view table, std::string_view key, std::string_view text) {
              all.append(table).append(".").append(key).append("=").append(text).append(" ");
            });
  EXPECT_EQ(all, "first.en=a second.ru=б ");
}

TEST(PackedToml, ADateIsRefused) { EXPECT_THROW((void)packed(toml::parse("day = 2026-11-22")), std::invalid_argument); }

RC_GTEST_PROP(PackedToml, RandomTablesComeBack, (const std::map<std::string, std::vector<std::int64_t>>& rows, double real)) {
  toml::table table;
  for (const auto& [key, numbers] : rows) {
    toml::array list;
    for (const std::int64_t n : numbers) list.push_back(n);
    table.insert_or_assign(key, toml::table{{"list", std::move(list)}, {key, key}, {"real", real}});
  }
  RC_ASSERT(unpacked(packed(table)) == table);
}

}  // namespace
}  // namespace kadr::packed_toml_test
