#include "base/shared_library.h"

#include <gtest/gtest.h>

namespace kadr::shared_library_test {
namespace {

TEST(SharedLibrary, FindsTheFunctionsOfALibrary) {
  void* const library = open_library("libz.so.1");
  ASSERT_NE(library, nullptr);
  const auto version = reinterpret_cast<const char* (*)()>(function_in(library, "zlibVersion"));
  ASSERT_NE(version, nullptr);
  EXPECT_EQ(version()[0], '1');
  EXPECT_EQ(function_in(library, "no_such_function"), nullptr);
  close_library(library);
}

TEST(SharedLibrary, ThatIsNotThereIsNull) {
  for (const bool whole : {false, true}) EXPECT_EQ(open_library("libno-such-library.so.9", whole), nullptr);
}

}  // namespace
}  // namespace kadr::shared_library_test
