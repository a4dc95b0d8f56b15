// SPDX-License-Identifier: GPL-3.0-or-later
// Resistible regions of generated grasps, in the plane of forces: time and work; and, where
// there are few contacts, the time with each piece exactly, and of a proof. Exit code 1 if the
// pieces do not make up the region.
//
//     region_bench [largest m, default 100] [--pieces M] [--proof M] [--limit SECONDS]
//                  [--family NAME]
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "child.hpp"
#include "grasps.hpp"
#include "limited.hpp"
#include "loads.hpp"
#include "stickslip/measures/region_proof.hpp"

namespace stickslip::bench {
namespace {

struct Row {
  Layout layout;
  std::size_t contacts;
  bool preloaded;
};

Problem problem_of(const Row& row) {
  return Problem({make_grasp(row.layout, row.contacts, row.preloaded, 1), {0, 0, 0}},
                 NormalLaw::kUnilateral);
}

std::size_t vertices_of(const PlaneUnion& region) {
  std::size_t count = region.points.size();
  for (const PlaneArea& area : region.areas) {
    for (const Outline& outline : area.outlines) count += outline.vertices.size();
  }
  for (const PlaneCell& curve : region.curves) count += curve.vertices().size();
  return count;
}

ResistibleSet with_pieces(const Problem& problem) {
  ResistibleOptions options;
  options.pieces = true;
  return std::get<ResistibleSet>(resistible_set(problem, WrenchPlane::forces(), options));
}

std::string region_columns(const Row& row) {
  ResistibleWork work;
  PlaneUnion region;
  const double seconds = seconds_per_call(
      [&] {
        region = std::get<ResistibleSet>(
                     resistible_set(problem_of(row), WrenchPlane::forces(), {}, &work))
                     .region;
      },
      1, 0);
  std::ostringstream text;
  text.precision(3);
  text << seconds << " | " << work.nodes << " | " << work.modes << " | " << work.pieces << " | "
       << work.borders << " | " << work.exact_images << " | " << work.exact_turns << " | "
       << work.exact_sections << " | " << vertices_of(region);
  return text.str();
}

/// The region with its pieces, each exactly: the time, and whether they make up the region.
std::string pieces_columns(const Row& row) {
  const Problem problem = problem_of(row);
  ResistibleSet found;
  const double seconds = seconds_per_call([&] { found = with_pieces(problem); }, 1, 0);
  std::vector<PlaneCell> cells;
  for (const ResistiblePiece& piece : found.pieces) cells.push_back(piece.cell);
  const bool same = unite(cells) == found.region;
  std::ostringstream text;
  text.precision(3);
  text << seconds << (same ? "" : " DIFFERENT");
  return text.str();
}

/// The time to prove what pieces say, and the work.
std::string proof_columns(const Row& row) {
  const Problem problem = problem_of(row);
  const std::vector<ResistiblePiece> pieces = with_pieces(problem).pieces;
  RegionProofWork work;
  RegionProof proof;
  const double seconds = seconds_per_call(
      [&] {
        proof = std::get<RegionProof>(
            prove_region(problem, WrenchPlane::forces(), pieces, {}, &work));
      },
      1, 0);
  std::ostringstream text;
  text.precision(3);
  text << seconds << " | " << proof.pieces.size() << " | " << work.cells << " | " << work.nodes
       << " | " << work.programs;
  return text.str();
}

int run(std::size_t largest, std::size_t largest_listed, std::size_t largest_proof,
        double limit, const std::string& only) {
  std::puts(
      "| family | preload | m | with pieces, s | region, s | nodes | modes | pieces | borders "
      "| "
      "exact images | exact turns | exact pieces | vertices | proof, s | proved pieces | cells "
      "| "
      "proof nodes | programs |");
  std::puts("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  bool all_same = true;
  for (const Layout layout : {Layout::kRound, Layout::kVaried, Layout::kArc, Layout::kGrid}) {
    if (!only.empty() && only != name_of(layout)) continue;
    for (const bool preloaded : {true, false}) {
      for (const std::size_t m : {8, 16, 32, 64, 100}) {
        if (m > largest) break;
        const Row row{layout, m, preloaded};
        std::string pieces = "-";
        if (m <= largest_listed) {
          pieces =
              run_limited(limit, [&] { return pieces_columns(row); }).value_or("not in time");
        }
        all_same = all_same && pieces.find("DIFFERENT") == std::string::npos;
        const std::string region = run_limited(limit, [&] {
                                     return region_columns(row);
                                   }).value_or("not in time | | | | | | | |");
        std::string proof = "- | | | |";
        if (m <= largest_proof) {
          proof = run_limited(limit, [&] {
                    return proof_columns(row);
                  }).value_or("not in time | | | |");
        }
        std::printf("| %s | %s | %zu | %s | %s | %s |\n", name_of(layout),
                    preloaded ? "yes" : "no", m, pieces.c_str(), region.c_str(), proof.c_str());
        std::fflush(stdout);
      }
    }
  }
  return all_same ? 0 : 1;
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  stickslip::bench::Arguments arguments(
      "region_bench", "Resistible regions of generated grasps: time and work.");
  stickslip::Command& app = arguments.described();
  std::size_t largest = 100;
  std::size_t largest_listed = 16;
  std::size_t largest_proof = 8;
  double limit = 600;
  std::string only;
  app.add_option("LARGEST_M", largest, "Contacts: 8, 16, 32, 64, 100, up to this")
      ->capture_default_str();
  app.add_option("--pieces", largest_listed, "The pieces too, up to so many contacts")
      ->capture_default_str();
  app.add_option("--proof", largest_proof, "Proofs too, up to so many contacts")
      ->capture_default_str();
  app.add_option("--limit", limit, "Seconds for one measurement")->capture_default_str();
  app.add_option("--family", only, "This family alone");
  if (const auto code = arguments.read(argc, argv)) return *code;
  return stickslip::bench::run(largest, largest_listed, largest_proof, limit, only);
}
