// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_server.hpp"

#include <httplib.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <utility>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kConnections =
    256;                              ///< at a time; most of them wait for a client to send
constexpr std::size_t kAnswers = 16;  ///< the requests that are worked on at a time
constexpr std::size_t kMostHeaderBytes = 16384;
constexpr std::chrono::seconds kTimeToSend{5};      ///< the time for a whole request
constexpr std::chrono::seconds kTimeToReceive{10};  ///< the time for a whole answer
constexpr std::chrono::milliseconds kLookAround{50};
/// The longest wait for a client that sends nothing while others wait for its thread.
constexpr std::chrono::milliseconds kPatience{250};

/// The threads of connections. Slow clients hold them, and other clients must not wait for
/// those.
class Threads final : public httplib::ThreadPool {
 public:
  explicit Threads(std::atomic<std::size_t>& waiting)
      : ThreadPool(kConnections), waiting_(waiting) {}

  void enqueue(std::function<void()> serve) override {
    ++waiting_;
    ThreadPool::enqueue([this, serve = std::move(serve)] {
      --waiting_;
      serve();
    });
  }

 private:
  std::atomic<std::size_t>& waiting_;  ///< connections without a thread
};

/// A connection with an end: it has a limit of bytes and of time.
class BoundedStream final : public httplib::Stream {
 public:
  BoundedStream(socket_t socket, const std::atomic<bool>& stopping,
                const std::atomic<std::size_t>& waiting)
      : socket_(socket), stopping_(stopping), waiting_(waiting) {}

