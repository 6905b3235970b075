// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>

#include "afx/file_test_folder.h"
#include "nodes/scene.h"
#include "nodes/scene_reader.h"

namespace afx {
namespace {

using ::testing::HasSubstr;

std::span<const uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

std::string text_of(const MappedFile& file) { return {file.bytes().begin(), file.bytes().end()}; }

TEST(MappedFile, HoldsTheBytesOfAFile) {
  const TestFolder folder;
  const auto file = MappedFile::open(folder.write("a", "hello"));
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(text_of(file.value()), "hello");
}

TEST(MappedFile, IsEmptyForAnEmptyFile) {
  const TestFolder folder;
  const auto file = MappedFile::open(folder.write("a", ""));
  ASSERT_TRUE(file.ok());
  EXPECT_TRUE(file.value().bytes().empty());
}

TEST(MappedFile, SurvivesBeingMoved) {
  const TestFolder folder;
  auto first = MappedFile::open(folder.write("a", "first"));
  auto second = MappedFile::open(folder.write("b", "second"));
  ASSERT_TRUE(first.ok() && second.ok());
  MappedFile moved = std::move(first).value();
  moved = std::move(second).value();
  EXPECT_EQ(text_of(moved), "second");
}

TEST(MappedFile, ReadsPipesWhole) {
  const TestFolder folder;
  const std::string path = folder.path("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const std::string text(200000, 'x');  // more than a pipe holds at once
  std::thread writer([&] {
    const int fd = ::open(path.c_str(), O_WRONLY);
    for (size_t at = 0; at < text.size();)
      at += static_cast<size_t>(::write(fd, text.data() + at, text.size() - at));
    ::close(fd);
  });
  const auto file = MappedFile::open(path);
  writer.join();
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(text_of(file.value()), text);
}

TEST(MappedFile, SaysWhyAFileCannotBeOpened) {
  const TestFolder folder;
  const auto missing = MappedFile::open(folder.path("no"));
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, Errc::io);
  EXPECT_EQ(missing.error().file, folder.path("no"));
  EXPECT_THAT(missing.error().text, HasSubstr("No such file"));
  const auto is_folder = MappedFile::open(folder.path(""));
  ASSERT_FALSE(is_folder.ok());
  EXPECT_THAT(is_folder.error().text, HasSubstr("is a folder"));
}

TEST(MappedFile, KeepsToTheLimit) {
  const TestFolder folder;
  Limits limits;
  limits.file_bytes = 4;
  EXPECT_TRUE(MappedFile::open(folder.write("a", "1234"), limits).ok());
  const auto file = MappedFile::open(folder.write("b", "12345"), limits);
  ASSERT_FALSE(file.ok());
  EXPECT_EQ(file.error().code, Errc::limit_exceeded);
  const auto endless = MappedFile::open("/dev/zero", limits);
  ASSERT_FALSE(endless.ok());
  EXPECT_EQ(endless.error().code, Errc::limit_exceeded);
}

TEST(MappedFile, KeepsWhatIsReadWholeToTheLimitOfMemory) {
  const auto endless = MappedFile::open("/dev/zero", {.memory = 100000});
  ASSERT_FALSE(endless.ok());
  EXPECT_EQ(endless.error().code, Errc::limit_exceeded);
  const TestFolder folder;  // a mapping costs no memory
  EXPECT_TRUE(MappedFile::open(folder.write("a", "12345"), {.memory = 4}).ok());
}

/// Bytes of files that are in this process's memory, from /proc/self/statm.
size_t resident_file_bytes() {
  std::ifstream file("/proc/self/statm");
  size_t size = 0, resident = 0, shared = 0;
  file >> size >> resident >> shared;
  return shared * static_cast<size_t>(::sysconf(_SC_PAGESIZE));
}

/// Reads a scene from a mapped text. Returns the most bytes of files that were seen in memory on
/// the way, beyond those before.
size_t peak_of_reading(const MappedFile& file, bool let_go, nodes::Scene& scene) {
  const size_t before = resident_file_bytes();
  size_t peak = before;
  nodes::SceneReadOptions options;
  options.passed = [&](size_t offset) {
    peak = std::max(peak, resident_file_bytes());
    if (let_go) file.let_go(offset);
  };
  Diagnostics diagnostics;
  const std::string_view text(reinterpret_cast<const char*>(file.bytes().data()),
                              file.bytes().size());
  auto read = nodes::read_scene_text(text, {}, diagnostics, options);
  EXPECT_TRUE(read.ok());
  if (read.ok()) scene = std::move(read).value();
  return peak - before;
}

TEST(MappedFile, WhatWasLetGoStaysReadable) {
  const TestFolder folder;
  const std::string text = std::string(100000, 'a') + "end";
  const auto file = MappedFile::open(folder.write("a", text));
  ASSERT_TRUE(file.ok());
  for (const size_t bytes : {size_t{0}, size_t{1}, size_t{5000}, text.size(), SIZE_MAX}) {
    file.value().let_go(bytes);
    EXPECT_EQ(text_of(file.value()), text);
  }
}

TEST(MappedFile, ALongTextIsReadWithLittleOfItInMemory) {
  constexpr size_t kMegabyte = size_t{1} << 20;
  std::string text = "OctreeImage { octree [";
  while (text.size() < 20 * kMegabyte) text += "200 7 31 255 ";
  text += "] }";
  const TestFolder folder;
  const auto file = MappedFile::open(folder.write("a", text));
  ASSERT_TRUE(file.ok());
  const auto small = MappedFile::open(folder.write("b", "OctreeImage { octree [200] }"));
  ASSERT_TRUE(small.ok());
  nodes::Scene first, kept, let_go;
  (void)peak_of_reading(small.value(), true, first);  // the program's own code is in memory then
  EXPECT_LT(peak_of_reading(file.value(), true, let_go), 8 * kMegabyte);
  EXPECT_GT(peak_of_reading(file.value(), false, kept), 16 * kMegabyte);
  EXPECT_TRUE(equal(kept, let_go));
}

TEST(MappedFile, OpenRegularTakesFilesOnlyAndWaitsForNothing) {
  const TestFolder folder;
  const auto file = MappedFile::open_regular(folder.write("a", "hello"));
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(text_of(file.value()), "hello");
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  for (const std::string& path : {folder.path("pipe"), std::string("/dev/zero")}) {
    const auto other = MappedFile::open_regular(path);
    ASSERT_FALSE(other.ok());
    EXPECT_EQ(other.error().code, Errc::io);
    EXPECT_EQ(other.error().text, "is not a regular file");
  }
  EXPECT_FALSE(MappedFile::open_regular(folder.path("")).ok());
  const auto dash = MappedFile::open_regular("-");  // not standard input
  ASSERT_FALSE(dash.ok());
  EXPECT_THAT(dash.error().text, HasSubstr("No such file"));
}

TEST(FolderOf, IsWhatStandsBeforeTheLastSlash) {
  EXPECT_EQ(folder_of("a/b/c"), "a/b");
  EXPECT_EQ(folder_of("c"), ".");
  EXPECT_EQ(folder_of("/c"), "/");
}

TEST(WriteFileAtomically, MakesTheFileThatADanglingLinkNames) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path("sub"));
  ASSERT_EQ(::symlink("sub/second", folder.path("first").c_str()), 0);
  ASSERT_EQ(::symlink("made", folder.path("sub/second").c_str()), 0);
  ASSERT_TRUE(write_file_atomically(folder.path("first"), bytes_of("text"), false).ok());
  EXPECT_EQ(folder.read("sub/made"), "text");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("first")));
  // Where the link's folder is not there, and where links go in a circle, check() says so.
  ASSERT_EQ(::symlink("no/where", folder.path("lost").c_str()), 0);
  ASSERT_EQ(::symlink("round", folder.path("round").c_str()), 0);
  EXPECT_FALSE(OutputFiles().check(folder.path("lost")).ok());
  EXPECT_FALSE(OutputFiles().check(folder.path("round")).ok());
}

