// panel/panel_journal: what is kept of machines beyond the end of the server.

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
  for (std::size_t i = 0; i < PanelJournal::most_logged + 5; ++i) EXPECT_TRUE(journal.log("a.nc", std::to_string(i)));
  const auto log = journal.log_of("a.nc");
  ASSERT_EQ(log.size(), PanelJournal::most_logged);
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
