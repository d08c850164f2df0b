// server/guard: serves a request only if its host is one of the server's names and its origin one of the server's own pages.

#include "server/guard.h"

#include <gtest/gtest.h>

namespace kadr::guard_test {
namespace {

TEST(Guard, OnlyItsOwnNames) {
  const ServedAddress here{"127.0.0.1", 8437};
  EXPECT_TRUE(is_own_host(here, "127.0.0.1:8437"));
  EXPECT_TRUE(is_own_host(here, "localhost:8437"));
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:84370", "evil.example:8437", "127.0.0.1.evil.example:8437", "127.0.0.1:8437:8437"})
    EXPECT_FALSE(is_own_host(here, host)) << host;
  const ServedAddress all{"0.0.0.0", 80};
  EXPECT_TRUE(is_own_host(all, "192.168.0.7:80"));
  EXPECT_FALSE(is_own_host(all, "kadr.example:80"));
  EXPECT_TRUE(all.is_open());
  EXPECT_FALSE(here.is_open());
}

TEST(Guard, OnlyItsOwnPages) {
  EXPECT_TRUE(is_own_origin("", "127.0.0.1:1"));
  EXPECT_TRUE(is_own_origin("http://127.0.0.1:1", "127.0.0.1:1"));
  EXPECT_FALSE(is_own_origin("http://evil.example", "127.0.0.1:1"));
  EXPECT_FALSE(is_own_origin("null", "127.0.0.1:1"));
}

TEST(Guard, TokensAreNew) {
  EXPECT_EQ(new_token().size(), 32U);
  EXPECT_NE(new_token(), new_token());
}

}  // namespace
}  // namespace kadr::guard_test
