// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A loop on all threads of the machine that its caller may break off.
#pragma once

#include <cstddef>
#include <functional>

namespace stickslip::extent_detail {

/// Calls work(k) for all k < count, in no particular order. A Cancellation in force here is in
/// force on all these threads. If a call throws, this throws the same, once no other thread is
/// at work.
void in_parallel(std::size_t count, const std::function<void(std::size_t k)>& work);

}  // namespace stickslip::extent_detail
