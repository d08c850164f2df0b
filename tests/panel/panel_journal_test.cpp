// panel/panel_journal: what is kept about machines after the server has ended.

#include "panel/panel_journal.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace kadr::panel_journal_test {
namespace {

namespace fs = std::filesystem;

class PanelJournalTest : public testing::Test {
 protected:
  PanelJournalTest() : folder_(fs::temp_directory_path() / ("kadr_journal_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~PanelJournalTest() override { fs::remove_all(folder_); }
  std::string path() const { return folder_ / "shop.state"; }

 private:
  fs::path folder_;
};

/// The file is deleted while the process runs. Everything written to it would
/// be lost, so nothing is confirmed, not even values that are known already.
TEST_F(PanelJournalTest, NoticesThatItsFileIsDeleted) {
  {
    const auto journal = PanelJournal::open(path());
    ASSERT_TRUE(journal) << journal.error();
    EXPECT_TRUE((*journal)->keep("spot", "a.nc", "here"));
    fs::remove(path());
    const auto kept = (*journal)->keep("spot", "a.nc", "there");
    ASSERT_FALSE(kept);
    EXPECT_NE(kept.error().find("deleted"), std::string::npos) << kept.error();
    EXPECT_FALSE((*journal)->keep("spot", "a.nc", "there"));
    EXPECT_FALSE((*journal)->log("a.nc", "entry"));
    EXPECT_EQ((*journal)->value("spot", "a.nc"), "there");
  }
  const auto next = PanelJournal::open(path());
  ASSERT_TRUE(next) << next.error();
  EXPECT_EQ((*next)->value("spot", "a.nc"), std::nullopt);
  EXPECT_TRUE((*next)->keep("spot", "a.nc", "anew"));
}

/// Another file of the same name does not belong to this journal and stays unchanged.
TEST_F(PanelJournalTest, NoticesThatItsFileIsReplaced) {
  {
    const auto journal = PanelJournal::open(path());
    ASSERT_TRUE(journal) << journal.error();
    EXPECT_TRUE((*journal)->keep("spot", "a.nc", "here"));
    for (const char* const part : {"", "-wal", "-shm"}) fs::remove(path() + part);
    const auto other = PanelJournal::open(path());
    ASSERT_TRUE(other) << other.error();
    EXPECT_TRUE((*other)->keep("spot", "a.nc", "of the other"));
    EXPECT_FALSE((*journal)->keep("spot", "a.nc", "there"));
    EXPECT_TRUE((*other)->keep("tables", "a.nc", "of the other too"));
  }
  const auto next = PanelJournal::open(path());
  ASSERT_TRUE(next) << next.error();
  EXPECT_EQ((*next)->value("spot", "a.nc"), "of the other");
  EXPECT_EQ((*next)->value("tables", "a.nc"), "of the other too");
}

/// The process was killed: its log remains and belongs to no file.
TEST_F(PanelJournalTest, BeginsAnewBesideALeftLog) {
  {
    const auto journal = PanelJournal::open(path());
    ASSERT_TRUE(journal) << journal.error();
    for (int i = 0; i < 20; ++i) EXPECT_TRUE((*journal)->keep("spot", "a.nc", std::to_string(i)));
    fs::copy_file(path() + "-wal", path() + ".kept");
  }
  fs::remove(path());
  fs::rename(path() + ".kept", path() + "-wal");
  {
    const auto next = PanelJournal::open(path());
    ASSERT_TRUE(next) << next.error();
    EXPECT_EQ((*next)->value("spot", "a.nc"), std::nullopt);
    EXPECT_TRUE((*next)->keep("spot", "a.nc", "anew"));
  }
  const auto again = PanelJournal::open(path());
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ((*again)->value("spot", "a.nc"), "anew");
}

TEST_F(PanelJournalTest, IsThereAgain) {
  {
    const auto journal = PanelJournal::open(path());
    ASSERT_TRUE(journal) << journal.error();
    EXPECT_TRUE((*journal)->lasts());
    EXPECT_TRUE((*journal)->keep("machine", "a/b:c.nc", "how"));
    EXPECT_TRUE((*journal)->keep("spot", "a/b:c.nc", "there"));
    EXPECT_TRUE((*journal)->keep("spot", "a/b:c.nc", "elsewhere"));
    EXPECT_TRUE((*journal)->keep("machine", "other.nc", "so"));
    for (int i = 1; i <= 12; ++i) EXPECT_TRUE((*journal)->log("a/b:c.nc", "entry " + std::to_string(i)));
    EXPECT_FALSE(PanelJournal::open(path())) << "one process at a time";
  }
  const auto journal = PanelJournal::open(path());
  ASSERT_TRUE(journal) << journal.error();
  EXPECT_EQ((*journal)->value("spot", "a/b:c.nc"), "elsewhere");
  EXPECT_EQ((*journal)->value("tables", "a/b:c.nc"), std::nullopt);
  EXPECT_EQ((*journal)->machines(), (std::vector<std::string>{"a/b:c.nc", "other.nc"}));
  const auto log = (*journal)->log_of("a/b:c.nc");
  ASSERT_EQ(log.size(), 12u);
  EXPECT_EQ(log[1], "entry 2") << "in their order, not in that of their names";
  EXPECT_EQ(log[11], "entry 12");
  EXPECT_TRUE((*journal)->forget("a/b:c.nc"));
  EXPECT_EQ((*journal)->machines(), (std::vector<std::string>{"other.nc"}));
  EXPECT_EQ((*journal)->log_of("a/b:c.nc").size(), 12u);
}

TEST_F(PanelJournalTest, TheOldestEntriesGo) {
  PanelJournal journal;
  EXPECT_FALSE(journal.lasts());
  for (std::size_t i = 0; i < PanelJournal::max_logged + 5; ++i) EXPECT_TRUE(journal.log("a.nc", std::to_string(i)));
  const auto log = journal.log_of("a.nc");
  ASSERT_EQ(log.size(), PanelJournal::max_logged);
  EXPECT_EQ(log.front(), "5");
}

TEST_F(PanelJournalTest, AFileThatIsNoneIsRefusedAndLeft) {
  std::ofstream(path()) << "G0 X0\n";
  const auto journal = PanelJournal::open(path());
  EXPECT_FALSE(journal);
  EXPECT_EQ(fs::file_size(path()), 6u);
  EXPECT_FALSE(PanelJournal::open("/nowhere/shop.state"));
}

}  // namespace
}  // namespace kadr::panel_journal_test
