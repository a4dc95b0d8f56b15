// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Interruptions: the program ends by their signal, and no file stays half-written.
#pragma once

#include <functional>
#include <string>

namespace stickslip {

/// Makes SIGINT, SIGTERM and SIGHUP wait for files that are being written (core/file.hpp) and
/// then end the program, by the same signal, so that whoever started it knows. Signals that are
/// ignored (nohup) stay so. Call it in main, before there are other threads.
void finish_files_when_interrupted();

/// Ends the program by this signal when the files that are being written are done.
[[noreturn]] void end_by_signal(int signal_number);

/// The line that an interruption writes on standard error while this lives. There is one at a
/// time. `text` is called by another thread, when no FileWrite lives any more.
class InterruptionMessage {
 public:
  explicit InterruptionMessage(std::function<std::string()> text);
  ~InterruptionMessage();
  InterruptionMessage(const InterruptionMessage&) = delete;
  InterruptionMessage& operator=(const InterruptionMessage&) = delete;
};

/// While this lives the first interruption calls `stop`, on a thread of its own, in place of
/// ending the program; a second one ends it. There is one at a time.
class InterruptionStop {
 public:
  explicit InterruptionStop(std::function<void()> stop);
  ~InterruptionStop();  ///< waits for a call to return
  InterruptionStop(const InterruptionStop&) = delete;
  InterruptionStop& operator=(const InterruptionStop&) = delete;
};

}  // namespace stickslip
