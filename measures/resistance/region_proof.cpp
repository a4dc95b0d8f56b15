// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/region_proof.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "cell_refuter.hpp"
#include "engine/equilibrium/search_end.hpp"
#include "engine/planar/region_program.hpp"
#include "load_cell.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace resistance_detail;

namespace {

/// A convex set of loads that one mode resists.
struct ModePiece {
  std::vector<ContactMode> mode;
  ConvexLoads loads;
};

/// Returns the pieces that lie in no other.
std::vector<ModePiece> largest_of(const std::vector<ResistiblePiece>& pieces) {
  std::vector<ModePiece> found;
  for (const ResistiblePiece& piece : pieces) {
    found.push_back({piece.modes, ConvexLoads(piece.cell)});
  }
  // The larger pieces come first, so that of equal ones the first stays.
  std::stable_sort(found.begin(), found.end(), [](const ModePiece& a, const ModePiece& b) {
    return a.loads.cell.dimension() > b.loads.cell.dimension();
  });
  std::vector<char> kept(found.size(), 1);
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (std::size_t other = 0; other < found.size() && kept[k] != 0; ++other) {
      if (other == k || kept[other] == 0) continue;
      if (found[k].loads.is_within(found[other].loads)) kept[k] = 0;
    }
  }
  std::vector<ModePiece> result;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (kept[k] != 0) result.push_back(std::move(found[k]));
  }
  return result;
}

/// Returns an equilibrium of the closed mode under a load that it resists.
ShortWitness witness_in(const Problem& problem, const std::vector<ContactMode>& mode) {
  const auto outcome = solve_region(problem, Region::of_mode(problem, mode), nullptr);
  const auto* point = std::get_if<RelaxedPoint>(&outcome);
  require(point != nullptr && !point->broken, "a corner of a mode's piece is resisted by it");
  return in_short(problem.rows(), point->witness);
}

/// Splits the plane into cells that lie in a piece or meet none.
class Partition {
 public:
  Partition(const Problem& problem, const WrenchPlane& plane, std::vector<ModePiece> pieces,
            const RegionProofOptions& options, RegionProofWork& work)
      : problem_(problem),
        plane_(plane),
        pieces_(std::move(pieces)),
        numbers_(pieces_.size()),
        work_(work),
        node_limit_(options.node_limit),
        refuter_(problem, plane, options, work) {
    std::vector<PlaneCell> cells;
    for (const ModePiece& piece : pieces_) cells.push_back(piece.loads.cell);
    const PlaneUnion region = unite(cells);
    for (const PlaneArea& area : region.areas) {
      for (const Outline& outline : area.outlines) {
        for (const PlaneEdge& edge : outline.edges()) {
          borders_.push_back({ConvexLoads(PlaneCell::hull({edge.from, edge.to})),
                              primitive(cross(edge.from, edge.to))});
        }
      }
    }
    for (const PlaneCell& curve : region.curves) {
      ConvexLoads loads(curve);
      const LoadFunction across = loads.sides.front();
      borders_.push_back({std::move(loads), across});
    }
  }

  /// Builds the proof. Returns why it failed, or nothing.
  std::optional<Undecided> build() {
    std::vector<std::size_t> all_pieces(pieces_.size());
    for (std::size_t k = 0; k < all_pieces.size(); ++k) all_pieces[k] = k;
    std::vector<std::size_t> all_borders(borders_.size());
    for (std::size_t k = 0; k < all_borders.size(); ++k) all_borders[k] = k;
    return append(LoadCell(), all_pieces, all_borders, 0);
  }

  RegionProof proof;

 private:
  /// A part of the region's border. The region is where f >= 0, at least next to it.
  struct Border {
    ConvexLoads loads;
    LoadFunction f;
  };

  std::optional<Undecided> append(const LoadCell& cell,
                                  const std::vector<std::size_t>& pieces_before,
                                  const std::vector<std::size_t>& borders_before,
                                  std::size_t depth) {
    // The limit is far below the format's, so that the searches have room.
    constexpr std::size_t kDeepest = 240;
    if (depth > kDeepest) {
      return Undecided{"the outlines of the region cut each other too often for a proof",
                       "depth"};
    }
    std::vector<std::size_t> pieces;
    for (const std::size_t k : pieces_before) {
      if (cell.meets(pieces_[k].loads)) pieces.push_back(k);
    }
    if (pieces.empty()) {
      ++work_.cells;
      if (!refuter_.refute(cell, proof.tree)) {
        return limit_reached(node_limit_);
      }
      return std::nullopt;
    }
    for (const std::size_t k : pieces) {
      if (!cell.closure().is_within(pieces_[k].loads)) continue;
      ++work_.held;
      proof.tree.push_back(HeldLeaf{number_of(k)});
      return std::nullopt;
    }
    std::vector<std::size_t> borders;
    for (const std::size_t k : borders_before) {
      const Border& border = borders_[k];
      if (cell.closure().signs(border.f).are_mixed() && cell.meets(border.loads)) {
        borders.push_back(k);
      }
    }
    const LoadFunction f =
        borders.empty() ? split_of_pieces(cell, pieces) : split_of_borders(borders);
    proof.tree.push_back(LoadSplit{f});
    for (const bool above : {true, false}) {
      const auto part = cell.part(above ? f : negated(f), !above);
      require(part.has_value(), "a split cuts its cell");
      if (auto failed = append(*part, pieces, borders, depth + 1)) return failed;
    }
    return std::nullopt;
  }

