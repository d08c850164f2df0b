// config/state_file: what survives power-off, and a kill. NCT 12.3, 23.1.4, 23.1.9, 24.1.

#include "config/state_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "config/random_setup.h"

namespace kadr {
namespace {

namespace fs = std::filesystem;
using enum StateTable;
using Rows = std::vector<StateRow>;

class state_file : public testing::Test {
 protected:
  state_file() {
    std::string name = fs::temp_directory_path() / "kadr_state_XXXXXX";
    folder_ = mkdtemp(name.data());
    path_ = folder_ / "shop.state";
  }
  ~state_file() override { fs::remove_all(folder_); }

  StateFile open(const std::string& control = "nct") {
    auto file = StateFile::open(path_, control);
    if (!file) throw std::runtime_error(file.error());
    return std::move(*file);
  }
  std::string refusal(const std::string& control = "nct") {
    const auto file = StateFile::open(path_, control);
    return file ? "opened" : file.error();
  }
  Rows stored() { return open().load().value().rows; }
  /// Exit status of a child process that does this.
  static int in_child(const std::function<int()>& work) {
    const pid_t child = fork();
    if (child == 0) {
      int result = 99;
      try {
        result = work();
      } catch (const std::exception& error) {
        std::fprintf(stderr, "in a child: %s\n", error.what());
      }
      _exit(result);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// Runs SQL on the file, which is not open.
  void sql(const char* statements) {
    sqlite3* connection = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &connection), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(connection, statements, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(connection);
    sqlite3_close(connection);
  }
  void text(const std::string& content) { std::ofstream(path_, std::ios::binary) << content; }
  std::string name() const { return path_; }

  fs::path folder_, path_;
};

TEST_F(state_file, round_trip) {
  EXPECT_TRUE(stored().empty());
  {
    StateFile file = open();
    ASSERT_TRUE(file.save({{{variables, "#500", 0.1 + 0.2}, {parameters, "N0605.1", std::string("1")}, {offsets, "5/length", -0.0}}}));
    ASSERT_TRUE(file.save({{{variables, "#501", 1e300}}}));
    ASSERT_TRUE(file.save({}));
  }
  {
    StateFile file = open();
    ASSERT_TRUE(file.save({{{variables, "#500", {}}, {variables, "#999", {}}, {variables, "#501", 2.0}, {variables, "#501", 3.0}}}));
    ASSERT_TRUE(file.save({{{place_table, "10/1", 0.0}}}));
  }
  const Rows expected = {
      {offsets, "5/length", -0.0}, {variables, "#501", 3.0}, {parameters, "N0605.1", std::string("1")}, {place_table, "10/1", 0.0}};
  EXPECT_EQ(stored(), expected);
}

TEST_F(state_file, not_a_number_is_refused_whole) {
  StateFile file = open();
  const auto saved = file.save({{{variables, "#500", 1.0}, {variables, "#501", std::nan("")}}});
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error(), name() + " cannot keep #501: it is not a number");
  EXPECT_TRUE(file.load().value().rows.empty());
}

TEST_F(state_file, other_control) {
  open();
  EXPECT_EQ(refusal("s2c42"), name() + " is the state of the control nct, not of s2c42");
  EXPECT_EQ(refusal(), "opened");
}

TEST_F(state_file, second_process) {
  const StateFile file = open();
  EXPECT_EQ(refusal(), name() + " is in use by another process");
  EXPECT_EQ(in_child([&] { return refusal() == name() + " is in use by another process" ? 0 : 1; }), 0);
}

TEST_F(state_file, no_state) {
  for (const std::string& content :
       {std::string("%\nN10 G0 X0\n"), std::string(5000, 'x'), std::string("SQLite format 3\0", 16) + std::string(5000, 'x')}) {
    text(content);
    EXPECT_EQ(refusal(), name() + " is no state file of Kadr");
    EXPECT_EQ(fs::file_size(path_), content.size());
  }
  fs::remove(path_);
  sql("CREATE TABLE shop (tool); INSERT INTO shop VALUES (1)");
  EXPECT_EQ(refusal(), name() + " is no state file of Kadr");
  sql("SELECT * FROM shop");
  path_ = folder_;
  EXPECT_EQ(refusal(), name() + " is no file");
  path_ = folder_ / "none" / "shop.state";
  EXPECT_EQ(refusal(), name() + " cannot be opened: No such file or directory");
  EXPECT_EQ(StateFile::open("", "nct").error(), "the state file has no name");
}

TEST_F(state_file, empty_file_is_new) {
  text("");
  EXPECT_TRUE(stored().empty());
}

TEST_F(state_file, corrupt) {
  {
    StateFile file = open();
    StateChanges many;
    for (int i = 500; i < 1000; ++i) many.rows.push_back({variables, "#" + std::to_string(i), i * 0.5});
    ASSERT_TRUE(file.save(many));
  }
  ASSERT_EQ(stored().size(), 500U);
  const auto size = fs::file_size(path_);
  for (std::uintmax_t page = 1; page < size / 1024; ++page) {
    const fs::path whole = folder_ / "whole";
    fs::copy_file(path_, whole, fs::copy_options::overwrite_existing);
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(page * 1024));
    file << std::string(1024, 'x');
    file.close();
    EXPECT_EQ(refusal(), name() + " is damaged") << page;
    fs::rename(whole, path_);
  }
  fs::resize_file(path_, size - 1024);
  EXPECT_EQ(refusal(), name() + " is damaged");
}

TEST_F(state_file, wrong_tables) {
  open();
  sql("DROP TABLE state");
  EXPECT_EQ(refusal(), name() + " is damaged");
  fs::remove(path_);
  open();
  sql("INSERT INTO state VALUES ('variables', '#500', x'00')");
  EXPECT_EQ(open().load().error(), name() + " is damaged");
}

TEST_F(state_file, newer_versions) {
  open();
  sql("PRAGMA user_version = 1007; INSERT INTO state VALUES ('magnets', 'north', 1.5)");
  ASSERT_TRUE(open().save({{{variables, "#500", 1.0}}}));
  EXPECT_EQ(stored(), (Rows{{variables, "#500", 1.0}}));
  sql("CREATE TABLE checked (n CHECK (n = 1)); INSERT INTO checked SELECT count(*) FROM state WHERE kind = 'magnets' AND value = 1.5");
  sql("PRAGMA user_version = 2000");
  EXPECT_EQ(refusal(), name() + " was written by a newer Kadr: its state version is 2, this one reads up to 1");
}

/// In a child that may write no more than so many bytes to a file.
TEST_F(state_file, full_disk) {
  const int saves = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    StateFile file = open();
    const rlimit most = {20'000, 20'000};
    setrlimit(RLIMIT_FSIZE, &most);
    int n = 0;
    tl::expected<void, std::string> saved;
    for (; n < 90 && saved; ++n) saved = file.save({{{variables, "#500", n * 1.0}, {variables, "#501", n * 1.0}}});
    const std::string sentence = saved ? "saved" : saved.error();
    if (sentence != name() + " cannot be read or written: disk I/O error") return std::fprintf(stderr, "%s\n", sentence.c_str()), 98;
    return file.load().value().rows[0].value == StateValue(n - 2.0) ? n : 97;
  });
  ASSERT_GT(saves, 2);
  ASSERT_LT(saves, 90);
  EXPECT_EQ(stored(), (Rows{{variables, "#500", saves - 2.0}, {variables, "#501", saves - 2.0}}));
}

