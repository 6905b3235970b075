// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Runs a fuzz target as an ordinary test, where there is no libFuzzer: over every file of the
// folders given, every truncation of the small ones, and random corruptions of all from a fixed
// seed. An input on which the target aborts is left in failed_input.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

using Bytes = std::vector<uint8_t>;

std::vector<Bytes> read_corpus(int count, char** folders) {
  std::vector<std::filesystem::path> paths;
  for (int i = 0; i < count; ++i) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folders[i])) {
      if (entry.is_regular_file()) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> corpus;
  for (const auto& path : paths) {
    std::ifstream in(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return corpus;
}

const Bytes* g_input = nullptr;

extern "C" void keep_input(int /*signal*/) {
  const int file = open("failed_input", O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const ssize_t written = write(file, g_input->data(), g_input->size());
  (void)written;
}

/// A copy of its exact size each time, so that a sanitizer sees one byte too far.
void run(const Bytes& data) {
  const Bytes copy(data.begin(), data.end());
  g_input = &copy;
  LLVMFuzzerTestOneInput(copy.data(), copy.size());
}

void corrupt(Bytes& data, std::mt19937& random) {
  const auto changes = 1 + random() % 4;
  for (unsigned i = 0; i < changes && !data.empty(); ++i) {
    const size_t at = random() % data.size();
    switch (random() % 5) {
      case 0:
        data[at] = static_cast<uint8_t>(data[at] ^ 1U << random() % 8);
        break;
      case 1:
        data[at] = static_cast<uint8_t>(random());
        break;
      case 2:
        data.erase(data.begin() + static_cast<ptrdiff_t>(at));
        break;
      case 3:
        data.insert(data.begin() + static_cast<ptrdiff_t>(at), static_cast<uint8_t>(random()));
        break;
      default:
        data.resize(at);
        break;
    }
  }
}

/// AFX_FUZZ_RUNS, a plain number; false: it is something else.
bool read_runs(size_t& runs) {
  const char* wanted = std::getenv("AFX_FUZZ_RUNS");
  if (wanted == nullptr) return true;
  const char* end = wanted + std::strlen(wanted);
  const auto parsed = std::from_chars(wanted, end, runs);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

}  // namespace

int main(int argc, char** argv) {
  size_t corruptions = 100000;
  if (!read_runs(corruptions)) {
    std::fprintf(stderr, "AFX_FUZZ_RUNS is no number\n");
    return 1;
  }
  const std::vector<Bytes> corpus = read_corpus(argc - 1, argv + 1);
  if (corpus.empty()) {
    std::fprintf(stderr, "no corpus files: nothing was tested\n");
    return 1;
  }
  std::signal(SIGABRT, keep_input);
  size_t runs = 0;
  for (const Bytes& data : corpus) {
    run(data);
    ++runs;
    for (size_t size = 0; size < data.size() && data.size() <= 400; ++size, ++runs) {
      run(Bytes(data.begin(), data.begin() + static_cast<ptrdiff_t>(size)));
    }
  }
  std::mt19937 random(1);
  for (size_t i = 0; i < corruptions; ++i, ++runs) {
    Bytes data = corpus[random() % corpus.size()];
    corrupt(data, random);
    run(data);
  }
  std::printf("%zu inputs from %zu files\n", runs, corpus.size());
  return 0;
}
