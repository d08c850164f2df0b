// config/state/state_file: the state that survives power-off and a killed process. NCT 12.3, 23.1.4, 23.1.9, 24.1.

#include "config/state/state_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
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
#include "config/state/state_check.h"

namespace kadr::state_file_test {
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
  /// Runs `work` in a child process and returns its exit status.
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
  /// Runs SQL on the file while Kadr does not have it open.
  void sql(const char* statements) {
    sqlite3* connection = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &connection), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(connection, statements, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(connection);
    sqlite3_close(connection);
  }
  void text(const std::string& content) { std::ofstream(path_, std::ios::binary) << content; }
  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  bool is_refused() { return refusal().starts_with(name() + " is"); }
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
  for (const std::string& content : {std::string("%\nN10 G0 X0\n"), std::string(5000, 'x'),
                                     std::string("\x7f"
                                                 "ELF"),
                                     std::string(1, '\0'), std::string("SQLite format 3\0", 16) + std::string(5000, 'x')}) {
    text(content);
    EXPECT_EQ(refusal(), name() + " is no state file of Kadr");
    EXPECT_EQ(bytes(), content);
    EXPECT_FALSE(check_state(path_));
  }
  fs::remove(path_);
  sql("CREATE TABLE shop (tool); INSERT INTO shop VALUES (1)");
  EXPECT_EQ(refusal(), name() + " is no state file of Kadr");
  sql("SELECT * FROM shop");
  path_ = folder_ / "none" / "shop.state";
  EXPECT_EQ(refusal(), name() + " cannot be made: there is no such directory");
  EXPECT_EQ(StateFile::open("", "nct").error(), "the state file has no name");
}

TEST_F(state_file, what_is_no_file_is_refused_without_waiting) {
  path_ = folder_;
  EXPECT_EQ(refusal(), name() + " is a directory, not a file");
  path_ = "/dev/zero";
  EXPECT_EQ(refusal(), name() + " is a device, not a file");
  path_ = folder_ / "pipe";
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_EQ(refusal(), name() + " is a pipe, not a file");
  EXPECT_EQ(check_state(path_).error(), name() + " is a pipe, not a file");
}

// A program's own FOPEN may have created the file, so an empty file must not be read as an empty state.
TEST_F(state_file, empty_file_is_none) {
  text("");
  EXPECT_EQ(refusal().substr(0, name().size() + 33), name() + " is empty: no state file of Kadr.");
  EXPECT_EQ(fs::file_size(path_), 0U);
  EXPECT_FALSE(fs::exists(name() + "-wal"));
}

