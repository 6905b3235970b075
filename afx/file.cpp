// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

namespace afx {
namespace {

Error io_error(const std::string& path, const std::string& what, int reason) {
  Error error{Errc::io, {}, what, {}, path};
  if (reason != 0) error.text += ": " + std::generic_category().message(reason);
  return error;
}

// A file descriptor that closes itself if it is ours. Its number does not tell: where standard
// output is closed, the next file opened gets that number.
class Descriptor {
 public:
  enum class Owner : bool { us, others };
  explicit Descriptor(int fd, Owner owner = Owner::us) : fd_(fd), owner_(owner) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { static_cast<void>(close()); }
  [[nodiscard]] int get() const { return fd_; }
  // Closing may report what writing did not.
  int close() {
    const int fd = std::exchange(fd_, -1);
    return fd >= 0 && owner_ == Owner::us && ::close(fd) != 0 ? errno : 0;
  }

 private:
  int fd_;
  Owner owner_;
};

Descriptor open_file(const std::string& path, int standard, int flags) {
  if (path == "-") return Descriptor(standard, Descriptor::Owner::others);
  return Descriptor(::open(path.c_str(), flags | O_CLOEXEC | O_NOCTTY));
}

Status read_all(int fd, const std::string& path, uint64_t limit, std::vector<uint8_t>& out) {
  constexpr size_t kStep = size_t{1} << 16;
  size_t size = 0;
  limit = std::min<uint64_t>(limit, std::numeric_limits<size_t>::max() / 2);
  try {
    while (true) {
      if (out.size() - size < kStep)
        out.resize(std::min<size_t>(std::max(out.size() * 2, size + kStep), limit + 2 * kStep));
      const ssize_t got = ::read(fd, out.data() + size, out.size() - size);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return io_error(path, "cannot be read", errno);
      if (got == 0) break;
      size += static_cast<size_t>(got);
      if (size > limit)
        return Error{Errc::limit_exceeded, {}, "is larger than the limit for files", {}, path};
    }
    out.resize(size);
  } catch (const std::bad_alloc&) {
    return Error{Errc::no_memory, {}, "does not fit into memory", {}, path};
  }
  return {};
}

Status write_all(int fd, const std::string& path, std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(fd, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return io_error(path, "cannot be written", errno);
    bytes = bytes.subspan(static_cast<size_t>(put));
  }
  return {};
}

// The temporary names under way, for a signal handler: a list that only grows, whose cells are used
// again. A handler that walks it at any moment sees whole cells only.
struct TemporaryName {
  std::atomic<bool> taken{false};   // by a TemporaryFile
  std::atomic<bool> active{false};  // `path` is complete and may be removed
  char path[PATH_MAX] = {};
  TemporaryName* next = nullptr;
};

std::atomic<TemporaryName*> temporary_names{nullptr};  // never freed: a handler may be reading it

TemporaryName* take_temporary_name(const std::string& path) {
  if (path.size() >= PATH_MAX) return nullptr;
  TemporaryName* cell = temporary_names.load();
  while (cell != nullptr && cell->taken.exchange(true)) cell = cell->next;
  if (cell == nullptr) {
    cell = new (std::nothrow) TemporaryName;
    if (cell == nullptr) return nullptr;
    cell->taken = true;
    cell->next = temporary_names.load();
    while (!temporary_names.compare_exchange_weak(cell->next, cell)) {
    }
  }
  std::memcpy(cell->path, path.c_str(), path.size() + 1);
  cell->active = true;
  return cell;
}

void release_temporary_name(TemporaryName* cell) {
  cell->active = false;
  cell->taken = false;
}

std::string name_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

// A hidden name beside `path`. Long names are cut so that the new one is not too long for the
// system.
std::string temporary_name_for(const std::string& path) {
  static std::atomic<unsigned> counter{0};
  const std::string base = name_of(path);
  return folder_of(path) + "/." + base.substr(0, 100) + "." + std::to_string(::getpid()) + "-" +
         std::to_string(counter++) + ".tmp";
}

// The path without links, or nothing if it leads nowhere.
std::string real_path(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return {};
  std::string result = real;
  std::free(real);
  return result;
}

// What a symbolic link says, or nothing if it is none.
std::string link_target(const std::string& path) {
  char target[PATH_MAX];
  const ssize_t length = ::readlink(path.c_str(), target, sizeof target);
  return length > 0 ? std::string(target, static_cast<size_t>(length)) : std::string();
}

// Where a path leads in the end, whether there is a file or one is still to be made.
std::string resolved(const std::string& path) {
  constexpr int kMostLinks = 40;  // as many as the system follows
  std::string at = path;
  for (int link = 0; link < kMostLinks; ++link) {
    if (std::string real = real_path(at); !real.empty()) return real;
    const std::string target = link_target(at);
    if (target.empty()) break;
    at = target[0] == '/' ? target : folder_of(at) + "/" + target;
  }
  const std::string folder = real_path(folder_of(at));
  return folder.empty() ? at : (folder == "/" ? "" : folder) + "/" + name_of(at);
}

// What a path is now.
struct Target {
  bool exists = false;
  bool regular = true;  // or not there: then it will be
  mode_t mode = 0666;
};

Result<Target> look_at(const std::string& path) {
  if (path == "-") return Target{true, false, 0};
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) {
    if (errno == ENOENT) return Target{};
    return io_error(path, "cannot be written", errno);
  }
  if (S_ISDIR(info.st_mode)) return io_error(path, "is a folder (expected a file to write)", 0);
  return Target{true, S_ISREG(info.st_mode), info.st_mode & 07777};
}

// Keeps SIGINT and its like waiting while files get their names one by one.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t held;
    ::sigemptyset(&held);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&held, signal);
    ::pthread_sigmask(SIG_BLOCK, &held, &before_);
  }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
  ~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

