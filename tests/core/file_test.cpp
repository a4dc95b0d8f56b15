// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

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

TEST_F(WriteWholeFile, FollowsLinks) {
  write_whole_file(path("real"), "old");
  fs::create_symlink("real", path("near"));
  fs::create_directory(path("folder"));
  fs::create_symlink("../near", path("folder/far"));
  write_whole_file(path("folder/far"), "new");
  EXPECT_EQ(content(path("real")), "new");
  EXPECT_TRUE(fs::is_symlink(path("near")));
  EXPECT_TRUE(fs::is_symlink(path("folder/far")));

  fs::create_symlink(path("not_yet"), path("absolute"));
  write_whole_file(path("absolute"), "made");
  EXPECT_EQ(content(path("not_yet")), "made");
  EXPECT_TRUE(fs::is_symlink(path("absolute")));
  EXPECT_EQ(entries(), 5);
}

TEST_F(WriteWholeFile, LinksThatLeadNowhere) {
  fs::create_symlink("b", path("a"));
  fs::create_symlink("a", path("b"));
  EXPECT_THROW(write_whole_file(path("a"), "text"), InputError);
  fs::create_symlink("no_such_folder/f", path("c"));
  EXPECT_THROW(write_whole_file(path("c"), "text"), InputError);
  EXPECT_EQ(entries(), 3);
}

TEST_F(WriteWholeFile, KeepsPermissions) {
  const auto mode = [&](const char* name) { return fs::status(path(name)).permissions(); };
  const mode_t mask = ::umask(027);
  write_whole_file(path("new"), "text");
  ::umask(mask);
  EXPECT_EQ(mode("new"), static_cast<fs::perms>(0640));
  for (const unsigned kept : {0600U, 0666U, 0755U, 0440U}) {
    fs::permissions(path("new"), static_cast<fs::perms>(kept));
    write_whole_file(path("new"), std::to_string(kept));
    EXPECT_EQ(mode("new"), static_cast<fs::perms>(kept));
    EXPECT_EQ(content(path("new")), std::to_string(kept));
  }
}

TEST_F(WriteWholeFile, ManyThreadsAtOnce) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([this, i] {
      for (int k = 0; k < 50; ++k) {
        write_whole_file(path("same"), std::string(100, static_cast<char>('a' + i)));
        write_whole_file(path(std::to_string(i).c_str()), std::to_string(k));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::string same = content(path("same"));
  EXPECT_EQ(same, std::string(100, same.at(0)));
  for (int i = 0; i < 8; ++i) EXPECT_EQ(content(path(std::to_string(i).c_str())), "49");
  EXPECT_EQ(entries(), 9);
}

// In a process of its own: what is stopped stays so.
TEST_F(WriteWholeFile, StoppedWhenTheOthersAreDone) {
  const std::string file = path("f");
  EXPECT_EXIT(
      {
        std::atomic<bool> begun{false};
        std::thread writer([&] {
          const FileWrite both;
          begun = true;
          write_whole_file(file, "one");
          std::this_thread::sleep_for(std::chrono::milliseconds(50));
          write_whole_file(file, "two");
        });
        while (!begun) std::this_thread::yield();
        stop_file_writes(std::chrono::seconds(100));
        std::thread([&] { write_whole_file(file, "never"); }).detach();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        std::_Exit(content(file) == "two" ? 7 : 1);
      },
      ::testing::ExitedWithCode(7), "");
  EXPECT_EQ(content(file), "two");
  EXPECT_EQ(entries(), 1);
}

// In a process of its own as well.
TEST_F(WriteWholeFile, InputsAreProtectedOnRequest) {
  const std::string file = path("f");
  const auto is_written = [&](const std::string& text) {
    try {
      write_whole_file(file, text);
    } catch (const InputError&) {
      return false;
    }
    return true;
  };
  EXPECT_EXIT(
      {
        bool good = is_written("a library may write what it read");
        good = good && InputFile(file, "").stream().get() == 'a' && is_written("again");
        protect_inputs();
        good = good && is_written("not read yet");
        good = good && InputFile(file, "").stream().get() == 'n' && !is_written("read");
        std::_Exit(good ? 7 : 1);
      },
      ::testing::ExitedWithCode(7), "");
  EXPECT_EQ(content(file), "not read yet");
}

TEST(Temporaries, AreRecognisedByTheirNames) {
  EXPECT_EQ(target_of_temporary("line-3.json.123-0.tmp"), "line-3.json");
  for (const char* name : {"line-3.json", "line-3.json.tmp", ".1-2.tmp", "a.1-.tmp",
                           "a.1-2.tmp~", "a.-1-2.tmp", "a.1-2tmp", "a1-2.tmp", "tmp", ""}) {
    EXPECT_EQ(target_of_temporary(name), "") << name;
  }
}

TEST(NumberedNames, HaveDigitsBetweenTwoTexts) {
  EXPECT_TRUE(is_numbered("line-3.json", "line-", ".json"));
  EXPECT_TRUE(is_numbered("line-0123456789.json", "line-", ".json"));
  for (const char* name : {"line-.json", "line-3.jso", "line-3.json~", "xline-3.json", "ine-3.json",
                           "line-3a.json", "line-a3.json", "line--3.json", "3.json", ".json", "3", ""}) {
    EXPECT_FALSE(is_numbered(name, "line-", ".json")) << name;
  }
}

}  // namespace
}  // namespace stickslip
