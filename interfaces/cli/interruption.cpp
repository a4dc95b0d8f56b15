// SPDX-License-Identifier: GPL-3.0-or-later
#include "interruption.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "stickslip/core/file.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct Message {
  std::mutex mutex;
  std::function<std::string()> text;
};

/// Returns the message, which is never destroyed: the thread below lives on while the program
/// ends.
Message& message() {
  static auto* const one = new Message;
  return *one;
}

void say_message() {
  const std::lock_guard<std::mutex> lock(message().mutex);
  if (!message().text) return;
  const std::string text =
      (isatty(STDERR_FILENO) == 1 ? kClearLine : "") + message().text() + "\n";
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nobody hears of it
}

struct Stop {
  std::mutex mutex;
  std::function<void()> call;
};

/// Returns the stop, which is never destroyed, either.
Stop& stop() {
  static auto* const one = new Stop;
  return *one;
}

/// Calls the stop once. Returns false if there is none to call, or no more.
bool call_stop() {
  const std::lock_guard<std::mutex> lock(stop().mutex);
  const std::function<void()> call = std::exchange(stop().call, nullptr);
  if (call) call();
  return call != nullptr;
}

/// Waits for signals in a thread of its own, where waiting is allowed; a signal handler may not
/// wait.
void wait_for(sigset_t signals) {
  int signal_number = 0;
  do {
    if (sigwait(&signals, &signal_number) != 0) return;
  } while (call_stop());
  end_by_signal(signal_number);
}

}  // namespace

void end_by_signal(int signal_number) {
  stop_file_writes(std::chrono::seconds(10));
  if (signal_number != SIGPIPE) say_message();
  std::signal(signal_number, SIG_DFL);
  sigset_t unblocked;
  sigemptyset(&unblocked);
  sigaddset(&unblocked, signal_number);
  pthread_sigmask(SIG_UNBLOCK, &unblocked, nullptr);
  raise(signal_number);
  std::abort();  // not reached
}

void finish_files_when_interrupted() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (sigaction(signal_number, nullptr, &action) == 0 && action.sa_handler == SIG_DFL) {
      sigaddset(&signals, signal_number);
    }
  }
  // Every thread has the signals blocked, so that sigwait gets them.
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, &signals, &before);
  try {
    std::thread(wait_for, signals).detach();
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);  // there is no thread to be had: this does
                                                     // nothing then
  }
}

InterruptionMessage::InterruptionMessage(std::function<std::string()> text) {
  const std::lock_guard<std::mutex> lock(message().mutex);
  message().text = std::move(text);
}

InterruptionMessage::~InterruptionMessage() {
  const std::lock_guard<std::mutex> lock(message().mutex);
  message().text = nullptr;
}

InterruptionStop::InterruptionStop(std::function<void()> call) {
  const std::lock_guard<std::mutex> lock(stop().mutex);
  stop().call = std::move(call);
}

InterruptionStop::~InterruptionStop() {
  const std::lock_guard<std::mutex> lock(stop().mutex);
  stop().call = nullptr;
}

}  // namespace stickslip
