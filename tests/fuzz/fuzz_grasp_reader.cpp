// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of grasp files. An input is a grasp file. Whatever core reads, it writes and
// reads back as the same grasp and the same bytes; and core and the checker, which share no
// code, take and refuse the same, and read the same numbers.
#include <algorithm>
#include <initializer_list>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

#include "answer.hpp"
#include "box.hpp"
#include "fuzz_target.hpp"
#include "grasp.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace {

using stickslip::fuzz::broken;

bool has_intervals(const stickslip::GraspFile& file) {
  const auto is_point = [](const stickslip::Interval& w) { return w.is_point(); };
  return file.content.box() != nullptr ||
         std::any_of(file.cases.begin(), file.cases.end(), [&](const auto& load) {
           return !std::all_of(load.wrench.begin(), load.wrench.end(), is_point);
         });
}

/// The text of a file, or nothing if it is too long for one: "1e4096" fits, and its digits may
/// not.
std::string written(const stickslip::GraspFile& file) {
  try {
    return write_grasp_file(file);
  } catch (const stickslip::InputError& error) {
    if (std::string(error.what()).find("characters") == std::string::npos) throw;
    return {};
  }
}

/// The ends of the intervals that decide, in one order; cases by their names.
std::vector<std::string> numbers(const stickslip::GraspBox& box,
                                 const std::map<std::string, stickslip::WrenchBox>& cases) {
  std::vector<std::string> all;
  const auto add = [&](const stickslip::Interval& interval) {
    all.push_back(stickslip::to_string(interval.low));
    all.push_back(stickslip::to_string(interval.high));
  };
  for (const stickslip::UncertainContact& c : box.contacts) {
    for (const stickslip::Interval& coordinate : c.position) add(coordinate);
    for (const auto* interval : {&c.friction, &c.stiffness, &c.preload}) add(*interval);
    for (const auto& entry : c.normal) all.push_back(stickslip::to_string(entry));
    all.push_back(stickslip::to_string(c.slope));
  }
  for (const stickslip::Interval& component : box.wrench) add(component);
  for (const auto& [name, wrench] : cases) {
    all.push_back(name);
    for (const stickslip::Interval& component : wrench) add(component);
  }
  return all;
}

std::vector<std::string> numbers(const stickslip::GraspFile& file) {
  std::map<std::string, stickslip::WrenchBox> cases;
  for (const stickslip::NamedLoad& load : file.cases) cases[load.name] = load.wrench;
  return numbers(file.content.as_box(), cases);
}

void expect_round_trip(const stickslip::GraspFile& file) {
  const std::string text = written(file);
  if (text.empty()) return;
  const stickslip::GraspFile again = stickslip::parse_any_grasp(text, "written");
  const stickslip::GraspDescription& before = file.description();
  const stickslip::GraspDescription& after = again.description();
  const bool same_body =
      before.body && after.body ? *before.body == *after.body : before.body == after.body;
  const bool equal = (again.content.box() == nullptr) == (file.content.box() == nullptr) &&
                     after.name == before.name && after.outline == before.outline &&
                     after.units == before.units && same_body &&
                     again.assumed_stiffness == file.assumed_stiffness &&
                     numbers(again) == numbers(file);
  if (!equal) broken("another grasp is read back");
  if (write_grasp_file(again) != text) broken("other bytes are written the second time");
}

std::vector<std::string> numbers(const stickslip_check::Grasp& grasp) {
  std::vector<std::string> all;
  const auto add = [&](const stickslip_check::Bounds& bounds) {
    all.push_back(bounds.low.get_str());
    all.push_back(bounds.high.get_str());
  };
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const stickslip_check::Contact c = grasp.contacts[i];
    for (const stickslip_check::Bounds& coordinate : c.position) add(coordinate);
    for (const auto* bounds : {&c.friction, &c.stiffness, &c.preload}) add(*bounds);
    for (const stickslip_check::Rational& entry : c.normal) all.push_back(entry.get_str());
    all.push_back(c.slope.get_str());
  }
  for (const stickslip_check::Bounds& component : grasp.wrench) add(component);
  for (const auto& [name, wrench] : grasp.cases) {
    all.push_back(name);
    for (const stickslip_check::Bounds& component : wrench) add(component);
  }
  return all;
}

struct Reading {
  std::vector<std::string> numbers;
  std::string refusal;   ///< why the text is refused; empty if it is not
  bool several = false;  ///< it is about several bodies, which parse_any_grasp is not about
};

/// By a reader that takes no intervals, and nothing in space.
void expect_refused(std::string_view text) {
  try {
    stickslip::parse_grasp(text, "fuzz");
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, text);
    return;
  }
  broken("intervals or a grasp in space are read where they must not be");
}

Reading by_core(std::string_view text) {
  try {
    const stickslip::GraspFile file = stickslip::parse_any_grasp(text, "fuzz");
    expect_round_trip(file);
    if (file.content.in_space() || has_intervals(file)) expect_refused(text);
    return {numbers(file), {}};
  } catch (const stickslip::InputError& error) {
    stickslip::fuzz::expect_useful(error, text);
    return {{}, error.what()};
  }
}

Reading by_checker(const std::string& text) {
  std::istringstream in(text);
  try {
    const stickslip_check::Grasp grasp = stickslip_check::read_grasp(in, "fuzz");
    return {numbers(grasp), {}, grasp.several.has_value()};
  } catch (const stickslip_check::Malformed& malformed) {
    return {{}, malformed.place + ": " + malformed.problem};
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    const Reading core = by_core(text);
    const Reading checker = by_checker(text);
    // How rings lie to each other plays no part in a question; core refuses what is no body.
    const auto says = [&](const char* words) {
      return core.refusal.find(words) != std::string::npos;
    };
    if (says(" meet; ") || says("the hole is ") || checker.several) return 0;
    if (core.refusal.empty() != checker.refusal.empty()) {
      broken("core says \"" + core.refusal + "\", the checker \"" + checker.refusal + "\"");
    }
    if (core.numbers != checker.numbers) broken("core and the checker read other numbers");
  } catch (const std::exception& error) {
    broken(std::string("an exception: ") + error.what());
  }
  return 0;
}

std::vector<stickslip::fuzz::Seed> stickslip::fuzz::seeds(const std::filesystem::path& corpus) {
  std::vector<Seed> result = files_below(corpus / "grasps");
  for (Seed& seed : hostile_texts()) result.push_back(std::move(seed));
  for (const char* folder : {"certificates", "space", "bodies"}) {
    for (Seed& seed : files_below(corpus / folder)) {
      if (seed.name.find(".grasp.json") != std::string::npos) result.push_back(std::move(seed));
    }
  }
  return result;
}
