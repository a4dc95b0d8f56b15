// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline_file.hpp"

#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip::core_detail {
namespace {

using Kind = JsonNode::Kind;

constexpr const char* kForm =
    "a list of polygons [[ring, hole, ...], ...]; a ring is [[x, y], ...]";

/// Returns how deep arrays are nested, looking at first elements only.
int depth_of(const JsonNode& node) {
  if (node.kind != Kind::kArray) return 0;
  return 1 + (node.children.empty() ? 0 : depth_of(node.children.front()));
}

/// Returns the elements of the array, each read with its path.
template <class Read>
auto read_list(const JsonNode& node, const std::string& path, const char* form, Read read) {
  expect(node, Kind::kArray, path, form);
  std::vector<decltype(read(node, path))> list;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    list.push_back(read(node.children[i], element_path(path, i)));
  }
  return list;
}

Vector2 read_vertex(const JsonNode& node, const std::string& path) {
  const std::vector<Rational> v = read_vector(node, path, 2, "an array of two numbers [x, y]");
  return {v[0], v[1]};
}

Ring read_ring(const JsonNode& node, const std::string& path) {
  return read_list(node, path, kForm, read_vertex);
}

Polygon read_polygon(const JsonNode& node, const std::string& path) {
  return read_list(node, path, kForm, read_ring);
}

/// Returns a whole number from 0 to below `count`. Throws InputError for any other; `range`
/// says so.
std::size_t read_index(const Rational& value, std::size_t count, const std::string& path,
                       const std::string& range) {
  if (denominator(value) != 1 || value.sign() < 0 || value >= count) {
    fail_at(path, "the value is " + to_string(value), range);
  }
  return numerator(value).convert_to<std::size_t>();
}

std::string numbered(std::size_t count, const std::string& one, const std::string& many) {
  return count == 1
             ? "1 " + one + ", number 0"
             : std::to_string(count) + " " + many + ", 0 to " + std::to_string(count - 1);
}

}  // namespace

PlaceOnOutline read_place(const JsonNode& node, const std::string& path) {
  constexpr const char* kPlace =
      R"(an array [edge, share], or {"polygon": 0, "edge": 0, "share": "1/2"})";
  PlaceOnOutline place;
  std::string share = element_path(path, 1);
  if (node.kind == Kind::kObject) {
    expect_object(node, path, {"polygon", "edge", "share"});
    share = member_path(path, "share");
    const auto number = [&](const char* key) {
      return read_number(member(node, path, key, kPlace), member_path(path, key));
    };
    if (node.find("polygon") != nullptr) place.polygon = number("polygon");
    place.edge = number("edge");
    place.share = number("share");
  } else {
    const std::vector<Rational> both = read_vector(node, path, 2, kPlace);
    place.edge = both[0];
    place.share = both[1];
  }
  if (place.share.sign() < 0 || place.share > 1) {
    fail_at(share, "the value is " + to_string(place.share),
            "a share of the edge is from 0, where it begins, to 1");
  }
  return place;
}

std::vector<Polygon> read_outline(const JsonNode& root) {
  const JsonNode* node = root.find("outline");
  if (node == nullptr) return {};
  const std::string path = "outline";
  expect(*node, Kind::kArray, path, kForm);
  if (node->children.empty()) fail_at(path, "the list is empty", "give a polygon, or no list");
  constexpr int kRing = 2;
  constexpr int kPolygon = 3;
  const int depth = depth_of(*node);
  std::vector<Polygon> outline =
      depth <= kRing      ? std::vector<Polygon>(1, Polygon(1, read_ring(*node, path)))
      : depth == kPolygon ? std::vector<Polygon>(1, read_polygon(*node, path))
                          : read_list(*node, path, kForm, read_polygon);
  check_outline(outline);
  return outline;
}

std::shared_ptr<const Mesh> read_surface(const JsonNode& root, const std::string& key) {
  const JsonNode* node = root.find(key);
  if (node == nullptr) return nullptr;
  constexpr const char* kBody = R"({"vertices": [[x, y, z], ...], "faces": [[0, 1, 2], ...]})";
  constexpr const char* kVertices = "a list of vertices [[x, y, z], ...]";
  constexpr const char* kFaces =
      "a list of faces [[0, 1, 2], ...], each of the numbers of three vertices or more";
  expect_object(*node, key, {"vertices", "faces"});
  Mesh body;
  body.vertices = read_list(member(*node, key, "vertices", kBody), key + ".vertices", kVertices,
                            [](const JsonNode& vertex, const std::string& path) -> Vector3 {
                              std::vector<Rational> v = read_vector(
                                  vertex, path, 3, "an array of three numbers [x, y, z]");
                              return {std::move(v[0]), std::move(v[1]), std::move(v[2])};
                            });
  const std::size_t count = body.vertices.size();
  const std::string range = count == 0
                                ? "the body has no vertices"
                                : "the body has " + numbered(count, "vertex", "vertices");
  const auto read_vertex_of = [&](const JsonNode& index, const std::string& path) {
    return read_index(read_number(index, path), count, path, range);
  };
  body.faces = read_list(member(*node, key, "faces", kBody), key + ".faces", kFaces,
                         [&](const JsonNode& face, const std::string& path) {
                           auto vertices = read_list(face, path, kFaces, read_vertex_of);
                           if (vertices.size() < 3) {
                             fail_at(path, "the face has " + std::to_string(vertices.size()),
                                     "a face has three vertices or more");
                           }
                           return vertices;
                         });
  if (body.faces.empty())
    fail_at(key + ".faces", "the list is empty", "give a face, or no " + key);
  return std::make_shared<const Mesh>(std::move(body));
}

const OutlineEdge& edge_at(const std::vector<std::vector<OutlineEdge>>& edges,
                           const PlaceOnOutline& place, const std::string& path) {
  if (edges.empty()) {
    fail_at(path, "the file has no outline",
            "add \"outline\": [[x, y], ...], or give \"position\" and \"normal\"");
  }
  const std::size_t j =
      read_index(place.polygon, edges.size(), path,
                 "the outline has " + numbered(edges.size(), "polygon", "polygons"));
  const std::vector<OutlineEdge>& of_polygon = edges[j];
  return of_polygon[read_index(
      place.edge, of_polygon.size(), path,
      "polygon " + std::to_string(j) + " has " + numbered(of_polygon.size(), "edge", "edges"))];
}

}  // namespace stickslip::core_detail
