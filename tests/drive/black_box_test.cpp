// The record of a conversation with a machine: its form, its length, and that it is complete when the process is killed.

#include "drive/port/black_box.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <regex>

namespace kadr::drive::black_box_test {

namespace fs = std::filesystem;

class ABlackBox : public testing::Test {
 protected:
  ABlackBox() : folder_(fs::temp_directory_path() / ("kadr-black-box-" + std::to_string(::getpid()))) { fs::create_directory(folder_); }
  ~ABlackBox() override { fs::remove_all(folder_); }
  std::string file() const { return (folder_ / "drive.log").string(); }

  std::vector<std::string> lines(const std::string& name) const {
    std::ifstream from(name);
    std::vector<std::string> all;
    for (std::string line; std::getline(from, line);) all.push_back(line);
    return all;
  }

  fs::path folder_;
};

TEST_F(ABlackBox, WritesALineForEachRecord) {
  {
    const auto box = BlackBox::open(file());
    ASSERT_TRUE(box) << box.error();
    (*box)->sent("G1X10\n");
    (*box)->received("ok\r");
    (*box)->note("hold");
    (*box)->sent("\x18");
    (*box)->sent("a\nb");
    (*box)->received(std::string("\x00\xff", 2));
    EXPECT_TRUE((*box)->is_right());
  }
  const auto all = lines(file());
  ASSERT_EQ(all.size(), 6U);
  const std::regex form(R"(\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3} [<>*] .*)");
  for (const std::string& line : all) EXPECT_TRUE(std::regex_match(line, form)) << line;
  const std::size_t at = all[0].find(' ', 12) + 1;
  EXPECT_EQ(all[0].substr(at), "> G1X10");
  EXPECT_EQ(all[1].substr(at), "< ok");
  EXPECT_EQ(all[2].substr(at), "* hold");
  EXPECT_EQ(all[3].substr(at), "> \\x18");
  EXPECT_EQ(all[4].substr(at), "> a\\nb");
  EXPECT_EQ(all[5].substr(at), "< \\x00\\xff");
}

TEST_F(ABlackBox, AppendsToAnOlderRecord) {
  for (int i = 0; i < 2; ++i) (*BlackBox::open(file()))->note("begin");
  EXPECT_EQ(lines(file()).size(), 2U);
}

TEST_F(ABlackBox, BeginsANewFileWhenTheOldOneIsLong) {
  std::ofstream(file()) << std::string(BlackBox::most_bytes - 100, 'x') << '\n';
  std::ofstream(file() + ".1") << "oldest\n";
  const auto box = BlackBox::open(file());
  for (int i = 0; i < 10; ++i) (*box)->note(std::to_string(i));
  const auto before = lines(file() + ".1"), now = lines(file());
  EXPECT_EQ(before.size() + now.size(), 11U) << "a record is lost";
  EXPECT_GE(now.size(), 6U);
  EXPECT_LE(fs::file_size(file() + ".1"), BlackBox::most_bytes);
  EXPECT_TRUE(now.back().ends_with("* 9"));
}

TEST_F(ABlackBox, TellsThatTheDiskIsFull) {
  const auto box = BlackBox::open("/dev/full");
  ASSERT_TRUE(box);
  (*box)->note("lost");
  EXPECT_FALSE((*box)->is_right());
}

TEST_F(ABlackBox, SaysWhyItCannotBeWritten) {
  const auto box = BlackBox::open("/nonexistent/drive.log");
  ASSERT_FALSE(box);
  EXPECT_NE(box.error().find("/nonexistent/drive.log"), std::string::npos);
}

/// A process that is killed at a random instant leaves a file of whole records, none of them missing.
TEST_F(ABlackBox, SurvivesAKill) {
  for (int round = 0; round < 10; ++round) {
    fs::remove(file());
    const pid_t child = ::fork();
    if (child == 0) {
      const auto box = BlackBox::open(file());
      for (int i = 0;; ++i) (*box)->sent("N" + std::to_string(i) + "\n");
    }
    ASSERT_GT(child, 0);
    ::usleep(static_cast<useconds_t>(3000 + 1700 * round));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    if (!fs::exists(file()) || fs::file_size(file()) == 0) continue;
    std::ifstream from(file());
    from.seekg(-1, std::ios::end);
    EXPECT_EQ(from.get(), '\n') << "the last record is not complete";
    const auto all = lines(file());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(all[i].ends_with("> N" + std::to_string(i))) << all[i];
  }
}

}  // namespace kadr::drive::black_box_test
