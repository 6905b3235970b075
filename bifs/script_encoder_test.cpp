// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/script_encoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace afx::bifs {

using testing::HasSubstr;

TEST(ScriptEncoder, AStringWithAZeroByteIsRefusedForItsCodedFormWouldEndThere) {
  const std::string begin = "javascript: function f() {\n  a = 'x";
  size_t bits = 0;
  const auto count = [&](uint64_t, unsigned more) { bits += more; };
  EXPECT_TRUE(encode_script(begin + "y'; }", {}, count).ok());
  EXPECT_GT(bits, 0U);
  const Status refused = encode_script(begin + '\0' + "y'; }", {}, count);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Errc::unsupported);
  EXPECT_THAT(refused.error().text, HasSubstr("line 2:"));
  EXPECT_THAT(refused.error().text, HasSubstr("[expected a string without zero bytes"));
}

}  // namespace afx::bifs
