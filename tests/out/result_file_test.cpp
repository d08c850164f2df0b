#include "out/trace/result_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace kadr::result_file_test {
namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path root = fs::temp_directory_path() / ("kadr_result_file_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(root); }
  ~Folder() { fs::remove_all(root); }
  std::string at(const char* name) const { return (root / name).string(); }
  std::string text(const char* name) const {
    std::ifstream file(root / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  auto files() const { return std::distance(fs::directory_iterator(root), fs::directory_iterator()); }
};

TEST(result_file, what_is_not_kept_was_never_there) {
  const Folder f;
  std::ofstream(f.root / "old") << "old";
  for (const char* name : {"old", "new"}) {
    auto file = ResultFile::open(f.at(name));
    ASSERT_TRUE(file);
    std::fputs("new", file->get());
  }
  EXPECT_EQ(f.text("old"), "old");
  EXPECT_EQ(f.files(), 1);
}

TEST(result_file, kept_it_takes_its_place) {
  const Folder f;
  std::ofstream(f.root / "old") << "old";
  auto file = ResultFile::open(f.at("old"));
  ASSERT_TRUE(file);
  std::fputs("new", file->get());
  std::fflush(file->get());
  EXPECT_EQ(f.text("old"), "old") << "until then what was there stays";
  ResultFile moved = std::move(*file);
  EXPECT_TRUE(moved.keep());
  EXPECT_EQ(f.text("old"), "new");
  EXPECT_EQ(f.files(), 1);
}

TEST(result_file, a_full_disk_is_told) {
  auto file = ResultFile::open("/dev/full");
  ASSERT_TRUE(file);
  std::fputs("new", file->get());
  const auto kept = file->keep();
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error(), "/dev/full: the disk is full");
}

TEST(result_file, places_that_cannot_be) {
  const Folder f;
  EXPECT_EQ(ResultFile::open(f.root.string()).error(), f.root.string() + ": it is a directory");
  EXPECT_EQ(ResultFile::open(f.at("no/folder")).error(), f.at("no/folder") + ": there is no such file");
}

TEST(result_file, of_a_process_that_ends_at_once_nothing_is_left) {
  const Folder f;
  EXPECT_EXIT(
      {
        auto file = ResultFile::open(f.at("new"));
        std::fputs("new", file->get());
        ResultFile::discard_all();
        ::_exit(file->get() != nullptr && f.files() == 0 ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
  EXPECT_EQ(f.files(), 0);
}

}  // namespace
}  // namespace kadr::result_file_test
