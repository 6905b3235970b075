// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstddef>
#include <functional>

namespace afx {

/// The number of threads to use for `wanted`: 0 means all cores.
unsigned thread_count(unsigned wanted);

/// Calls task(i) once for each i in [0, count), on up to `threads` threads (0 = all cores), the
/// caller's among them, and returns when all are done. Which thread runs which i is open, so tasks
/// write only to places of their own; then the result is the same for any number of threads. Where
/// the system gives fewer threads, those there are do the work. What a task throws (there is no
/// memory, say) ends the work and is thrown again here.
void parallel_for(size_t count, unsigned threads, const std::function<void(size_t)>& task);

}  // namespace afx