/// The log left from an earlier file would be applied to a new one.
TEST_F(state_file, log_of_an_earlier_file) {
  std::ofstream(name() + "-wal") << "x";
  EXPECT_EQ(refusal(), name() + " cannot be made: the log of an earlier one, " + name() + "-wal, is still there; put it away first");
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(state_file, corrupt) {
  {
    StateFile file = open();
    StateChanges many;
    for (int i = 500; i < 1000; ++i) many.rows.push_back({variables, "#" + std::to_string(i), i * 0.5});
    ASSERT_TRUE(file.save(many));
  }
  const Rows all = stored();
  ASSERT_EQ(all.size(), 500U);
  const auto size = fs::file_size(path_);
  const std::string sound = bytes();
  for (std::uintmax_t page = 0; page < size / 1024; ++page) {
    std::string wrong = sound;
    wrong.replace(page * 1024, 1024, 1024, 'x');
    text(wrong);
    EXPECT_TRUE(is_refused()) << page;
    EXPECT_EQ(bytes(), wrong) << page;
    fs::remove(folder_ / "new.state");
    if (page == 1) continue;  // a page of the control's name
    const auto found = recover_state(path_, folder_ / "new.state", "nct");
    if (!found) continue;  // nothing can be recovered: this is the first page of the rows
    EXPECT_FALSE(found->faults.empty());
    const Rows kept = StateFile::open(folder_ / "new.state", "nct")->load().value().rows;
    EXPECT_GE(kept.size(), 200U) << page;  // a page in the middle of the tree has many pages below it
    for (const StateRow& row : kept) EXPECT_NE(std::find(all.begin(), all.end(), row), all.end());
  }
  text(sound.substr(0, size - 1024));
  EXPECT_TRUE(is_refused());
}

TEST_F(state_file, wrong_tables) {
  open();
  sql("DROP TABLE state");
  EXPECT_TRUE(is_refused());
  fs::remove(path_);
  open();
  sql("CREATE TRIGGER more AFTER INSERT ON state BEGIN DELETE FROM about; END");
  EXPECT_TRUE(is_refused());
  fs::remove(path_);
  open();
  sql("INSERT INTO state VALUES ('variables', '#500', x'00', 1, 1, 0, 0)");
  EXPECT_TRUE(is_refused());
}

/// Rows changed from outside Kadr: a value changed, a row added, a row removed, a row restored from an earlier time.
TEST_F(state_file, rows_of_others) {
  ASSERT_TRUE(open().save({{{variables, "#500", 1.0}, {variables, "#501", 2.0}}}));
  const std::string sound = bytes();
  const auto after = [&](const char* statements) {
    text(sound);
    sql(statements);
    return refusal();
  };
  const std::string end = ". All faults: kadr state check; what can be read: kadr state recover";
  EXPECT_EQ(after("UPDATE state SET value = 3.0 WHERE key = '#500'"),
            name() + " is damaged: variables #500: its checksum does not fit, it holds 3 (1 more)" + end);
  EXPECT_EQ(after("DELETE FROM state WHERE key = '#501'"),
            name() + " is damaged: the checksum of the whole does not fit: 1 sound rows, 2 were saved" + end);
  EXPECT_EQ(after("INSERT INTO state SELECT 'magnets', key, value, turn, rows, whole, sum FROM state WHERE key = '#501'")
                .substr(name().size(), 60),
            " is damaged: magnets #501: its checksum does not fit, it hol");
  EXPECT_EQ(after("UPDATE about SET value = 'nbt' WHERE name = 'control'").substr(name().size(), 12), " is damaged:");
  text(sound);
  EXPECT_EQ(stored().size(), 2U);
}

TEST_F(state_file, check_names_each_damaged_row) {
  ASSERT_TRUE(open().save({{{variables, "#500", 1.0}, {variables, "#501", 2.0}, {work_offsets, "G54/X", 40.0}}}));
  EXPECT_TRUE(check_state(path_)->faults.empty());
  EXPECT_EQ(check_state(path_)->rows, 3U);
  EXPECT_EQ(check_state(path_)->control, "nct");
  sql("UPDATE state SET value = 3.5 WHERE key = '#500'; UPDATE state SET key = 'G55/X' WHERE key = 'G54/X'");
  const std::string before = bytes();
  const auto report = check_state(path_);
  EXPECT_EQ(report->faults, (std::vector<std::string>{"variables #500: its checksum does not fit, it holds 3.5",
                                                      "work_offsets G55/X: its checksum does not fit, it holds 40",
                                                      "the checksum of the whole does not fit: 1 sound rows, 3 were saved"}));
  const auto found = recover_state(path_, folder_ / "new.state", "");
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(found->faults, report->faults);
  EXPECT_EQ(bytes(), before);
  EXPECT_EQ(recover_state(path_, folder_ / "new.state", "").error(), (folder_ / "new.state").string() + " is there already");
  path_ = folder_ / "new.state";
  EXPECT_EQ(stored(), (Rows{{variables, "#501", 2.0}}));
}

TEST_F(state_file, in_use_cannot_be_checked) {
  const StateFile file = open();
  const auto sentence = [&] { return check_state(path_).error() == name() + " is in use by another process" ? 0 : 1; };
  EXPECT_EQ(in_child(sentence), 0);
}

/// A file of the form that Kadr wrote before there were checksums.
TEST_F(state_file, without_checksums) {
  sql("PRAGMA page_size = 1024; CREATE TABLE about (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE state (kind TEXT, key TEXT, value NOT NULL, PRIMARY KEY (kind, key)) WITHOUT ROWID;"
      "PRAGMA application_id = 1264673906; PRAGMA user_version = 1000; INSERT INTO about VALUES ('control', 'nct');"
      "INSERT INTO state VALUES ('variables', '#500', 1.5), ('parameters', 'N0605.1', 'S'), ('tool_table', '1/T', 4.0)");
  const Rows old = {{variables, "#500", 1.5}, {parameters, "N0605.1", std::string("S")}, {tool_table, "1/T", 4.0}};
  EXPECT_TRUE(state_is_unchecked(path_));
  EXPECT_FALSE(check_state(path_)->checked);
  EXPECT_EQ(stored(), old);
  EXPECT_TRUE(state_is_unchecked(path_));  // reading changes nothing
  {
    StateFile file = open();
    ASSERT_TRUE(file.save({{{variables, "#500", {}}}}));
    ASSERT_TRUE(file.save({{{variables, "#501", 7.0}}}));
  }
  EXPECT_FALSE(state_is_unchecked(path_));
  EXPECT_TRUE(check_state(path_)->faults.empty());
  EXPECT_TRUE(check_state(path_)->checked);
  EXPECT_EQ(stored(), (Rows{{variables, "#501", 7.0}, {parameters, "N0605.1", std::string("S")}, {tool_table, "1/T", 4.0}}));
}

TEST_F(state_file, newer_versions) {
  open();
  sql("PRAGMA user_version = 2007");
  ASSERT_TRUE(open().save({{{variables, "#500", 1.0}}}));
  sql("PRAGMA user_version = 3000");
  EXPECT_EQ(refusal(), name() + " was written by a newer Kadr: its state version is 3, this one reads up to 2");
}

// Flips one bit of each byte of a small file, one at a time. The file must
// be refused or give exactly the same values. (All bits take minutes.)
TEST_F(state_file, one_flipped_bit) {
  ASSERT_TRUE(open().save({{{variables, "#500", 1.5},
                            {variables, "#501", -0.1},
                            {work_offsets, "G54/X", 40.0},
                            {parameters, "N0605.1", std::string("S")},
                            {tool_table, "1/T", 4.0}}}));
  const Rows rows = stored();
  const std::string sound = bytes();
  int refused = 0, same = 0, tried = 0, recovered = 0;
  for (std::size_t byte = 0; byte < sound.size(); ++byte) {
    const std::size_t bit = byte * 8 + byte % 8;
    std::string flipped = sound;
    flipped[byte] = static_cast<char>(flipped[byte] ^ (1 << bit % 8));
    for (const auto& entry : fs::directory_iterator(folder_)) fs::remove(entry);
    text(flipped);
    const auto file = StateFile::open(path_, "nct");
    if (file) {
      ++same;
      ASSERT_EQ(const_cast<StateFile&>(*file).load().value().rows, rows) << "bit " << bit;
      continue;
    }
    ++refused;
    ASSERT_EQ(bytes(), flipped) << "bit " << bit;
    if (refused % 4 != 0) continue;
    ++tried;
    const auto found = recover_state(path_, folder_ / "new.state", "nct");
    if (found && found->rows + 1 >= rows.size()) ++recovered;
    if (!found) continue;
    const Rows kept = StateFile::open(folder_ / "new.state", "nct")->load().value().rows;
    for (const StateRow& row : kept) ASSERT_NE(std::find(rows.begin(), rows.end(), row), rows.end()) << "bit " << bit;
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(same, 100);
  EXPECT_GT(recovered, tried * 8 / 10) << tried;  // all rows but one
}

TEST_F(state_file, cut_off) {
  ASSERT_TRUE(open().save({{{variables, "#500", 1.5}}}));
  const std::string sound = bytes();
  for (std::size_t size = 0; size < sound.size(); size += size < 200 ? 1 : 13) {
    text(sound.substr(0, size));
    ASSERT_NE(refusal(), "opened") << size;
    ASSERT_EQ(fs::file_size(path_), size);
  }
}

/// Runs in a child process that may write only a limited number of bytes to a file.
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
    if (sentence != name() + " cannot be read or written: disk I/O error") {
      std::fprintf(stderr, "%s\n", sentence.c_str());
      return 98;
    }
    return file.load().value().rows[0].value == StateValue(n - 2.0) ? n : 97;
  });
  ASSERT_GT(saves, 2);
  ASSERT_LT(saves, 90);
  EXPECT_EQ(stored(), (Rows{{variables, "#500", saves - 2.0}, {variables, "#501", saves - 2.0}}));
}