/// In a child without the rights of root.
TEST_F(state_file, read_only) {
  ASSERT_TRUE(open().save({{{variables, "#500", 1.0}}}));
  const auto refused = [&] {
    constexpr uid_t nobody = 65534;
    if (geteuid() == 0 && setuid(nobody) != 0) return 98;
    const std::string sentence = refusal();
    if (sentence != name() + " cannot be written: it is read-only") return std::fprintf(stderr, "%s\n", sentence.c_str()), 1;
    return 0;
  };
  fs::permissions(path_, fs::perms(0444));
  fs::permissions(folder_, fs::perms(0555));
  EXPECT_EQ(in_child(refused), 0);
  fs::permissions(folder_, fs::perms(0755));
}

/// The state after the n-th block of the kill test: all rows tell n, and a few come and go.
Rows after_block(int n) {
  Rows rows;
  for (int i = 0; i < 8; ++i) rows.push_back({variables, "#" + std::to_string(500 + i * 50), n * 1.0});
  rows.push_back({variables, "#3901", n * 2.0});
  rows.push_back({parameters, "N0605.1", std::to_string(n)});
  for (int i = 1; i <= 5; ++i)
    if (n % i == 0) rows.push_back({tool_table, std::to_string(i) + "/counter", n * 1.0});
  sort_rows(rows);
  return rows;
}

StateChanges block(int n) {
  StateChanges changes{after_block(n)};
  for (int i = 1; i <= 5; ++i)
    if (n % i != 0) changes.rows.push_back({tool_table, std::to_string(i) + "/counter", {}});
  return changes;
}