TEST(WriteFileAtomically, ClosesItsFileWhereStandardOutputIsClosed) {
  const TestFolder folder;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::close(STDOUT_FILENO);  // so that the temporary file gets its number
    const bool written = write_file_atomically(folder.path("a"), bytes_of("text"), false).ok();
    ::_exit(written && ::fcntl(STDOUT_FILENO, F_GETFD) < 0 ? 0 : 1);
  }
  int state = 0;
  ASSERT_EQ(::waitpid(child, &state, 0), child);
  EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0);
  EXPECT_EQ(folder.read("a"), "text");
}

TEST(WriteFileAtomically, WritesANewFileAndNothingElse) {
  const TestFolder folder;
  ASSERT_TRUE(write_file_atomically(folder.path("a"), bytes_of("text"), false).ok());
  EXPECT_EQ(folder.read("a"), "text");
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFileAtomically, TouchesNoExistingFileUnlessTold) {
  const TestFolder folder;
  const std::string path = folder.write("a", "old");
  const Status status = write_file_atomically(path, bytes_of("new"), false);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, Errc::io);
  EXPECT_EQ(status.error().text, "exists already (use -f to overwrite)");
  EXPECT_EQ(status.error().file, path);
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_EQ(folder.count(), 1U);
  ASSERT_TRUE(write_file_atomically(path, bytes_of("new"), true).ok());
  EXPECT_EQ(folder.read("a"), "new");
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFileAtomically, KeepsPermissionsAndSymbolicLinks) {
  const TestFolder folder;
  const std::string path = folder.write("a", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  ASSERT_EQ(::symlink(path.c_str(), folder.path("link").c_str()), 0);
  ASSERT_TRUE(write_file_atomically(folder.path("link"), bytes_of("new"), true).ok());
  EXPECT_EQ(folder.read("a"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
  struct stat info {};
  ASSERT_EQ(::stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640U);
}

TEST(WriteFileAtomically, WritesToDevicesDirectly) {
  EXPECT_TRUE(write_file_atomically("/dev/null", bytes_of("text"), false).ok());
  const Status full = write_file_atomically("/dev/full", bytes_of("text"), false);
  ASSERT_FALSE(full.ok());
  EXPECT_THAT(full.error().text, HasSubstr("No space left"));
}

TEST(WriteFileAtomically, NamesTheFolderThatIsNotThere) {
  const TestFolder folder;
  const Status status = write_file_atomically(folder.path("no/a"), bytes_of("text"), false);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, Errc::io);
  EXPECT_EQ(status.error().file, folder.path("no/a"));
  EXPECT_FALSE(write_file_atomically(folder.path(""), bytes_of("text"), true).ok());
}

TEST(WriteFileAtomically, TakesTheLongestNames) {
  const TestFolder folder;
  const std::string name(255, 'n');
  ASSERT_TRUE(write_file_atomically(folder.path(name), bytes_of("text"), false).ok());
  EXPECT_EQ(folder.read(name), "text");
}

TEST(OutputFiles, AppearTogetherAtCommit) {
  const TestFolder folder;
  OutputFiles outputs;
  ASSERT_TRUE(outputs.put(folder.path("a"), bytes_of("1")).ok());
  ASSERT_TRUE(outputs.put(folder.path("b"), bytes_of("2")).ok());
  EXPECT_FALSE(folder.has("a"));
  ASSERT_TRUE(outputs.commit().ok());
  EXPECT_EQ(folder.read("a") + folder.read("b"), "12");
  EXPECT_EQ(folder.count(), 2U);
}

TEST(OutputFiles, LeaveNothingWithoutCommit) {
  const TestFolder folder;
  {
    OutputFiles outputs;
    ASSERT_TRUE(outputs.put(folder.path("a"), bytes_of("1")).ok());
    EXPECT_EQ(folder.count(), 1U);  // under another name
  }
  EXPECT_EQ(folder.count(), 0U);
}

TEST(OutputFiles, AreAllTakenBackIfOneFails) {
  const TestFolder folder;
  folder.write("replaced", "old");
  OutputFiles outputs(true);
  ASSERT_TRUE(outputs.put(folder.path("new"), bytes_of("1")).ok());
  ASSERT_TRUE(outputs.put(folder.path("replaced"), bytes_of("2")).ok());
  ASSERT_TRUE(outputs.put(folder.path("blocked"), bytes_of("3")).ok());
  std::filesystem::create_directory(folder.path("blocked"));
  folder.write("blocked/inside", "");  // so that no file can take its place
  EXPECT_FALSE(outputs.commit().ok());
  EXPECT_FALSE(folder.has("new"));
  EXPECT_EQ(folder.read("replaced"), "old");
  EXPECT_TRUE(std::filesystem::is_directory(folder.path("blocked")));
  EXPECT_EQ(folder.count(), 2U);
}

TEST(OutputFiles, SpareAFileThatAppearedMeanwhile) {
  const TestFolder folder;
  OutputFiles outputs;
  ASSERT_TRUE(outputs.put(folder.path("a"), bytes_of("ours")).ok());
  folder.write("a", "theirs");
  const Status status = outputs.commit();
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().text, HasSubstr("exists already"));
  EXPECT_EQ(folder.read("a"), "theirs");
  EXPECT_EQ(folder.count(), 1U);
}

TEST(OutputFiles, RefuseTheSameNameTwice) {
  const TestFolder folder;
  OutputFiles outputs;
  ASSERT_TRUE(outputs.put(folder.path("a"), bytes_of("1")).ok());
  for (const char* name : {"a", "./a"}) {
    const Status status = outputs.put(folder.path(name), bytes_of("2"));
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, Errc::bad_argument);
  }
}

