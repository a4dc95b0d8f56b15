// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_parallel.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <chrono>
#include <future>

#include "stickslip/core/cancellation.hpp"

namespace stickslip::extent_detail {

void in_parallel(std::size_t count, const std::function<void(std::size_t k)>& work) {
  Cancellation* const asked = Cancellation::current();
  const auto all = [&] {
    oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
      const SharedCancellation shared(asked);
      throw_if_cancelled();
      work(k);
    });
  };
  if (asked == nullptr) return all();
  // Only this thread may ask whether it is to end. While it worked on a long k it would not
  // ask, so it takes no part.
  std::future<void> done = std::async(std::launch::async, all);
  constexpr std::chrono::milliseconds kPause{50};
  try {
    while (done.wait_for(kPause) == std::future_status::timeout) asked->check();
  } catch (const Cancelled&) {
    // The other threads see the cancellation too, and all() throws.
  }
  done.get();
}

}  // namespace stickslip::extent_detail