// A kill at any moment leaves the state of the last block whose save came back, or of the one that was being saved.
TEST_F(state_file, killed_at_any_moment) {
  constexpr int kills = 50, longest_us = 40'000;
  auto* const done =
      static_cast<std::atomic<int>*>(mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  std::mt19937 random(std::random_device{}());
  const auto seed = random();
  RecordProperty("seed", std::to_string(seed));
  random.seed(seed);
  int kept = 0;
  for (int kill_number = 0; kill_number < kills; ++kill_number) {
    if (kill_number % 10 == 0) {  // the making of a new file is interrupted too
      for (const auto& entry : fs::directory_iterator(folder_)) fs::remove(entry);
      kept = 0;
    }
    *done = kept;
    const pid_t child = fork();
    if (child == 0) {
      auto file = StateFile::open(path_, "nct");
      for (int n = kept + 1; file && file->save(block(n)); ++n) *done = n;
      _exit(1);
    }
    usleep(static_cast<useconds_t>(random() % (kill_number % 10 == 0 ? longest_us / 10 : longest_us)));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "seed " << seed;
    const Rows rows = stored();
    const int acknowledged = *done;
    kept = rows.empty() ? 0 : static_cast<int>(std::get<double>(rows[0].value) / 2);  // "#3901" is the first
    ASSERT_EQ(rows, kept == 0 ? Rows{} : after_block(kept)) << "seed " << seed;
    ASSERT_GE(kept, acknowledged) << "seed " << seed;
    ASSERT_LE(kept, acknowledged + 1) << "seed " << seed;
  }
  munmap(done, sizeof(std::atomic<int>));
}

RC_GTEST_PROP(state_rows, read_back, ()) {
  Setup tables = test::any_tables();
  tables.variables = {{"#500", test::any_number()}, {"#501", std::nullopt}};
  std::erase_if(tables.work_offsets, [](const auto& row) { return row.second.empty(); });
  const Rows rows = rows_of(tables);
  Rows sorted = rows;
  sort_rows(sorted);
  RC_ASSERT(rows == sorted);
  const auto read = setup_of({rows});
  if (!read) RC_FAIL(read.error());
  RC_ASSERT(read->offsets == tables.offsets);
  RC_ASSERT(read->work_offsets == tables.work_offsets);
  RC_ASSERT(read->variables.size() == 1U);
  RC_ASSERT(read->variables.at("#500") == tables.variables.at("#500"));
  RC_ASSERT(read->parameters == tables.parameters);
  RC_ASSERT(read->tool_table == tables.tool_table);
  RC_ASSERT(read->place_table == tables.place_table);
  RC_ASSERT(read->form_table == tables.form_table);
}

TEST(state_rows, keys) {
  kadr::Setup tables;
  tables.offsets[5].length_wear = 0.5;
  tables.work_offsets["G54.1 P2"] = {{"X", 10}, {"G17", 30}};
  tables.tool_table[2].user[1] = 7;
  tables.parameters[{"0107", "4", "0"}] = 1.0;
  const Rows rows = rows_of(tables);
  const auto there = [&](const StateRow& row) { return std::find(rows.begin(), rows.end(), row) != rows.end(); };
  EXPECT_TRUE(there({offsets, "5/length_wear", 0.5}));
  EXPECT_TRUE(there({work_offsets, "G54.1 P2/G17", 30.0}));
  EXPECT_TRUE(there({tool_table, "2/info", std::string("UENCI")}));
  EXPECT_TRUE(there({tool_table, "2/user/2", 7.0}));
  EXPECT_TRUE(there({parameters, "N0107.4#0", 1.0}));
}

TEST(state_rows, wrong_rows) {
  const auto refusal = [](StateTable table, const char* key, const StateValue& value) {
    const auto setup = setup_of({{{table, key, value}}});
    return setup ? "read" : setup.error();
  };
  EXPECT_EQ(refusal(offsets, "5/length", std::string("a")), "setup key 'offsets.5.length' must be a number");
  EXPECT_EQ(refusal(offsets, "5", 1.0), "unknown setup key 'offsets.5.'; the nearest known one is 'length'");
  EXPECT_EQ(refusal(tool_table, "2/user/21", 1.0), "unknown setup key 'tool_table.2.user/21'; the nearest known one is 'user'");
  EXPECT_EQ(refusal(tool_table, "2/user/3", std::string("a")), "setup key 'tool_table.2.user' must be a number");
  EXPECT_EQ(refusal(variables, "500", 1.0), "setup key 'variables.500' must be named #n, #_NAME, or R0 to R9");
}

}  // namespace
}  // namespace kadr
