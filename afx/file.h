// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Files in and out: whole files as bytes, and outputs that are there whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// A file as read-only bytes. A regular file is mapped into memory and costs only what is touched;
/// pipes, devices and standard input ("-") are read whole. The file must not shrink while it is
/// open.
class MappedFile {
 public:
  /// Opens `path`; "-" is standard input.
  /// Errors  io: cannot be opened or read, or is a folder (the text has the system's reason);
  ///         limit_exceeded: more than limits.file_bytes, or, where it is read whole, than
  ///         limits.memory; no_memory
  static Result<MappedFile> open(const std::string& path, const Limits& limits = {});

  /// Opens a file that a document names: "-" is a file's name like any other, and what is no
  /// regular file (a pipe that would wait, a device without end) is refused. Errors  io: as open(),
  /// or is not a regular file; limit_exceeded; no_memory
  static Result<MappedFile> open_regular(const std::string& path, const Limits& limits = {});

  /// Bytes at hand, for what takes a file.
  static MappedFile in_memory(std::vector<uint8_t> bytes);

  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  ~MappedFile();

  /// Valid as long as this object.
  [[nodiscard]] std::span<const uint8_t> bytes() const { return bytes_; }

  /// Lets the first `bytes` bytes go from this process's memory, as far as they are whole pages of
  /// a mapping. They stay readable and come back when they are read.
  void let_go(size_t bytes) const;

 private:
  MappedFile() = default;
  static Result<MappedFile> map(int fd, const std::string& path, bool whole, const Limits& limits);
  void release();

  std::span<const uint8_t> bytes_;
  bool mapped_ = false;  ///< bytes_ is a mapping; otherwise it lies in read_
  std::vector<uint8_t> read_;
};

/// The outputs of one command: put each in, then commit them together. Nothing is seen under its
/// own name before commit(), except what goes to a pipe, a device or standard output ("-"), which
/// is written at once by commit(). What was not committed is removed when this object ends, and by
/// remove_temporary_files().
class OutputFiles {
 public:
  /// overwrite   whether an existing file may be replaced; without it that is an error
  explicit OutputFiles(bool overwrite = false);
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Whether put() may write there, without touching anything: for asking before the long work.
  /// Errors  io: exists already, is a folder, its folder is not there or cannot be written to
  [[nodiscard]] Status check(const std::string& path) const;

  /// Writes `bytes` under a temporary name beside `path`. A symbolic link keeps being one: the file
  /// it points to is replaced, or made where it is not there. An existing file's permissions are
  /// kept. Errors  io: as check(), or cannot be written; bad_argument: `path` was put in before
  Status put(const std::string& path, std::span<const uint8_t> bytes);

  /// Takes the bytes of an output piece by piece; good until commit() or the end of this object.
  using Sink = std::function<Status(std::span<const uint8_t> piece)>;
  /// Begins an output whose bytes come piece by piece, otherwise as put(). What goes to a pipe is
  /// kept in memory until commit(). Errors  as put(); the sink's: io
  Result<Sink> begin(const std::string& path);

  /// Gives all outputs their names. If one of them cannot have it, those before are taken back and
  /// what stood there is put back (where the file system can exchange names; otherwise they stay).
  /// Errors  io
  Status commit();

 private:
  struct Output;
  bool overwrite_;
  std::vector<std::unique_ptr<Output>> outputs_;
};

/// The folder that a path leads into: what stands in front of its last slash; "." without one.
std::string folder_of(const std::string& path);

/// One output alone: put and commit. "-" is standard output.
/// Errors  io: as OutputFiles
Status write_file_atomically(const std::string& path, std::span<const uint8_t> bytes,
                             bool overwrite);

/// Removes every temporary file that this process has under way. Async-signal-safe: made for the
/// handler of SIGINT and SIGTERM, which then ends the process with _exit.
void remove_temporary_files() noexcept;

}  // namespace afx
