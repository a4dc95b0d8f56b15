// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads the outline of a grasp file, the contacts by their place on it, and in space the body.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "stickslip/core/json.hpp"
#include "stickslip/core/outline.hpp"

namespace stickslip::core_detail {

/// The place "on" of a contact: a point of an edge, as the file gives it.
struct PlaceOnOutline {
  Rational polygon{0};
  Rational edge;
  Rational share;
};

/// Returns the place that "on" describes. Throws InputError if it is no place on any outline.
PlaceOnOutline read_place(const JsonNode& node, const std::string& path);

/// Returns the value of "outline", checked; empty if there is none.
std::vector<Polygon> read_outline(const JsonNode& root);

/// Returns the value of "body", or of another key of a surface; null if there is none.
std::shared_ptr<const Mesh> read_surface(const JsonNode& root, const std::string& key = "body");

/// Returns the edge of this place. `path` is that of "on". Throws InputError if there is no
/// such edge.
const OutlineEdge& edge_at(const std::vector<std::vector<OutlineEdge>>& edges,
                           const PlaceOnOutline& place, const std::string& path);

}  // namespace stickslip::core_detail
