// config/read_file: reads small files of ours whole. It refuses files that block or never end.

#include "config/read_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "config/control/control_file.h"
#include "config/drawing/drawing.h"
#include "config/language.h"
#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"

namespace kadr::read_file_test {
namespace {

namespace fs = std::filesystem;

class read_file_of : public testing::Test {
 protected:
  read_file_of() {
    std::string name = fs::temp_directory_path() / "kadr_read_XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~read_file_of() override {
    set_process_language(Lang::en);
    fs::remove_all(folder_);
  }
  fs::path folder_;
};

TEST_F(read_file_of, bytes_as_they_are) {
  const std::string content("a\r\n\0\xFF", 5);
  std::ofstream(folder_ / "f", std::ios::binary) << content;
  EXPECT_EQ(read_file(folder_ / "f").value(), content);
  EXPECT_EQ(read_file(folder_ / "f", 5).value(), content);
  fs::create_symlink(folder_ / "f", folder_ / "link");
  EXPECT_EQ(read_file(folder_ / "link").value(), content);
}

TEST_F(read_file_of, too_long) {
  const std::string name = folder_ / "f";
  std::ofstream(name) << "x";
  fs::resize_file(name, (16U << 20) + 1);  // a sparse file: it uses no disk space
  const std::string sentence = name + ": is longer than 16 MiB, the most that such a file may have";
  EXPECT_EQ(read_file(name).error(), sentence);
  EXPECT_EQ(load_setup(name).error(), sentence);
  fs::rename(name, name + ".toml");
  EXPECT_EQ(load_control(name + ".toml").error(), name + ".toml: is longer than 16 MiB, the most that such a file may have");
  EXPECT_EQ(load_machine(name + ".toml").error(), name + ".toml: is longer than 16 MiB, the most that such a file may have");
}

TEST_F(read_file_of, what_is_no_file) {
  EXPECT_EQ(read_file("/dev/zero").error(), "/dev/zero: is a device, not a file");
  EXPECT_EQ(read_file(folder_).error(), folder_.string() + ": is a directory, not a file");
  const std::string pipe = folder_ / "pipe.toml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(load_setup(pipe).error(), pipe + ": is a pipe, not a file");
  EXPECT_EQ(load_control(pipe).error(), pipe + ": is a pipe, not a file");
  EXPECT_EQ(load_machine(pipe).error(), pipe + ": is a pipe, not a file");
  EXPECT_EQ(parse_control("id = 'a'\nextends = '" + pipe + "'", "house.toml").error(),
            "house.toml: extends '" + pipe + "': no such control, and " + pipe + ": is a pipe, not a file");
  EXPECT_EQ(read_file(folder_ / "none").error(), (folder_ / "none").string() + ": cannot be read: there is no such file");
  fs::create_symlink("circle", folder_ / "circle");
  EXPECT_EQ(read_file(folder_ / "circle").error(), (folder_ / "circle").string() + ": cannot be read: its links go in a circle");
}

TEST_F(read_file_of, russian) {
  set_process_language(Lang::ru);
  EXPECT_EQ(read_file("/dev/zero").error(), "/dev/zero: это устройство, а не файл");
  EXPECT_EQ(read_file("/none").error(), "/none: не читается: такого файла нет");
}

TEST(location_prefix, columns_count_characters) {
  EXPECT_EQ(location_prefix("a.json", "{\n  \"Ось\": ?}", 14), "a.json:2:10: ");
  EXPECT_EQ(location_prefix("", "?", 0), "line 1, column 1: ");
}

TEST(no_text_message, other_encodings) {
  EXPECT_EQ(no_text_message("\xFF\xFE{", "a"), "a:1:1: the file is UTF-16; save it as UTF-8");
  EXPECT_EQ(no_text_message(std::string_view("x\n\0", 3), "a"), "a:2:1: a NUL byte: this is no text");
  EXPECT_EQ(no_text_message("Ось", "a"), "");
}

}  // namespace
}  // namespace kadr::read_file_test
