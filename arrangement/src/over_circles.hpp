// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A loop over the circles of an arrangement on several threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace stickslip {

/// Calls work(scratch, i) for i < count, where each thread has a scratch of its own, made by
/// make(). Then calls finish(scratch) for each of them, on this thread and in no particular
/// order: what it does must commute. `threads` = 0 takes all that the machine has, and with 1
/// everything happens on this thread, in order.
template <class Make, class Work, class Finish>
void over_circles(std::size_t count, unsigned threads, Make make, Work work, Finish finish) {
  if (threads == 1 || count < 2) {
    auto scratch = make();
    for (std::size_t i = 0; i < count; ++i) work(scratch, i);
    finish(scratch);
    return;
  }
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  arena.execute([&] {
    tbb::enumerable_thread_specific<decltype(make())> scratches(make);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        auto& scratch = scratches.local();
                        for (std::size_t i = range.begin(); i != range.end(); ++i) {
                          work(scratch, i);
                        }
                      });
    for (auto& scratch : scratches) finish(scratch);
  });
}

}  // namespace stickslip
