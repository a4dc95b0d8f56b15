// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/html.hpp"

#include <string_view>

#include "stickslip/core/error.hpp"
#include "web_files.hpp"

namespace stickslip {
namespace {

constexpr std::string_view kOpen = "<!-- ";
constexpr std::string_view kClose = " -->";

const std::string& web_file(const std::string& name) {
  const auto& all = page_detail::web_files();
  const auto found = all.find(name);
  require(found != all.end(), "the page includes a file that is not there");
  return found->second;
}

/// Returns the element with a file that the page includes.
std::string element(const std::string& name, const std::string& nonce) {
  const std::string ending = name.substr(name.find_last_of('.') + 1);
  if (ending == "css") return "<style id=\"" + name + "\">\n" + web_file(name) + "</style>";
  const std::string attribute = nonce.empty() ? "" : " nonce=\"" + nonce + "\"";
  return "<script" + attribute + ">\n" + web_file(name) + "</script>";
}

/// Returns true if the comment begins with this word, and takes the word off.
bool takes(std::string_view& comment, std::string_view word) {
  if (comment.substr(0, word.size()) != word) return false;
  comment.remove_prefix(word.size());
  return true;
}

}  // namespace

std::string json_in_html(const Json& json) {
  std::string text;
  for (const char c : json.dump()) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string page_html(const Json& answer, const std::string& nonce) {
  // A live page may come to another grasp, so it has the scripts for space.
  const bool in_space = answer.at("live").is_true() || answer.at("dimension").count() == 6;
  const std::string_view frame = web_file("page.html");
  std::string html;
  std::size_t done = 0;
  for (std::size_t open = frame.find(kOpen); open != std::string_view::npos;
       open = frame.find(kOpen, done)) {
    const std::size_t from = open + kOpen.size();
    const std::size_t close = frame.find(kClose, from);
    require(close != std::string_view::npos, "a comment of the page does not end");
    std::string_view comment = frame.substr(from, close - from);
    html += frame.substr(done, open - done);
    done = close + kClose.size();
    if (comment == "answer") {
      html += R"(<script type="application/json" id="answer">)" + json_in_html(answer) +
              "</script>";
    } else if (takes(comment, "include ")) {
      html += element(std::string(comment), nonce);
    } else if (takes(comment, "include-space ")) {
      if (in_space) html += element(std::string(comment), nonce);
    } else {
      html += frame.substr(open, done - open);
    }
  }
  html += frame.substr(done);
  return html;
}

}  // namespace stickslip
