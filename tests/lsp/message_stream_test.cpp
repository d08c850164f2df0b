// Messages of the base protocol over a pipe: pieces of any size, and input that is no message.

#include "lsp/message_stream.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <thread>

namespace kadr::message_stream_test {

/// Writes bytes into a pipe in pieces, and closes it.
class Pipe {
 public:
  Pipe(std::string bytes, std::size_t piece) {
    EXPECT_EQ(::pipe(ends_.data()), 0);
    writing_ = std::thread([this, piece, sent = std::move(bytes)] {
      for (std::size_t at = 0; at < sent.size(); at += piece) {
        const std::string part = sent.substr(at, piece);
        if (::write(ends_[1], part.data(), part.size()) < 0) break;
      }
      ::close(ends_[1]);
    });
  }
  ~Pipe() {
    writing_.join();
    ::close(ends_[0]);
  }
  int input() const { return ends_[0]; }

 private:
  std::array<int, 2> ends_{};
  std::thread writing_;
};

std::string message(const std::string& content) { return fmt::format("Content-Length: {}\r\n\r\n{}", content.size(), content); }

TEST(MessageReader, ReadsMessagesInPiecesOfAnySize) {
  const std::string text =
      message("{}") + "content-length:3\r\nContent-Type: x\r\n\r\n[1]" + message(std::string(100'000, 'a')) + message("");
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, std::size_t{4096}, text.size()}) {
    const Pipe pipe(text, piece);
    MessageReader reader(pipe.input());
    for (const std::string& wanted : {std::string("{}"), std::string("[1]"), std::string(100'000, 'a'), std::string()}) {
      const auto got = reader.next();
      ASSERT_TRUE(got && *got) << piece;
      EXPECT_EQ(**got, wanted);
    }
    const auto end = reader.next();
    ASSERT_TRUE(end);
    EXPECT_FALSE(*end);
  }
}

TEST(MessageReader, RefusesWhatIsNoMessage) {
  for (const std::string& text :
       {std::string("Content-Length: 5\r\n\r\n{}"), std::string("Content-Length: -1\r\n\r\n"), std::string("Content-Length: x\r\n\r\n{}"),
        std::string("Content-Length: 99999999999999999999\r\n\r\n"), std::string("Content-Length: 999999999\r\n\r\n"),
        std::string("G0 X1\r\n\r\n"), std::string("G0 X1"), std::string(100'000, 'x')}) {
    const Pipe pipe(text, 512);
    EXPECT_FALSE(MessageReader(pipe.input()).next()) << text.substr(0, 50);
    std::array<char, 4096> rest{};
    while (::read(pipe.input(), rest.data(), rest.size()) > 0) {
    }
  }
}

TEST(MessageWriter, WritesWhatTheReaderReads) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  MessageWriter writer(ends[1]);
  EXPECT_TRUE(writer.put("{\"Ж\":1}"));
  const auto got = MessageReader(ends[0]).next();
  ASSERT_TRUE(got && *got);
  EXPECT_EQ(**got, "{\"Ж\":1}");
  ::close(ends[0]), ::close(ends[1]);
}

}  // namespace kadr::message_stream_test
