// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A loop on all threads of the machine, which whoever asked for it may break off.
#pragma once

#include <cstddef>
#include <functional>

namespace stickslip::extent_detail {

/// Calls work(k) for all k < count, in no particular order. What is in force of a Cancellation
/// is so on all these threads. Throws what one of them does, once no other is at work.
void in_parallel(std::size_t count, const std::function<void(std::size_t k)>& work);

}  // namespace stickslip::extent_detail
