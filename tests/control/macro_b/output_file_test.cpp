// control/macro_b/output/output_file: modes and names of output files; nothing outside the root is ever written. NCT 23.2.13, 14.4.2.

#include "control/macro_b/output/output_file.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "choices.h"

namespace kadr::macro_b::output_file_test {
namespace {

namespace fs = std::filesystem;
using test::Choices;
using test::choices;

constexpr auto dec = PrintKind::decimal;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void put(const fs::path& file, std::string_view text) { std::ofstream(file, std::ios::binary) << text; }

/// A temporary folder that contains nothing but an empty folder `root`; the destructor removes it.
struct Folder {
  Folder() {
    std::string name = (fs::temp_directory_path() / "kadr_output_XXXXXX").string();
    all = ::mkdtemp(name.data());
    root = all / "root";
    fs::create_directory(root);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(all); }
  OutputOptions options(OutputWriting writing = OutputWriting::files) const { return {root.string(), 1 << 20, writing}; }
  fs::path all, root;
};

std::string alarm_of(const Status& status) {
  if (status) return "";
  std::string text(name_of(status.error().id));
  for (std::size_t i = 0; i < status.error().arg_count; ++i)
    text += status.error().args[i].is_number() ? " " + std::to_string(static_cast<int>(status.error().args[i].number()))
                                               : " " + std::string(status.error().args[i].text());
  return text;
}

std::string resolved(std::string_view name, std::string_view program = "part.nct") {
  const Result<std::string> path = path_in_root(name, program);
  return path ? *path : std::string(name_of(path.error().id));
}

TEST(path_in_root, rules_of_14_4_2) {
  EXPECT_EQ(resolved("data.txt"), "data.txt");
  EXPECT_EQ(resolved("data.txt", "a/b/part.nct"), "a/b/data.txt");
  EXPECT_EQ(resolved("\\подпрограммы\\подпрограмма.prg", "a/part.nct"), "a/подпрограммы/подпрограмма.prg");
  EXPECT_EQ(resolved(" ..\\подпрограмма.prg", "a/part.nct"), "подпрограмма.prg");
  EXPECT_EQ(resolved(" ..\\..\\..\\папка1\\папка2\\файл.txt ", "a/b/c/part.nct"), "папка1/папка2/файл.txt");
  EXPECT_EQ(resolved("a b.txt"), "a b.txt");
  EXPECT_EQ(resolved("d\\..\\x.txt"), "x.txt");
}

TEST(path_in_root, outside) {
  for (const char* name : {"..\\x.txt", "\\..\\x.txt", "a\\..\\..\\x.txt", "..\\root\\x.txt", "C:\\x.txt", "c:x.txt", ".."})
    EXPECT_EQ(resolved(name), "file_outside") << name;
  EXPECT_EQ(resolved("..\\..\\x.txt", "a/part.nct"), "file_outside");
}

TEST(path_in_root, names) {
  const std::string_view nul("a\0b", 3);
  for (const std::string_view name :
       std::initializer_list<std::string_view>{"",        " ",        "\\",      "a\\",  "a\\..",      "\\\\a",    "a\\\\b",
                                               ".",       ".\\a",     "...",     "/a",   "a/b",        "../x",     "/etc/passwd",
                                               nul,       "a\nb",     "a\x7F",   "ab:c", "a*",         "a?",       "a<b",
                                               "a|b",     "a\"",      "a.",      ".x",   "a\\.git\\b", "a. \\b",   "nul",
                                               "NUL.txt", "com1.x.y", "a\\Con ", "LPT9", "aux .txt",   "\xFF\xFE", "\xC0\xAE\xC0\xAE\\x"})
    EXPECT_EQ(resolved(name), "file_name") << name;
  for (const char* name : {"com", "com10", "null", "contour.nct", "a.b.c"}) EXPECT_EQ(resolved(name), name);
}

TEST(path_in_root, sixty_characters) {
  std::string name;
  for (int i = 0; i < 56; ++i) name += "ж";
  EXPECT_EQ(resolved(name + ".txt"), name + ".txt");
  EXPECT_EQ(resolved(name + "ж.txt"), "file_name");
}

RC_GTEST_PROP(path_in_root, has_no_step_that_could_climb, ()) {
  Choices choose = choices(200);
  const char* pieces[] = {"..", "\\", "\\", ".", "a", "/", "b.txt", " ", "ж", "..\\", ":"};
  const char* programs[] = {"p.nct", "a/p.nct", "a/b/p.nct"};
  for (int i = 0; i < 20; ++i) {
    std::string name;
    for (int j = choose.between(0, 8); j > 0; --j) name += choose.of(pieces);
    const Result<std::string> path = path_in_root(name, choose.of(programs));
    if (!path) continue;
    RC_ASSERT(!path->empty() && path->front() != '/' && path->find('\\') == std::string::npos);
    const std::string fenced = "/" + *path + "/";
    for (const char* bad : {"//", "/./", "/../"}) RC_ASSERT(fenced.find(bad) == std::string::npos);
  }
}

struct Mode {
  double number;
  const char* exists;   // the content if the file existed, or the alarm
  const char* missing;  // the same if the file did not exist
};
constexpr Mode modes[] = {{1, "file_exists data.txt", "B\r\n"},
                          {2, "B\r\n", "B\r\n"},
                          {3, "A\r\nB\r\n", "file_missing data.txt"},
                          {4, "A\r\nB\r\n", "B\r\n"},
                          {5, "B\r\n", "file_missing data.txt"}};

TEST(open_named, modes) {
  for (const Mode& mode : modes) {
    for (const bool exists : {true, false}) {
      Folder folder;
      if (exists) put(folder.root / "data.txt", "A\r\n");
      for (const OutputWriting writing : {OutputWriting::nothing, OutputWriting::files}) {
        OutputFile file(folder.options(writing));
        std::string result = alarm_of(file.open_named(mode.number, "data.txt", "part.nct"));
        if (result.empty()) {
          EXPECT_EQ(file.path(), "data.txt");
          EXPECT_TRUE(file.print("B\r\n", dec));
          EXPECT_TRUE(file.close_file());
          result = text_of(folder.root / "data.txt");
        }
        const std::string expected = exists ? mode.exists : mode.missing;
        const bool alarms = expected.find('_') != std::string::npos;
        if (writing == OutputWriting::files || alarms) {
          EXPECT_EQ(result, expected);
        } else {
          EXPECT_EQ(result, exists ? "A\r\n" : "");
          EXPECT_EQ(fs::exists(folder.root / "data.txt"), exists);
        }
      }
    }
  }
}

TEST(open_number, names_and_alarms) {  // golden 23-86, 23-88
  Folder folder;
  fs::create_directory(folder.root / "sub");
  put(folder.root / "O0012.nct", "old");
  put(folder.root / "O00000013.nct", "old");
  OutputFile file(folder.options());
  EXPECT_EQ(alarm_of(file.open_number(1, 12, "part.nct")), "program_file_exists O0012");
  EXPECT_EQ(alarm_of(file.open_number(1, 13, "part.nct")), "program_file_exists O00000013");
  EXPECT_EQ(alarm_of(file.open_number(3, 14, "part.nct")), "program_missing O0014");
  EXPECT_EQ(alarm_of(file.open_number(5, 12, "part.prg")), "program_missing O0012");  // another file-name extension
  EXPECT_EQ(alarm_of(file.open_number(3, 12345, "part.nct")), "program_missing O00012345");
  EXPECT_EQ(alarm_of(file.open_number(1, 0, "part.nct")), "value_out_of_range P 0");
  EXPECT_EQ(alarm_of(file.open_number(1, 1e8, "part.nct")), "value_out_of_range P 100000000");
  EXPECT_EQ(alarm_of(file.open_number(1, 1.5, "part.nct")), "value_out_of_range P 1");
  EXPECT_TRUE(file.open_number(1, 12, "sub/part.prg"));
  EXPECT_EQ(file.path(), "sub/O0012.prg");
}

TEST(open_named, small_and_capital_letters_are_alike) {
  Folder folder;
  fs::create_directory(folder.root / "Sub");
  put(folder.root / "Sub" / "Data.TXT", "A");
  OutputFile file(folder.options());
  EXPECT_EQ(alarm_of(file.open_named(1, "sub\\data.txt", "part.nct")), "file_exists sub\\data.txt");
  EXPECT_TRUE(file.open_named(4, "sub\\data.txt", "part.nct"));
  EXPECT_EQ(file.path(), "Sub/Data.TXT");
}

TEST(output_file, order_of_statements) {
  Folder folder;
  OutputFile file(folder.options());
  EXPECT_EQ(alarm_of(file.print("A\r\n", dec)), "file_not_open");
  EXPECT_EQ(alarm_of(file.close_file()), "file_not_open");
  EXPECT_EQ(alarm_of(file.close_device(31)), "file_not_open");
  for (const double mode : {0.0, 6.0, 1.5, -1.0, 1e300}) EXPECT_EQ(alarm_of(file.open_named(mode, "a", "p.nct")).substr(0, 9), "file_mode");
  EXPECT_EQ(alarm_of(file.open_device(30, "p.nct")), "file_mode 30");
  ASSERT_TRUE(file.open_named(2, "a.txt", "p.nct"));
  EXPECT_EQ(alarm_of(file.open_named(2, "b.txt", "p.nct")), "file_already_open a.txt");
  EXPECT_EQ(alarm_of(file.open_number(2, 1, "p.nct")), "file_already_open a.txt");
  EXPECT_EQ(alarm_of(file.open_device(31, "p.nct")), "file_already_open a.txt");
  EXPECT_EQ(alarm_of(file.close_device(31)), "file_not_open");
  EXPECT_EQ(alarm_of(file.close_device(1)), "file_mode 1");
  EXPECT_TRUE(file.is_open());
  EXPECT_TRUE(file.close_file());
  EXPECT_FALSE(file.is_open());
}

TEST(open_device, name_from_the_first_print) {  // golden 23-83, 23-84
  Folder folder;
  fs::create_directory(folder.root / "sub");
  OutputFile file(folder.options());
  ASSERT_TRUE(file.open_device(31, "sub/part.nct"));
  EXPECT_EQ(alarm_of(file.close_device(31)), "file_name ");
  EXPECT_EQ(alarm_of(file.print("ABC\r\n", PrintKind::binary)), "file_name ABC");
  EXPECT_EQ(alarm_of(file.print("A/B\r\n", dec)), "file_name A/B.nct");
  EXPECT_EQ(alarm_of(file.print("..\\A\r\n", dec)), "file_name ..\\A");
  EXPECT_EQ(alarm_of(file.print("\r\n", dec)), "file_name ");
  ASSERT_TRUE(file.print("O 4567\r\n", dec));  // PNT=0: with a column for the sign
  EXPECT_EQ(text_of(folder.root / "sub" / "O4567.nct"), "%\r\n");
  ASSERT_TRUE(file.print("X 1\r\n", dec));
  EXPECT_EQ(text_of(folder.root / "sub" / "O4567.nct"), "%\r\nX 1\r\n");  // written at once
  EXPECT_EQ(alarm_of(file.close_file()), "file_not_open");
  ASSERT_TRUE(file.close_device(31));
  EXPECT_EQ(text_of(folder.root / "sub" / "O4567.nct"), "%\r\nX 1\r\n%\r\n");
  ASSERT_TRUE(file.open_device(31, "sub/part.nct"));
  ASSERT_TRUE(file.print("O4567\r\n", dec));  // overwritten without a question
  file.abort();                               // what M30 does
  EXPECT_FALSE(file.is_open());
  EXPECT_EQ(text_of(folder.root / "sub" / "O4567.nct"), "%\r\n");
}

TEST(output_file, the_running_program_is_not_written) {
  Folder folder;
  put(folder.root / "O0001.nct", "G0");
  OutputFile file(folder.options());
  EXPECT_EQ(alarm_of(file.open_number(2, 1, "O0001.nct")), "file_already_open O0001");
  EXPECT_EQ(alarm_of(file.open_named(4, "o0001.NCT", "O0001.nct")), "file_already_open o0001.NCT");
  EXPECT_EQ(text_of(folder.root / "O0001.nct"), "G0");
}

TEST(output_file, missing_folders_and_a_missing_root) {
  Folder folder;
  OutputFile file(folder.options());
  EXPECT_EQ(alarm_of(file.open_named(1, "no\\a.txt", "p.nct")), "file_write no\\a.txt");
  EXPECT_EQ(alarm_of(file.open_named(3, "no\\a.txt", "p.nct")), "file_missing no\\a.txt");
  OutputFile nowhere({(folder.all / "none").string(), 100, OutputWriting::files});
  EXPECT_EQ(alarm_of(nowhere.open_named(1, "a.txt", "p.nct")), "file_write a.txt");
}

TEST(output_file, size_limit_is_for_the_whole_run) {
  for (const OutputWriting writing : {OutputWriting::files, OutputWriting::nothing}) {
    Folder folder;
    OutputFile file({folder.root.string(), 10, writing});
    ASSERT_TRUE(file.open_named(2, "a.txt", "p.nct"));
    ASSERT_TRUE(file.print("1234\r\n", dec));
    EXPECT_EQ(alarm_of(file.print("123\r\n", dec)), "file_write a.txt");
    EXPECT_EQ(text_of(folder.root / "a.txt"), writing == OutputWriting::files ? "1234\r\n" : "");
    ASSERT_TRUE(file.close_file());
    ASSERT_TRUE(file.open_named(2, "b.txt", "p.nct"));
    EXPECT_EQ(alarm_of(file.print("123\r\n", dec)), "file_write b.txt");
    EXPECT_TRUE(file.print("12\r\n", dec));
  }
}

TEST(output_file, a_statement_that_fails_halfway_is_taken_back) {
  Folder folder;
  OutputFile file(folder.options());
  ASSERT_TRUE(file.open_named(2, "a.txt", "p.nct"));
  ASSERT_TRUE(file.print("1\r\n", dec));
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit limit {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const struct rlimit small { 5, limit.rlim_max };
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const Status failed = file.print("234\r\n", dec);  // two more bytes fit
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, before);
  EXPECT_EQ(alarm_of(failed), "file_write a.txt");
  EXPECT_TRUE(file.print("5\r\n", dec));
  EXPECT_EQ(text_of(folder.root / "a.txt"), "1\r\n5\r\n");
}

TEST(output_file, what_is_no_plain_file_is_not_written) {
  Folder folder;
  put(folder.all / "outside.txt", "safe");
  fs::create_directory(folder.all / "away");
  fs::create_symlink(folder.all / "outside.txt", folder.root / "link.txt");
  fs::create_symlink(folder.all / "nothing.txt", folder.root / "dangling.txt");
  fs::create_directory_symlink(folder.all / "away", folder.root / "door");
  fs::create_hard_link(folder.all / "outside.txt", folder.root / "second.txt");
  fs::create_directory(folder.root / "folder.txt");
  ASSERT_EQ(::mkfifo((folder.root / "pipe.txt").c_str(), 0600), 0);
  for (const OutputWriting writing : {OutputWriting::nothing, OutputWriting::files}) {
    OutputFile file(folder.options(writing));
    for (double mode = 1; mode <= 5; ++mode) {
      for (const char* name : {"link.txt", "dangling.txt", "door\\a.txt", "second.txt", "LINK.TXT", "Door\\a.txt"})
        EXPECT_EQ(alarm_of(file.open_named(mode, name, "p.nct")), std::string("file_outside ") + name) << mode;
      for (const char* name : {"folder.txt", "pipe.txt"})
        EXPECT_EQ(alarm_of(file.open_named(mode, name, "p.nct")), std::string("file_write ") + name) << mode;
    }
  }
  EXPECT_EQ(text_of(folder.all / "outside.txt"), "safe");
  EXPECT_TRUE(fs::is_empty(folder.all / "away"));
  EXPECT_FALSE(fs::exists(folder.all / "nothing.txt"));
}

TEST(output_file, a_root_that_is_a_link_itself) {
  Folder folder;
  fs::create_directory_symlink(folder.root, folder.all / "memory");
  OutputFile file({(folder.all / "memory").string(), 100, OutputWriting::files});
  EXPECT_TRUE(file.open_named(1, "a.txt", "p.nct"));
  EXPECT_TRUE(fs::exists(folder.root / "a.txt"));
}

TEST(output_file, dry_knows_what_it_would_have_made) {
  Folder folder;
  OutputFile file(folder.options(OutputWriting::nothing));
  ASSERT_TRUE(file.open_number(1, 12, "p.nct"));
  ASSERT_TRUE(file.print("A\r\n", dec));
  ASSERT_TRUE(file.close_file());
  EXPECT_EQ(alarm_of(file.open_number(1, 12, "p.nct")), "program_file_exists O0012");
  ASSERT_TRUE(file.open_named(3, "o0012.nct", "p.nct"));
  file.abort();
  ASSERT_TRUE(file.open_device(31, "p.nct"));
  ASSERT_TRUE(file.print("A\r\n", dec));
  ASSERT_TRUE(file.close_device(31));
  ASSERT_TRUE(file.open_named(5, "A.nct", "p.nct"));
  EXPECT_TRUE(fs::is_empty(folder.root));
}

/// Returns all files below a folder with their text; links are not followed.
std::map<std::string, std::string> all_files(const fs::path& folder, const fs::path& but) {
  std::map<std::string, std::string> files;
  for (auto at = fs::recursive_directory_iterator(folder); at != fs::recursive_directory_iterator(); ++at) {
    if (at->path() == but) at.disable_recursion_pending();
    else files[at->path().string()] = at->is_regular_file() ? text_of(at->path()) : "";
  }
  return files;
}

RC_GTEST_PROP(output_file, nothing_outside_the_root_ever_changes, ()) {
  Choices choose = choices(200);
  Folder folder;
  fs::create_directories(folder.root / "a" / "b");
  fs::create_directory(folder.all / "away");
  put(folder.all / "out.txt", "safe");
  put(folder.all / "away" / "x.txt", "safe");
  fs::create_directory_symlink("..", folder.root / "up");
  fs::create_directory_symlink(folder.all / "away", folder.root / "a" / "door");
  fs::create_symlink("../out.txt", folder.root / "link");
  const auto before = all_files(folder.all, folder.root);
  const char* pieces[] = {"a",    "b",  "up", "door", "link", "..", "x.txt", "out.txt", "root",
                          "away", "\\", "\\", "\\",   "..\\", ".",  "/",     " "};
  const char* programs[] = {"p.nct", "a/p.nct", "a/b/p.nct"};
  OutputFile file(folder.options());
  for (int i = 0; i < 10; ++i) {
    std::string name;
    for (int j = choose.between(1, 7); j > 0; --j) name += choose.of(pieces);
    const char* program = choose.of(programs);
    if (choose.one_in(4)) {
      static_cast<void>(file.open_device(31, program));
      static_cast<void>(file.print(name, dec));
    } else {
      static_cast<void>(file.open_named(choose.between(1, 5), name, program));
    }
    static_cast<void>(file.print("text\r\n", dec));  // this text may become the file's name
    if (file.print("text\r\n", dec)) {
      const fs::path written = fs::canonical(folder.root / file.path());
      RC_ASSERT(written.string().rfind(fs::canonical(folder.root).string() + "/", 0) == 0);
      RC_ASSERT(text_of(written).find("text\r\n") != std::string::npos);
    }
    file.abort();
  }
  RC_ASSERT(all_files(folder.all, folder.root) == before);
}

}  // namespace
}  // namespace kadr::macro_b::output_file_test
