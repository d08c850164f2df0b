// Serves one folder, and nothing outside it.

#include "view/served_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "view/folder_names.h"

namespace kadr::served_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(ServedFolder, KindsByName) {
  using Kind = FolderEntry::Kind;
  EXPECT_EQ(kind_of_file("PART.NC"), Kind::program);
  for (const char* const name : {"O0001", "1001", "%12", "P5.001", "sub/O7", "a.b.NGC", "part.txt"})
    EXPECT_EQ(kind_of_file(name), Kind::program) << name;
  for (const char* const name : {"X", "new.sh", "key.pem", "id_rsa", "Makefile", "a.py", "O12.sh", "ABC1", ".nc", ""})
    EXPECT_EQ(kind_of_file(name), Kind::other) << name;
  EXPECT_EQ(kind_of_file("shop.json"), Kind::setup);
  EXPECT_EQ(kind_of_file("tools.toml"), Kind::tools);
  EXPECT_EQ(kind_of_file("part.STL"), Kind::other);
}

/// What the kernel does for a server, a page in a browser and an old kernel do step by step: with the same result.
TEST(ServedFolder, IsNotLeftStepByStepEither) {
  const fs::path above = fs::temp_directory_path() / ("kadr_by_parts_" + std::to_string(::getpid()));
  fs::create_directories(above / "in" / "sub" / "deep");
  for (const char* const name : {"out.nc", "in/a.nc", "in/sub/b.nc", "in/sub/deep/c.nc"}) std::ofstream(above / name) << "M30\n";
  fs::create_symlink(above / "out.nc", above / "in" / "link.nc");
  fs::create_symlink(above, above / "in" / "up");
  fs::create_symlink("deep", above / "in" / "sub" / "also");
  {
    const served::OpenFile folder(::open((above / "in").c_str(), O_RDONLY | O_DIRECTORY));
    ASSERT_TRUE(folder.is_open());
    for (const char* const name : {"", "a.nc", "sub", "sub/b.nc", "sub/deep/c.nc", "./a.nc", "..", "../out.nc", "sub/../a.nc", "link.nc",
                                   "up/out.nc", "sub/also/c.nc", "/etc/passwd", "a.nc/", "a.nc/b", "none", "none/b.nc"}) {
      const served::OpenFile kernel = served::open(folder.fd(), name, O_RDONLY), steps = served::open_by_parts(folder.fd(), name, O_RDONLY);
      if (std::string_view(name) != "sub/../a.nc") {
        EXPECT_EQ(kernel.is_open(), steps.is_open()) << name;
      }
      if (std::string_view(name).find("..") != std::string_view::npos) {
        EXPECT_FALSE(steps.is_open()) << name;
      }
    }
    const served::OpenFile made = served::open_by_parts(folder.fd(), "sub/new.nc", O_WRONLY | O_CREAT | O_EXCL, 0644);
    EXPECT_TRUE(made.is_open());
    EXPECT_FALSE(served::open_by_parts(folder.fd(), "sub/new.nc", O_WRONLY | O_CREAT | O_EXCL, 0644).is_open());
    EXPECT_EQ(errno, EEXIST);
  }
  fs::remove_all(above);
}

TEST(ServedFolder, NothingBeyondIt) {
  const fs::path above = fs::temp_directory_path() / ("kadr_served_" + std::to_string(::getpid()));
  fs::create_directories(above / "in" / "sub");
  std::ofstream(above / "out.nc") << "M30\n";
  std::ofstream(above / "in" / "a.nc") << "M30\n";
  fs::create_symlink(above / "out.nc", above / "in" / "link.nc");
  fs::create_symlink(above, above / "in" / "up");
  {
    const auto folder = ServedFolder::open((above / "in").string());
    ASSERT_TRUE(folder);
    EXPECT_TRUE(folder->path_of("a.nc"));
    for (const char* name : {"", ".", "..", "../out.nc", "link.nc", "up/out.nc", "sub/../a.nc", "/etc/passwd", "sub", "a.nc/", "sub//x"})
      EXPECT_FALSE(folder->path_of(name)) << name;
    // The path that a program names, as a path in the file system.
    const std::string in = (fs::canonical(above) / "in").string();
    const auto opens = [&](const std::string& path) {
      const int fd = folder->open_for_reading(path);
      if (fd >= 0) ::close(fd);
      return fd >= 0;
    };
    EXPECT_TRUE(opens(in + "/a.nc"));
    EXPECT_TRUE(opens(in + "/sub/../a.nc"));
    for (const char* name :
         {"", ".", "/..", "/../out.nc", "/link.nc", "/up/out.nc", "/sub", "/sub/../../out.nc", "/.a.nc", "x/a.nc", "/./../in/../out.nc"})
      EXPECT_FALSE(opens(in + name)) << name;
    EXPECT_FALSE(opens("a.nc"));
    EXPECT_FALSE(opens("/etc/passwd"));
    EXPECT_TRUE(folder->reaches(in + "/SystemMacros/Channel1"));
    EXPECT_FALSE(folder->reaches(in + "/../SystemMacros/Channel1"));
    EXPECT_EQ(folder->list("")->entries.size(), 2U);
    EXPECT_FALSE(folder->list("up"));
    const auto read = folder->read("a.nc", 100);
    ASSERT_TRUE(read);
    EXPECT_FALSE(folder->read("a.nc", 2));
    const auto saved = folder->save("a.nc", "M2\n", read->digest);
    ASSERT_TRUE(saved);
    EXPECT_TRUE(folder->save("a.nc", "M3\n", read->digest).error().changed);
    EXPECT_EQ(folder->read("a.nc", 100)->bytes, "M2\n");
    EXPECT_FALSE(folder->save("link.nc", "x", std::nullopt));
    EXPECT_FALSE(folder->save("up/x.nc", "x", std::nullopt));
    EXPECT_FALSE(folder->save("a.png", "x", std::nullopt));
  }
  EXPECT_FALSE(ServedFolder::open((above / "none").string()));
  fs::remove_all(above);
}

}  // namespace
}  // namespace kadr::served_folder_test