extern "C" void remove_and_leave(int) {
  remove_temporary_files();
  ::_exit(130);
}

TEST(RemoveTemporaryFiles, LeavesNothingBehindWhenASignalEndsTheProcess) {
  const TestFolder folder;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::signal(SIGINT, remove_and_leave);
    OutputFiles outputs;
    const bool put = outputs.put(folder.path("a"), bytes_of("1")).ok() &&
                     outputs.put(folder.path("b"), bytes_of("2")).ok();
    if (put && folder.count() == 2) ::raise(SIGINT);
    ::_exit(1);
  }
  int state = 0;
  ASSERT_EQ(::waitpid(child, &state, 0), child);
  ASSERT_TRUE(WIFEXITED(state));
  EXPECT_EQ(WEXITSTATUS(state), 130);
  EXPECT_EQ(folder.count(), 0U);
}

TEST(RemoveTemporaryFiles, SparesWhatIsCommitted) {
  const TestFolder folder;
  OutputFiles kept, lost;
  ASSERT_TRUE(kept.put(folder.path("a"), bytes_of("1")).ok());
  ASSERT_TRUE(kept.commit().ok());
  ASSERT_TRUE(lost.put(folder.path("b"), bytes_of("2")).ok());
  remove_temporary_files();
  EXPECT_EQ(folder.count(), 1U);
  EXPECT_FALSE(lost.commit().ok());
  EXPECT_EQ(folder.read("a"), "1");
}

}  // namespace
}  // namespace afx
