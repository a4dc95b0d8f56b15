// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A server of one page and its answers over HTTP, on the loopback interface and no other.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace stickslip {

/// The page and its answers.
struct ServedPage {
  /// Returns the page, with this nonce for its scripts.
  std::function<std::string(const std::string& nonce)> page;
  /// Returns the HTTP status and the JSON of the answer to a request. Several threads call it,
  /// with a Cancellation in force that ends work for clients that left.
  std::function<std::pair<int, std::string>(const std::string& request)> answer;
};

/// Serves the page at GET / and answers at POST /answer. Everything else is refused: requests
/// by other names than 127.0.0.1 and localhost, or from pages of other origins; bodies of more
/// than kMostBytes. A connection serves one request and is given a few seconds to send it. The
/// server neither reads nor writes files.
class PageServer {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{1} << 20;  ///< the limit of a request's
                                                                   ///< body

  /// Takes the port, or a free one if it is 0. Throws InputError naming --port.
  PageServer(ServedPage served, int port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  int port() const;  ///< the port that was taken

  /// Serves until stop() is called, by another thread.
  void run();
  /// Breaks off work and ends run().
  void stop();

 private:
  class Http;
  std::unique_ptr<Http> http_;
};

}  // namespace stickslip
