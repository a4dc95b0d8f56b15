// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;

/// An empty folder of this process alone.
class WriteWholeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::path(::testing::TempDir()) / ("stickslip_file_test_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  static std::string content(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  fs::path folder_;
};

TEST_F(WriteWholeFile, CreatesAndReplaces) {
  const std::string bytes("a\0b\r\n\xff", 6);
  write_whole_file(path("f"), bytes);
  EXPECT_EQ(content(path("f")), bytes);
  write_whole_file(path("f"), "");
  EXPECT_EQ(content(path("f")), "");
  EXPECT_EQ(entries(), 1);  // no temporary file stays
}

TEST_F(WriteWholeFile, NamesTheFileThatCannotBeWritten) {
  const std::string bad = path("no_such_folder/f");
  try {
    write_whole_file(bad, "text");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), bad);
    EXPECT_THAT(error.problem(), ::testing::HasSubstr("cannot be written"));
    EXPECT_FALSE(error.remedy().empty());
  }
  EXPECT_EQ(entries(), 0);
}

TEST_F(WriteWholeFile, ADirectoryIsNotReplaced) {
  fs::create_directory(path("d"));
  EXPECT_THROW(write_whole_file(path("d"), "text"), InputError);
  EXPECT_TRUE(fs::is_directory(path("d")));
  EXPECT_EQ(entries(), 1);
}

TEST_F(WriteWholeFile, WritesIntoADevice) {
  EXPECT_NO_THROW(write_whole_file("/dev/null", "x"));
}

TEST_F(WriteWholeFile, DashIsStandardOutput) {
  ::testing::internal::CaptureStdout();
  write_whole_file("-", "out");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "out");
}

}  // namespace
}  // namespace stickslip
