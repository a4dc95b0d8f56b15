// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Two naive oracles for the faces of an arrangement, which share nothing with the enumerator:
/// linear programs, one for each sign vector that could be, and Zaslavsky's count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "stickslip/arrangement/faces.hpp"

namespace stickslip::test {

/// Returns all sign vectors in {+, -, 0}^n that some point has and that have the signs that are
/// asked, as texts, sorted; '.' where a plane does not count. Takes 3^n linear programs.
std::vector<std::string> faces_by_programs(std::size_t coordinates,
                                           const std::vector<FacePlane>& planes);

/// Returns the number of faces of each dimension of an arrangement without conditions. The
/// faces of dimension k are the chambers of all restrictions to flats of dimension k, and
/// chambers(A) = chambers(A without h) + chambers(A restricted to h) (Zaslavsky, 1975).
std::vector<std::uint64_t> faces_by_restriction(std::size_t coordinates,
                                                const std::vector<Row>& rows);

/// Returns the signs of all planes on a face, '.' where one does not count.
std::string signs_of(const Face& face, std::size_t planes);

/// Visits all faces, checks of each that its motion has its signs and that it comes once, and
/// of the counts that they are those of the faces and of count_faces(). Returns the sorted
/// signs.
std::vector<std::string> checked_faces(std::size_t coordinates,
                                       const std::vector<FacePlane>& planes,
                                       const FaceOptions& options = {});

}  // namespace stickslip::test
