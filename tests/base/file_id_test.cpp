#include "base/file_id.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace kadr::file_id_test {
namespace {

namespace fs = std::filesystem;

/// A folder with file, hard (a second name of file), link → file, dangling → missing, and sub/.
struct Folder {
  fs::path root = fs::temp_directory_path() / ("kadr_file_id_" + std::to_string(::getpid()));
  Folder() {
    fs::create_directories(root / "sub");
    std::ofstream(root / "file") << "text";
    fs::create_hard_link(root / "file", root / "hard");
    fs::create_symlink("file", root / "link");
    fs::create_symlink("missing", root / "dangling");
  }
  ~Folder() { fs::remove_all(root); }
  std::string at(const char* name) const { return (root / name).string(); }
};

TEST(file_id, all_names_of_a_file_are_one) {
  const Folder f;
  const auto id = file_id_of(f.at("file"));
  ASSERT_TRUE(id);
  for (const char* name : {"hard", "link", "sub/../file", "./file"}) EXPECT_EQ(file_id_of(f.at(name)), id) << name;
  EXPECT_NE(file_id_of(f.at("sub")), id);
  EXPECT_FALSE(file_id_of(f.at("missing")));
  EXPECT_FALSE(file_id_of(f.at("dangling")));
}

TEST(file_id, true_path_follows_links_to_what_is_not_there_yet) {
  const Folder f;
  const std::string root = fs::canonical(f.root).string();
  EXPECT_EQ(true_path(f.at("link")), root + "/file");
  EXPECT_EQ(true_path(f.at("dangling")), root + "/missing");
  EXPECT_EQ(true_path(f.at("sub/../new")), root + "/new");
}

TEST(file_id, a_set_knows_files_that_are_to_come) {
  const Folder f;
  FileSet set;
  EXPECT_FALSE(set.has(f.at("file")));
  set.add(f.at("file"));
  set.add(f.at("missing"));
  for (const char* name : {"file", "hard", "link", "dangling", "sub/../missing"}) EXPECT_TRUE(set.has(f.at(name))) << name;
  for (const char* name : {"sub", "other"}) EXPECT_FALSE(set.has(f.at(name))) << name;
  fs::rename(f.root / "file", f.root / "moved");
  EXPECT_TRUE(set.has(f.at("moved")));
}

}  // namespace
}  // namespace kadr::file_id_test