  /// Returns the line that cuts the fewest other borders.
  const LoadFunction& split_of_borders(const std::vector<std::size_t>& borders) const {
    const LoadFunction* best = nullptr;
    std::size_t fewest = 0;
    for (const std::size_t k : borders) {
      std::size_t cuts = 0;
      for (const std::size_t other : borders) {
        if (borders_[other].loads.signs(borders_[k].f).are_mixed()) ++cuts;
      }
      if (best != nullptr && cuts >= fewest) continue;
      best = &borders_[k].f;
      fewest = cuts;
    }
    return *best;
  }

  /// Returns a side of a piece that some of the cell is beyond: the one that cuts the fewest
  /// pieces, and then the one that leaves most of them outside, where f < 0.
  LoadFunction split_of_pieces(const LoadCell& cell,
                               const std::vector<std::size_t>& pieces) const {
    const LoadFunction* best = nullptr;
    std::pair<std::size_t, std::size_t> least;
    constexpr std::size_t kMostCandidates = 60;
    std::size_t candidates = 0;
    for (const std::size_t k : pieces) {
      for (const LoadFunction& f : pieces_[k].loads.sides) {
        const LoadSigns signs = cell.closure().signs(f);
        if (!signs.negative) continue;
        // A piece may also touch the cell, where that is closed, from outside; its side is a
        // last resort.
        std::pair<std::size_t, std::size_t> score{signs.positive ? 0 : pieces_.size() + 1, 0};
        for (const std::size_t other : pieces) {
          const LoadSigns there = pieces_[other].loads.signs(f);
          if (there.are_mixed()) ++score.first;
          if (!there.negative) ++score.second;
        }
        if (best != nullptr && !(score < least)) continue;
        best = &f;
        least = score;
      }
      if (++candidates == kMostCandidates && best != nullptr) break;
    }
    require(best != nullptr, "a cell that lies in no piece is cut by a side of one");
    return *best;
  }

  /// Returns the number of a piece in the proof; adds the piece if it is new there.
  std::size_t number_of(std::size_t index) {
    if (!numbers_[index]) {
      numbers_[index] = proof.pieces.size();
      proof.pieces.push_back(proved(pieces_[index]));
    }
    return *numbers_[index];
  }

  ProvedPiece proved(const ModePiece& piece) const {
    ProvedPiece points;
    for (const HomogeneousPoint& g : piece.loads.generators) {
      ShortWitness witness;
      if (is_at_infinity(g)) {
        std::vector<ContactRow> rows = problem_.rows();
        for (ContactRow& row : rows) row.preload = 0;
        const Wrench load = Rational(g[0]) * plane_.u() + Rational(g[1]) * plane_.v();
        witness = witness_in(Problem(std::move(rows), load, problem_.law()), piece.mode);
      } else {
        witness = witness_in(problem_.with_wrench(plane_.at(point_of(g))), piece.mode);
      }
      points.push_back({g, std::move(witness)});
    }
    return points;
  }

  const Problem& problem_;
  const WrenchPlane& plane_;
  std::vector<ModePiece> pieces_;
  std::vector<std::optional<std::size_t>> numbers_;  ///< by piece: its number in the proof
  std::vector<Border> borders_;
  RegionProofWork& work_;
  std::size_t node_limit_;
  CellRefuter refuter_;
};

}  // namespace

std::variant<RegionProof, Undecided> prove_region(const Problem& problem,
                                                  const WrenchPlane& plane,
                                                  const std::vector<ResistiblePiece>& pieces,
                                                  const RegionProofOptions& options,
                                                  RegionProofWork* work) {
  RegionProofWork unused;
  RegionProofWork& counters = work != nullptr ? *work : unused;
  counters = {};
  require(!problem.is_family(), "the loads of a plane are no family");
  Partition partition(problem, plane, largest_of(pieces), options, counters);
  if (auto failed = partition.build()) return std::move(*failed);
  return std::move(partition.proof);
}

}  // namespace stickslip
