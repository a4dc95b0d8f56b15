// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The outline of a grasp file and contacts by their place on it; in space the body.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "stickslip/core/json.hpp"
#include "stickslip/core/outline.hpp"

namespace stickslip::core_detail {

/// "on" of a contact: a point of an edge, as the file gives it.
struct PlaceOnOutline {
  Rational polygon{0};
  Rational edge;
  Rational share;
};

/// Throws InputError where it is no place on any outline.
PlaceOnOutline read_place(const JsonNode& node, const std::string& path);

/// The value of "outline", checked; empty if there is none.
std::vector<Polygon> read_outline(const JsonNode& root);

/// The value of "body", or of the key of another surface; null if there is none.
std::shared_ptr<const Mesh> read_surface(const JsonNode& root, const std::string& key = "body");

/// The edge of this place, whose path is that of "on". Throws InputError if there is none.
const OutlineEdge& edge_at(const std::vector<std::vector<OutlineEdge>>& edges,
                           const PlaceOnOutline& place, const std::string& path);

}  // namespace stickslip::core_detail