Status write_directly(const std::string& path, std::span<const uint8_t> bytes) {
  Descriptor file = open_file(path, STDOUT_FILENO, O_WRONLY);
  if (file.get() < 0) return io_error(path, "cannot be written", errno);
  if (Status status = write_all(file.get(), path, bytes); !status.ok()) return status;
  if (const int reason = file.close(); reason != 0)
    return io_error(path, "cannot be written", reason);
  return {};
}

}  // namespace

Result<MappedFile> MappedFile::open(const std::string& path, const Limits& limits) {
  const Descriptor file = open_file(path, STDIN_FILENO, O_RDONLY);
  if (file.get() < 0) return io_error(path, "cannot be opened", errno);
  return map(file.get(), path, path != "-", limits);
}

Result<MappedFile> MappedFile::open_regular(const std::string& path, const Limits& limits) {
  // Without O_NONBLOCK, opening a pipe waits until someone writes.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (file.get() < 0) return io_error(path, "cannot be opened", errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return io_error(path, "cannot be opened", errno);
  if (!S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode))
    return io_error(path, "is not a regular file", 0);
  return map(file.get(), path, true, limits);
}

// whole   from its beginning: it may be mapped
Result<MappedFile> MappedFile::map(int fd, const std::string& path, bool whole,
                                   const Limits& limits) {
  struct stat info {};
  if (::fstat(fd, &info) != 0) return io_error(path, "cannot be opened", errno);
  if (S_ISDIR(info.st_mode)) return io_error(path, "is a folder (expected a file)", 0);
  MappedFile result;
  whole = whole && S_ISREG(info.st_mode);
  if (whole && static_cast<uint64_t>(info.st_size) > limits.file_bytes)
    return Error{Errc::limit_exceeded, {}, "is larger than the limit for files", {}, path};
  if (whole && info.st_size > 0) {
    const auto size = static_cast<size_t>(info.st_size);
    void* data = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (data != MAP_FAILED) {
      result.bytes_ = {static_cast<const uint8_t*>(data), size};
      result.mapped_ = true;
      return result;
    }
  }
  // Files of /proc have size 0 and content all the same: those are read too.
  const uint64_t most = std::min(limits.file_bytes, limits.memory);
  if (Status status = read_all(fd, path, most, result.read_); !status.ok()) return status.error();
  result.bytes_ = result.read_;
  return result;
}

