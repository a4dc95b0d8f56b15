// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Lets whoever asked for long work break it off.
///
/// Long work calls throw_if_cancelled() again and again: for each node, mode, circle and pivot.
/// Nothing happens unless a Cancellation is in force on the thread.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <thread>

namespace stickslip {

/// The exception that ends work when it is broken off.
class Cancelled : public std::exception {
 public:
  /// Returns "cancelled".
  const char* what() const noexcept override { return "cancelled"; }
};

/// A way to break off the work of the thread that made it, for as long as it lives.
class Cancellation {
 public:
  /// Takes a function that says whether the work is to end. It is called on the thread that
  /// made this, at most every 50 ms, and no more once it has returned true.
  explicit Cancellation(std::function<bool()> wanted);
  ~Cancellation();
  Cancellation(const Cancellation&) = delete;
  Cancellation& operator=(const Cancellation&) = delete;

  /// Returns the Cancellation in force on this thread; null if there is none.
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

/// Puts a Cancellation in force on this thread too, for as long as this lives. The tasks of
/// parallel work use it with Cancellation::current() of the thread that starts them.
class SharedCancellation {
 public:
  /// Puts `shared` in force; nothing is in force if it is null.
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
