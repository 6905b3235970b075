// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "conformance/json_fields.h"
#include "conformance/suite.h"

namespace afx::conformance {

/// Reads `code` and `bit`, or `line` and `column`, of an object that may have more members.
Finding read_finding(JsonFields& in);

}  // namespace afx::conformance
