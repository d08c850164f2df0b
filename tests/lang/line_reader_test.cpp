// lang/text/line_reader: reads lines of a file of any length through a window of 256 KiB.

#include "lang/text/line_reader.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "lang/block/grammar.h"

namespace kadr::line_reader_test {
namespace {

struct Read {
  std::string bytes;
  std::uint64_t offset;
  std::uint32_t number;
  bool ended;
  bool too_long;
  friend bool operator==(const Read&, const Read&) = default;
};

constexpr std::size_t window = 256 * 1024;

std::vector<Read> all_lines(LineReader& reader) {
  std::vector<Read> lines;
  for (Line line; reader.next(line);) lines.push_back({std::string(line.bytes), line.offset, line.number, line.ended, line.too_long});
  return lines;
}

std::vector<Read> lines_of(const std::string& text) {
  LineReader reader(text_source(text));
  return all_lines(reader);
}

std::vector<std::string> texts_of(const std::string& text) {
  std::vector<std::string> texts;
  for (const Read& line : lines_of(text)) texts.push_back(line.bytes);
  return texts;
}

/// The slow reference: splits the whole text at once at each end of line.
std::vector<Read> naive_split(const std::string& text) {
  std::vector<Read> lines;
  const bool has_lf = text.substr(0, window).find('\n') != std::string::npos;
  const char end_of_line = !has_lf && text.substr(0, window).find('\r') != std::string::npos ? '\r' : '\n';
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find(end_of_line, begin);
    std::string bytes = text.substr(begin, end == std::string::npos ? end : end - begin);
    while (!bytes.empty() && bytes.back() == '\r') bytes.pop_back();
    const bool too_long = bytes.size() > limits::line_bytes;
    lines.push_back(
        {bytes.substr(0, limits::line_bytes), begin, static_cast<std::uint32_t>(lines.size() + 1), end != std::string::npos, too_long});
    begin = end == std::string::npos ? text.size() : end + 1;
  }
  return lines;
}

using Texts = std::vector<std::string>;

TEST(line_reader, line_feed) { EXPECT_EQ(texts_of("a\nb\n"), (Texts{"a", "b"})); }
TEST(line_reader, carriage_return_and_line_feed) { EXPECT_EQ(texts_of("a\r\nb\r\r\n"), (Texts{"a", "b"})); }
TEST(line_reader, carriage_return_alone) { EXPECT_EQ(texts_of("a\rb\r"), (Texts{"a", "b"})); }
TEST(line_reader, carriage_return_within_a_line_stays) { EXPECT_EQ(texts_of("a\rb\n"), (Texts{"a\rb"})); }
TEST(line_reader, empty_lines_are_lines) { EXPECT_EQ(texts_of("\n\na"), (Texts{"", "", "a"})); }
TEST(line_reader, nothing_is_no_line) { EXPECT_EQ(texts_of(""), Texts{}); }

TEST(line_reader, line_without_its_end) {
  EXPECT_EQ(lines_of("a\nb"), (std::vector<Read>{{"a", 0, 1, true, false}, {"b", 2, 2, false, false}}));
}

TEST(line_reader, byte_order_mark_is_passed_over) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBFN1\n"), (std::vector<Read>{{"N1", 3, 1, true, false}}));
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"), std::vector<Read>{});
}

TEST(line_reader, longest_line) {
  const std::string longest(limits::line_bytes, 'x');
  EXPECT_EQ(lines_of(longest + "\r\nb\n"), (std::vector<Read>{{longest, 0, 1, true, false}, {"b", longest.size() + 2, 2, true, false}}));
}

TEST(line_reader, longer_line_is_returned_once_and_passed_over) {
  for (const std::size_t more : {1ul, 65535ul, 65536ul, 65537ul, 200000ul, 1000000ul}) {
    const std::string line(limits::line_bytes + more, 'x');
    const std::string beginning(limits::line_bytes, 'x');
    EXPECT_EQ(lines_of("a\n" + line + "\nb\n"),
              (std::vector<Read>{{"a", 0, 1, true, false}, {beginning, 2, 2, true, true}, {"b", line.size() + 3, 3, true, false}}));
    EXPECT_EQ(lines_of("a\n" + line), (std::vector<Read>{{"a", 0, 1, true, false}, {beginning, 2, 2, false, true}}));
  }
}

TEST(line_reader, seek_goes_back_and_forth) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "N" + std::to_string(i) + " G1 X100\n";
  LineReader reader(text_source(text));
  const std::vector<Read> lines = all_lines(reader);
  ASSERT_EQ(lines.size(), 100000u);
  for (const std::size_t i : {99999u, 0u, 50000u, 50001u, 49000u, 99998u, 1u}) {
    reader.seek(lines[i].offset, lines[i].number);
    EXPECT_EQ(reader.offset(), lines[i].offset);
    Line line;
    ASSERT_TRUE(reader.next(line));
    EXPECT_EQ(line.bytes, lines[i].bytes);
    EXPECT_EQ(line.number, lines[i].number);
  }
}

