// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/FileAside.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace flattening;
using namespace flattening::pattern;
namespace fs = std::filesystem;

namespace
{
/// A folder of its own for each test.
class FileAsideTest : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::temp_directory_path() / (std::string("file aside ") + test->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  std::string path(const std::string& name) const { return (this->Folder / name).string(); }
  auto files() const
  {
    return std::distance(fs::directory_iterator(this->Folder), fs::directory_iterator());
  }

  fs::path Folder;
};
}

TEST_F(FileAsideTest, ReplacesAFileOnlyWhenItIsPublishedAndElseLeavesNothing)
{
  const auto read = [this] {
    std::ifstream file(this->path("a.svg"));
    return std::string{ std::istreambuf_iterator<char>(file), {} };
  };
  for (const bool published : { false, true })
  {
    std::ofstream(this->path("a.svg")) << "old";
    {
      FileAside file(this->path("a.svg"));
      ASSERT_TRUE(file.write("new").ok());
      EXPECT_EQ(read(), "old");
      ASSERT_TRUE(!published || file.publish().ok());
    }
    EXPECT_EQ(read(), published ? "new" : "old");
    EXPECT_EQ(this->files(), 1);
  }
}

TEST_F(FileAsideTest, SaysWhatCannotBeWritten)
{
  const Status noFolder = FileAside(this->path("missing/a.svg")).write("x");
  EXPECT_EQ(noFolder.code, StatusCode::FileNotWritten);
  EXPECT_NE(noFolder.message.find("missing/a.svg"), std::string::npos);

  fs::create_directories(this->path("taken"));
  FileAside taken(this->path("taken"));
  ASSERT_TRUE(taken.write("x").ok());
  EXPECT_EQ(taken.publish().code, StatusCode::FileNotWritten);
  EXPECT_TRUE(fs::is_directory(this->path("taken")));
}

TEST_F(FileAsideTest, NoticesAFullDisk)
{
  std::error_code error;
  if (!fs::exists("/dev/full", error))
  {
    GTEST_SKIP() << "no /dev/full here";
  }
  // The file aside is a link to a device on which every write fails.
  const FileAside file(this->path("a.svg"));
  fs::create_symlink("/dev/full", file.aside());
  EXPECT_EQ(file.write(std::string(100000, 'x')).code, StatusCode::FileNotWritten);
}
