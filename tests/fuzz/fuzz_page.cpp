// SPDX-License-Identifier: GPL-3.0-or-later
// What `stickslip serve` makes of the body of a request. It has an answer in JSON, whatever the
// body: of a wrong one an error that says where, else the verdict that decide() gives; and none
// of it can end the element of the page in which it stands.
#include <chrono>
#include <nlohmann/json.hpp>

#include "fuzz_target.hpp"
#include "stickslip/interfaces/answer.hpp"
#include "stickslip/interfaces/html.hpp"

namespace {

using stickslip::fuzz::broken;
using Tree = nlohmann::json;

constexpr std::size_t kMostBytes = 4000;

void expect_error(const Tree& reply, const std::string& body) {
  const auto error = reply.find("error");
  if (reply.size() != 1 || error == reply.end() || !error->at("place").is_string() ||
      error->at("message").get<std::string>().empty()) {
    broken("no error that helps: " + body);
  }
}

void expect_answer(const stickslip::Json& reply) {
  const stickslip::Json& grasp = reply.at("grasp");
  if (!grasp.is_string() || !reply.at("live").is_true() || !reply.at("messages").is_array()) {
    broken("no answer: " + reply.dump());
  }
  if (stickslip::json_in_html(reply).find('<') != std::string::npos) {
    broken("markup in an answer: " + reply.dump());
  }
  // The grasp of an answer can be asked about again.
  stickslip::PageLimits limits;
  limits.node_limit = 1;
  const stickslip::Json again{{"grasp", grasp}, {"parts", stickslip::Json::array()}};
  const stickslip::PageReply second = stickslip::reply_to(again.dump(), limits);
  if (stickslip::Json::parse(second.body).at("grasp").dump() != grasp.dump()) {
    broken("another grasp: " + second.body);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > kMostBytes) return 0;
  const std::string body(data, data + size);
  stickslip::PageLimits limits;
  limits.node_limit = 50;
  limits.time = std::chrono::milliseconds(200);
  limits.limits_verdict = true;
  try {
    const stickslip::PageReply reply = stickslip::reply_to(body, limits);
    const auto tree = stickslip::Json::parse(reply.body);
    if (reply.status == 400) {
      expect_error(Tree::parse(reply.body), body);
    } else if (reply.status == 200) {
      expect_answer(tree);
    } else {
      broken("status " + std::to_string(reply.status));
    }
  } catch (const std::exception& error) {
    broken(std::string("an exception: ") + error.what());
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path& corpus) {
  std::vector<Seed> result = hostile_texts();
  const stickslip::Json options{
      {"wrench", {0, "1/2", 0}},     {"preload", "1"}, {"bilateral", true},
      {"uncertain", "friction=10%"}, {"snap", true},   {"warnings", false}};
  std::size_t count = 0;
  for (const char* folder : {"grasps", "hard", "space"}) {
    for (const Seed& seed : files_below(corpus / folder)) {
      if (seed.bytes.size() > kMostBytes / 2) continue;
      stickslip::Json request{{"grasp", seed.bytes}};
      // One of them all parts, the others one each.
      constexpr std::array<const char*, 5> kParts{"decide", "states", "region", "margin",
                                                  "map"};
      if (count % 6 < 5) request["parts"] = {kParts[count % 6]};
      if (++count % 3 == 0) request["options"] = options;
      try {
        result.push_back({seed.name, request.dump()});
      } catch (const stickslip::JsonTextError&) {
        continue;  // no UTF-8
      }
    }
  }
  return result;
}
