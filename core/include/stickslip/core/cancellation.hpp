// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Long work that whoever asked for it may break off.
///
/// Work that takes long calls throw_if_cancelled() again and again: for each node, mode, circle
/// and pivot. Nothing happens unless a Cancellation is in force on the thread.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <thread>

namespace stickslip {

/// Thrown where work is broken off.
class Cancelled : public std::exception {
 public:
  /// "cancelled"
  const char* what() const noexcept override { return "cancelled"; }
};

/// As long as this lives, the work of the thread that made it may be broken off.
class Cancellation {
 public:
  /// `wanted` is called on the thread that made this, at most every 50 ms, and no more once it
  /// has said true.
  explicit Cancellation(std::function<bool()> wanted);
  ~Cancellation();
  Cancellation(const Cancellation&) = delete;
  Cancellation& operator=(const Cancellation&) = delete;

  /// What is in force on this thread; null if nothing is.
  static Cancellation* current();

  /// Throws Cancelled if the work is to end.
  void check();

 private:
  std::function<bool()> wanted_;
  std::thread::id asker_ = std::this_thread::get_id();
  std::chrono::steady_clock::time_point next_{};
  std::atomic<bool> cancelled_{false};
  Cancellation* outer_;
};

/// In force on this thread too, as long as this lives: for the tasks of parallel work, which
/// take `shared` from Cancellation::current() of the thread that starts them.
class SharedCancellation {
 public:
  /// Nothing is in force if it is null.
  explicit SharedCancellation(Cancellation* shared);
  ~SharedCancellation();
  SharedCancellation(const SharedCancellation&) = delete;
  SharedCancellation& operator=(const SharedCancellation&) = delete;

 private:
  Cancellation* outer_;
};

/// Throws Cancelled if a Cancellation is in force whose work is to end.
void throw_if_cancelled();

}  // namespace stickslip