TEST(line_reader, seek_to_the_beginning_passes_over_the_byte_order_mark_again) {
  LineReader reader(text_source("\xEF\xBB\xBFN1\n"));
  all_lines(reader);
  reader.seek(0, 1);
  EXPECT_EQ(all_lines(reader), (std::vector<Read>{{"N1", 3, 1, true, false}}));
}

/// Counts the reads from the file.
class CountingSource final : public ByteSource {
 public:
  CountingSource(std::string text, int& reads) : text_(std::move(text)), reads_(reads) {}
  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override {
    ++reads_;
    return offset < text_.size() ? text_.copy(to, size, offset) : 0;
  }
  std::uint64_t size() const override { return text_.size(); }

 private:
  std::string text_;
  int& reads_;
};

TEST(line_reader, one_read_a_window) {
  int reads = 0;
  LineReader reader(std::make_unique<CountingSource>(std::string(window * 8, '\n'), reads));
  EXPECT_EQ(all_lines(reader).size(), window * 8);
  EXPECT_LE(reads, 9);
}

TEST(line_reader, loop_across_the_border_of_windows_is_read_few_times) {
  std::string text;
  while (text.size() < 2 * window) text += "N10 G1 X100 Y100\n";  // 17 bytes
  int reads = 0;
  LineReader reader(std::make_unique<CountingSource>(text, reads));
  const std::uint64_t begin = (window / 17 - 500) * 17;  // from 500 lines before the border to 500 lines after it
  for (int i = 0; i < 100; ++i) {
    reader.seek(begin, 1);
    Line line;
    for (int n = 0; n < 1000; ++n) ASSERT_TRUE(reader.next(line));
  }
  EXPECT_LE(reads, 8);
}

TEST(line_reader, sample_is_the_beginning_wherever_one_reads) {
  const std::string text(window * 3, '\n');
  LineReader reader(text_source("N1" + text));
  all_lines(reader);
  EXPECT_EQ(reader.sample(), ("N1" + text).substr(0, window));
}

RC_GTEST_PROP(line_reader_against_the_naive_split, short_texts, ()) {
  const auto text = *rc::gen::container<std::string>(rc::gen::element('a', 'b', '\r', '\n'));
  RC_ASSERT(lines_of(text) == naive_split(text));
}

RC_GTEST_PROP(line_reader_against_the_naive_split, around_the_border_of_windows, ()) {
  const auto piece =
      rc::gen::oneOf(rc::gen::map(rc::gen::inRange<std::size_t>(0, 100), [](std::size_t n) { return std::string(n, 'x'); }),
                     rc::gen::map(rc::gen::inRange<std::size_t>(65500, 65600), [](std::size_t n) { return std::string(n, 'y'); }),
                     rc::gen::map(rc::gen::inRange<std::size_t>(131000, 131200), [](std::size_t n) { return std::string(n, 'z'); }),
                     rc::gen::element<std::string>("\n", "\r\n", "\r", "\n\n", "\r\r\n"));
  std::string text;
  const auto border = *rc::gen::inRange<std::size_t>(window - 40, window + 40);
  for (const auto& p : *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>("a", "bb", "\n", "\r\n"))) text += p;
  text += std::string(border / 4, 'q') + "\n";
  while (text.size() + 60000 < border) text += std::string(50000, 'p') + "\n";
  text.resize(border, 'o');  // the following characters are around the border
  for (const auto& p : *rc::gen::container<std::vector<std::string>>(piece)) text += p;
  RC_ASSERT(lines_of(text) == naive_split(text));
}

class Files : public testing::Test {
 protected:
  Files() {
    directory = testing::TempDir() + "kadr_line_reader_" + std::to_string(getpid());
    std::filesystem::create_directories(directory);
  }
  ~Files() override { std::filesystem::remove_all(directory); }

  std::string directory;
};

TEST_F(Files, file_is_read_as_text_is) {
  std::string text;
  for (int i = 0; i < 60000; ++i) text += "N" + std::to_string(i) + "\r\n";
  std::ofstream(directory + "/a.nc", std::ios::binary) << text;
  auto source = open_file(directory + "/a.nc");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->size(), text.size());
  LineReader reader(std::move(source));
  EXPECT_EQ(all_lines(reader), naive_split(text));
}

TEST_F(Files, missing_file) {
  EXPECT_EQ(open_file(directory + "/none"), nullptr);
  EXPECT_EQ(errno, ENOENT);
}

TEST_F(Files, directory_is_refused) {
  EXPECT_EQ(open_file(directory), nullptr);
  EXPECT_EQ(errno, EISDIR);
}

TEST_F(Files, pipe_is_kept_in_memory) {
  const std::string path = directory + "/pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(path) << "N1\nN2\n"; });
  auto source = open_file(path);
  writer.join();
  ASSERT_TRUE(source);
  LineReader reader(std::move(source));
  EXPECT_EQ(all_lines(reader).size(), 2u);
  reader.seek(0, 1);
  EXPECT_EQ(all_lines(reader).size(), 2u);
  auto again = open_file(path);  // the guess of the control reads it, then the run reads it again; the pipe has only one writer
  ASSERT_TRUE(again);
  LineReader second(std::move(again));
  EXPECT_EQ(all_lines(second).size(), 2u);
}

}  // namespace
}  // namespace kadr::line_reader_test