/// Runs in a child process without the rights of root.
TEST_F(state_file, read_only) {
  ASSERT_TRUE(open().save({{{variables, "#500", 1.0}}}));
  const auto refused = [&] {
    constexpr uid_t nobody = 65534;
    if (geteuid() == 0 && setuid(nobody) != 0) return 98;
    const std::string sentence = refusal();
    if (sentence != name() + " cannot be written: it is read-only") {
      std::fprintf(stderr, "%s\n", sentence.c_str());
      return 1;
    }
    return 0;
  };
  fs::permissions(path_, fs::perms(0444));
  fs::permissions(folder_, fs::perms(0555));
  EXPECT_EQ(in_child(refused), 0);
  fs::permissions(folder_, fs::perms(0755));
}

/// Returns the state after the n-th block of the kill test: all rows contain n, and a few rows appear and disappear.
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

// A kill at any moment leaves the state of the last block whose save has returned, or of the block that was being saved.
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
    if (kill_number % 10 == 0) {  // the creation of a new file is interrupted too
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
    kept = rows.empty() ? 0 : static_cast<int>(std::get<double>(rows[0].value) / 2);  // "#3901" is the first row
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
  EXPECT_EQ(refusal(offsets, "5/length", std::string("a")), "setup key 'offsets.5.length' must be a number, at most 10000000");
  EXPECT_EQ(refusal(offsets, "5", 1.0),
            "unknown setup key 'offsets.5.'; here stand length, length_wear, radius, radius_wear, corner_radius, corner_radius_wear, "
            "length_x, length_x_wear, length_y, length_y_wear, tip_position, X, X_wear, Y, Y_wear, Z, …");
  EXPECT_EQ(refusal(tool_table, "2/user/21", 1.0), "unknown setup key 'tool_table.2.user/21'; did you mean 'user'?");
  EXPECT_EQ(refusal(tool_table, "2/user/3", std::string("a")), "setup key 'tool_table.2.user' must be a list of numbers");
  EXPECT_EQ(refusal(variables, "500", 1.0), "setup key 'variables.500' must be named #n, #_NAME, or R0 to R9");
}

}  // namespace
}  // namespace kadr::state_file_test
