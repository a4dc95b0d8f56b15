// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Values taken out of a JSON tree, and the errors of those that are not what they should be.
/// Every function throws InputError at `path`, a JSON path; that of the root is empty.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/json_tree.hpp"
#include "stickslip/core/number.hpp"

namespace stickslip {

/// Throws the InputError.
[[noreturn]] void fail_at(const std::string& path, std::string problem, std::string remedy);

/// The node has this kind; `expected` says so in words.
void expect(const JsonNode& node, JsonNode::Kind kind, const std::string& path,
            const char* expected);

/// The keys that an object may have.
using JsonKeys = std::vector<std::string>;

/// An object without keys other than these; a near miss is told what was meant.
void expect_object(const JsonNode& node, const std::string& path, const JsonKeys& allowed);

/// The value of a required key.
const JsonNode& member(const JsonNode& object, const std::string& path, const char* key,
                       const char* remedy);

/// A JSON number or a string that parse_rational reads.
Rational read_number(const JsonNode& node, const std::string& path);

/// `length` numbers; `form` describes them, "an array of two numbers [x, y]".
std::vector<Rational> read_vector(const JsonNode& node, const std::string& path,
                                  std::size_t length, const char* form);

}  // namespace stickslip