  bool is_readable() const override { return true; }
  bool is_writable() const override { return true; }
  socket_t socket() const override { return socket_; }
  void get_remote_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  void get_local_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}

  ssize_t read(char* to, std::size_t size) override {
    if (begin_ == end_ && !fill()) return -1;
    const std::size_t taken = std::min(size, end_ - begin_);
    std::memcpy(to, buffer_.data() + begin_, taken);
    begin_ += taken;
    return static_cast<ssize_t>(taken);
  }

  ssize_t write(const char* from, std::size_t size) override {
    if (!writes_until_) writes_until_ = Clock::now() + kTimeToReceive;
    if (!wait(POLLOUT, *writes_until_)) return -1;
    return ::send(socket_, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
  }

  /// Returns true if the client has hung up.
  bool is_deserted() const {
    pollfd state{socket_, POLLRDHUP, 0};
    return ::poll(&state, 1, 0) > 0;
  }

  /// Ends the connection. Data still on its way is taken first: a client loses the part of the
  /// answer that it has not read if this side closes on unread data.
  void close() {
    ::shutdown(socket_, SHUT_WR);
    constexpr std::chrono::milliseconds kLinger{500};
    const auto until = Clock::now() + kLinger;
    while (wait(POLLIN, until) && ::recv(socket_, buffer_.data(), buffer_.size(), 0) > 0) {
    }
    ::close(socket_);
  }

 private:
  /// Waits for an event on the connection. Returns false if the time is over or the server
  /// stops, or if nothing arrives for a while and others wait for the thread.
  bool wait(short event, Clock::time_point until) const {
    pollfd state{socket_, event, 0};
    const Clock::time_point patient_until = Clock::now() + kPatience;
    while (!stopping_ && Clock::now() < until) {
      if (event == POLLIN && waiting_ > 0 && Clock::now() > patient_until) return false;
      if (::poll(&state, 1, static_cast<int>(kLookAround.count())) > 0) return true;
    }
    return false;
  }

  bool fill() {
    if (left_ == 0 || !wait(POLLIN, reads_until_)) return false;
    const ssize_t got =
        ::recv(socket_, buffer_.data(), std::min(buffer_.size(), left_), MSG_DONTWAIT);
    if (got <= 0) return false;
    begin_ = 0;
    end_ = static_cast<std::size_t>(got);
    left_ -= end_;
    return true;
  }

  socket_t socket_;
  const std::atomic<bool>& stopping_;
  const std::atomic<std::size_t>& waiting_;  ///< connections without a thread
  std::size_t left_ = kMostHeaderBytes + PageServer::kMostBytes;
  Clock::time_point reads_until_ = Clock::now() + kTimeToSend;
  std::optional<Clock::time_point> writes_until_;
  std::array<char, 16384> buffer_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

/// The connection that this thread serves.
thread_local const BoundedStream* served_stream = nullptr;

std::string new_nonce() {
  std::random_device random;
  std::string nonce;
  for (int i = 0; i < 32; ++i) nonce += "0123456789abcdef"[random() % 16];
  return nonce;
}

/// Returns true for the type alone, or with parameters: application/json; charset=utf-8.
bool is_json(std::string type) {
  type = type.substr(0, type.find(';'));
  type.erase(type.find_last_not_of(" \t") + 1);
  std::transform(type.begin(), type.end(), type.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return type == "application/json";
}

void set_error(httplib::Response& response, int status, const std::string& message) {
  const Json json{{"error", {{"message", message}, {"place", ""}}}};
  response.status = status;
  response.set_content(json.dump(), "application/json");
}

}  // namespace

class PageServer::Http : public httplib::Server {
  /// A few places, each for one request that is worked on.
  class Places {
   public:
    explicit Places(std::size_t count) : free_(count) {}

    /// Waits for a place as long as it is wanted. Returns false if it is wanted no more.
    template <typename IsWanted>
    bool take(const IsWanted& is_wanted) {
      std::unique_lock<std::mutex> lock(mutex_);
      while (free_ == 0) {
        if (!is_wanted()) return false;
        given_back_.wait_for(lock, kLookAround);
      }
      --free_;
      return true;
    }

    void give_back() {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++free_;
      given_back_.notify_one();
    }

   private:
    std::mutex mutex_;
    std::condition_variable given_back_;
    std::size_t free_;
  };

 public:
  Http(ServedPage served, int port) : served_(std::move(served)) {
    new_task_queue = [this] { return new Threads(waiting_); };
    set_tcp_nodelay(true);
    // The library's own options would let two servers share a port.
    set_socket_options([this](socket_t socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
      listening_ = socket;
    });
    set_payload_max_length(kMostBytes);
    set_pre_routing_handler([this](const httplib::Request& request,
                                   httplib::Response& response) {
      return refuse(request, response) ? HandlerResponse::Handled : HandlerResponse::Unhandled;
    });
    set_post_routing_handler([](const httplib::Request&, httplib::Response& response) {
      response.set_header("X-Content-Type-Options", "nosniff");
      response.set_header("Cross-Origin-Resource-Policy", "same-origin");
      response.set_header("Referrer-Policy", "no-referrer");
      response.set_header("Cache-Control", "no-store");
      if (!response.has_header("Content-Security-Policy")) {
        response.set_header("Content-Security-Policy", "default-src 'none'");
      }
    });
    set_error_handler([](const httplib::Request&, httplib::Response& response) {
      if (response.body.empty()) set_error(response, response.status, "this is no request");
    });
    set_exception_handler(
        [](const httplib::Request&, httplib::Response& response, std::exception_ptr thrown) {
          try {
            std::rethrow_exception(std::move(thrown));
          } catch (const Cancelled&) {
            set_error(response, 503, "the work was broken off");
          } catch (const std::exception& error) {
            set_error(response, 500, std::string("internal error: ") + error.what());
          } catch (...) {
            set_error(response, 500, "internal error");
          }
        });
    Get("/", [this](const httplib::Request&, httplib::Response& response) {
      const std::string nonce = new_nonce();
      response.set_header("Content-Security-Policy",
                          "default-src 'none'; script-src 'nonce-" + nonce +
                              "'; style-src 'unsafe-inline'; img-src data: blob:; connect-src "
                              "'self'; base-uri 'none'; form-action 'none'; frame-ancestors "
                              "'none'");
      response.set_content(served_.page(nonce), "text/html; charset=utf-8");
    });
    Post("/answer", [this](const httplib::Request&, httplib::Response& response,
                           const httplib::ContentReader& read) { answer(response, read); });
    port_ = port == 0 ? bind_to_any_port(kHost) : bind_to_port(kHost, port) ? port : -1;
    if (port_ < 0) {
      throw InputError("", "--port", "port " + std::to_string(port) + " cannot be had",
                       "give one that nothing listens on, or leave the option out");
    }
    // The library lets five connections wait; the system resets some beyond that.
    constexpr int kMostWaiting = 512;
    ::listen(listening_, kMostWaiting);
  }

  int port() const { return port_; }

  void run() {
    if (!stopping_) listen_after_bind();
    done_ = true;
  }

  void stop_all() {
    stopping_ = true;
    // The server may be about to begin, and then does not notice a stop.
    while (!done_) {
      stop();
      std::this_thread::sleep_for(kLookAround);
    }
  }

 private:
  static constexpr const char* kHost = "127.0.0.1";

  bool process_and_close_socket(socket_t socket) override {
    BoundedStream stream(socket, stopping_, waiting_);
    served_stream = &stream;
    bool closed = false;
    // No client needs a part of an answer, or a thousand of them.
    const auto whole = [](httplib::Request& request) { request.ranges.clear(); };
    const bool done = process_request(stream, true, closed, whole);
    served_stream = nullptr;
    stream.close();
    return done;
  }

  /// Returns true if this does not answer such requests; then the response says so.
  bool refuse(const httplib::Request& request, httplib::Response& response) const {
    const std::string port = ":" + std::to_string(port_);
    const auto is_own = [&](const std::string& header, const std::string& scheme) {
      const std::string value = request.get_header_value(header.c_str());
      return request.get_header_value_count(header.c_str()) == 1 &&
             (value == scheme + kHost + port || value == scheme + "localhost" + port);
    };
    if (!is_own("Host", "")) {
      set_error(response, 403, "this answers to 127.0.0.1 and localhost alone");
    } else if (request.has_header("Origin") && !is_own("Origin", "http://")) {
      set_error(response, 403, "this answers to its own page alone");
    } else if (request.path != "/" && request.path != "/answer") {
      set_error(response, 404, "there are / and /answer");
    } else if (request.method != (request.path == "/" ? "GET" : "POST")) {
      set_error(response, 405, "the methods are GET / and POST /answer");
    } else if (request.path == "/answer" &&
               !is_json(request.get_header_value("Content-Type"))) {
      set_error(response, 415, "a question is application/json");
    } else {
      return false;
    }
    return true;
  }

  void answer(httplib::Response& response, const httplib::ContentReader& read) {
    std::string body;
    bool fits = true;
    const bool complete = read([&](const char* part, std::size_t size) {
      fits = body.size() + size <= kMostBytes;
      if (fits) body.append(part, size);
      return fits;
    });
    if (!fits) return set_error(response, 413, "the question is too long");
    if (!complete) {
      if (response.status == 413) return set_error(response, 413, "the question is too long");
      return set_error(response, 400, "the question does not end");
    }
    const auto is_over = [&] {
      return stopping_ || (served_stream != nullptr && served_stream->is_deserted());
    };
    if (!places_.take([&] { return !is_over(); })) throw Cancelled();
    const std::unique_ptr<Places, void (*)(Places*)> place(&places_,
                                                           [](Places* p) { p->give_back(); });
    const Cancellation cancellation(is_over);
    auto [status, json] = served_.answer(body);
    response.status = status;
    response.set_content(std::move(json), "application/json");
  }

  ServedPage served_;
  int port_ = -1;
  socket_t listening_ = -1;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> done_{false};
  std::atomic<std::size_t> waiting_{0};
  Places places_{kAnswers};
};

PageServer::PageServer(ServedPage served, int port)
    : http_(std::make_unique<Http>(std::move(served), port)) {}

PageServer::~PageServer() = default;

int PageServer::port() const {
  return http_->port();
}

void PageServer::run() {
  http_->run();
}

void PageServer::stop() {
  http_->stop_all();
}

}  // namespace stickslip
