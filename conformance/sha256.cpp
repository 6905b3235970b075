// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/sha256.h"

#include <sha2.h>
#include <sys/types.h>

namespace afx::conformance {

std::string sha256(std::span<const uint8_t> bytes) {
  char digits[SHA256_DIGEST_STRING_LENGTH];
  return SHA256Data(bytes.data(), bytes.size(), digits);
}

}  // namespace afx::conformance