MappedFile MappedFile::in_memory(std::vector<uint8_t> bytes) {
  MappedFile result;
  result.read_ = std::move(bytes);
  result.bytes_ = result.read_;
  return result;
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : bytes_(std::exchange(other.bytes_, {})),
      mapped_(std::exchange(other.mapped_, false)),
      read_(std::move(other.read_)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  if (this == &other) return *this;
  release();
  bytes_ = std::exchange(other.bytes_, {});
  mapped_ = std::exchange(other.mapped_, false);
  read_ = std::move(other.read_);
  return *this;
}

MappedFile::~MappedFile() { release(); }

void MappedFile::let_go(size_t bytes) const {
  if (!mapped_) return;
  static const auto kPageBytes = static_cast<size_t>(::sysconf(_SC_PAGESIZE));
  const size_t pages = std::min(bytes, bytes_.size()) / kPageBytes;
  // A hint: what the system does with it cannot be wrong. madvise takes the address as mmap gave
  // it.
  if (pages > 0)
    (void)::madvise(const_cast<uint8_t*>(bytes_.data()), pages * kPageBytes, MADV_DONTNEED);
}

void MappedFile::release() {
  // munmap takes the address as it was given; nothing is written through it.
  if (mapped_) ::munmap(const_cast<uint8_t*>(bytes_.data()), bytes_.size());
  mapped_ = false;
}

struct OutputFiles::Output {
  std::string path;                  // as the caller named it
  std::string real;                  // where it goes
  std::string temporary;             // empty: written directly
  TemporaryName* name = nullptr;     // of `temporary`
  std::unique_ptr<Descriptor> file;  // of `temporary`, while it is written
  std::vector<uint8_t> direct;       // what commit() writes to a pipe or device
  // exchanged: the old file has the temporary name; replaced: the old file is gone
  enum class State { waiting, named, exchanged, replaced } state = State::waiting;

  Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  // Removes what is left under the temporary name: what was not committed, or what was replaced.
  ~Output() {
    if (name == nullptr) return;
    if (state == State::waiting || state == State::exchanged) ::unlink(temporary.c_str());
    release_temporary_name(name);
  }

  Status open_temporary(const Target& target);
  Status append(std::span<const uint8_t> piece);
  Status close();
  Status give_name(bool overwrite);
  void take_back();
};

Status OutputFiles::Output::open_temporary(const Target& target) {
  int fd = -1;
  do {  // a name left over by another process with our number: take the next
    if (name != nullptr) release_temporary_name(name);
    temporary = temporary_name_for(real);
    name = take_temporary_name(temporary);  // before the file exists, so that a signal finds it
    if (name == nullptr) return io_error(path, "cannot be written", ENAMETOOLONG);
    fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (fd < 0 && errno == EEXIST);
  if (fd < 0) {
    const int reason = errno;
    release_temporary_name(std::exchange(name, nullptr));
    return io_error(path, "cannot be written", reason);
  }
  file = std::make_unique<Descriptor>(fd);
  if (target.exists) static_cast<void>(::fchmod(fd, target.mode));  // as good as it gets
  return {};
}

Status OutputFiles::Output::append(std::span<const uint8_t> piece) {
  if (file != nullptr) return write_all(file->get(), path, piece);
  direct.insert(direct.end(), piece.begin(), piece.end());
  return {};
}

Status OutputFiles::Output::close() {
  const int reason = file != nullptr ? file->close() : 0;
  file.reset();
  if (reason != 0) return io_error(path, "cannot be written", reason);
  return {};
}

Status OutputFiles::Output::give_name(bool overwrite) {
  const auto rename_with = [this](unsigned flags) {
    return ::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, real.c_str(), flags) == 0;
  };
  if (rename_with(RENAME_NOREPLACE)) {
    state = State::named;
    return {};
  }
  if (errno == EEXIST && !overwrite)
    return io_error(path, "exists already (use -f to overwrite)", 0);
  struct stat info {};  // a folder that appeared meanwhile could be exchanged too
  if (::lstat(real.c_str(), &info) == 0 && S_ISDIR(info.st_mode))
    return io_error(path, "cannot be written", EISDIR);
  if (rename_with(RENAME_EXCHANGE)) {
    state = State::exchanged;
    return {};
  }
  // A file system without these flags: the plain call, asked to spare what is there as well as it
  // can.
  if (!overwrite && ::access(real.c_str(), F_OK) == 0)
    return io_error(path, "exists already (use -f to overwrite)", 0);
  if (::rename(temporary.c_str(), real.c_str()) != 0)
    return io_error(path, "cannot be written", errno);
  state = overwrite ? State::replaced : State::named;
  return {};
}

void OutputFiles::Output::take_back() {
  if (state == State::named) ::unlink(real.c_str());
  if (state == State::exchanged)
    ::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, real.c_str(), RENAME_EXCHANGE);
}

OutputFiles::OutputFiles(bool overwrite) : overwrite_(overwrite) {}
OutputFiles::~OutputFiles() = default;

Status OutputFiles::check(const std::string& path) const {
  const Result<Target> target = look_at(path);
  if (!target.ok()) return target.error();
  if (!target.value().regular) return {};
  if (target.value().exists && !overwrite_)
    return io_error(path, "exists already (use -f to overwrite)", 0);
  const std::string folder = folder_of(resolved(path));
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return io_error(path, "cannot be written (its folder)", errno);
  return {};
}

Result<OutputFiles::Sink> OutputFiles::begin(const std::string& path) {
  if (Status status = check(path); !status.ok()) return status.error();
  const Result<Target> target = look_at(path);
  if (!target.ok()) return target.error();
  auto output = std::make_unique<Output>();
  output->path = path;
  output->real = path == "-" ? path : resolved(path);
  for (const auto& other : outputs_)
    if (other->real == output->real)
      return Error{Errc::bad_argument, {}, "is named twice as an output", {}, path};
  if (target.value().regular)
    if (Status status = output->open_temporary(target.value()); !status.ok()) return status.error();
  Output* const begun = output.get();
  outputs_.push_back(std::move(output));
  return Sink([begun](std::span<const uint8_t> piece) { return begun->append(piece); });
}

Status OutputFiles::put(const std::string& path, std::span<const uint8_t> bytes) {
  Result<Sink> sink = begin(path);
  if (!sink.ok()) return sink.error();
  Status status = sink.value()(bytes);
  if (status.ok()) status = outputs_.back()->close();
  if (!status.ok()) outputs_.pop_back();
  return status;
}

Status OutputFiles::commit() {
  const SignalsHeld held;
  Status status;
  for (const auto& output : outputs_)
    if (status.ok()) status = output->close();
  size_t named = 0;
  for (; named < outputs_.size() && status.ok(); ++named)
    if (!outputs_[named]->temporary.empty()) status = outputs_[named]->give_name(overwrite_);
  // What went to a pipe cannot be taken back, so it goes last.
  for (const auto& output : outputs_)
    if (status.ok() && output->temporary.empty())
      status = write_directly(output->path, output->direct);
  if (!status.ok())
    for (const auto& output : outputs_) output->take_back();
  outputs_.clear();
  return status;
}

std::string folder_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

Status write_file_atomically(const std::string& path, std::span<const uint8_t> bytes,
                             bool overwrite) {
  OutputFiles outputs(overwrite);
  if (Status status = outputs.put(path, bytes); !status.ok()) return status;
  return outputs.commit();
}

void remove_temporary_files() noexcept {
  const int kept = errno;
  for (TemporaryName* cell = temporary_names.load(); cell != nullptr; cell = cell->next)
    if (cell->active) ::unlink(cell->path);
  errno = kept;
}

}  // namespace afx
