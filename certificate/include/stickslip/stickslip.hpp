// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The first header to read: grasps, questions, verdicts and their proofs.
///
/// examples/decide.cpp is a whole program, linked with stickslip::certificate:
///
/// - read_any_grasp_file() reads a file (docs/grasp_file.md), and ask() makes a Question of it;
///   QuestionOptions replace the load, the preload, or the normal law.
/// - decide() returns an Answer. Its Verdict is Stable, Unstable, Fragile or Undecided, each
///   with its evidence: motion and forces, a tree, two grasps, a reason.
/// - certificate_of() writes the proof of an answer (certificate/FORMAT.md), and refusal_of()
///   has stickslip-check judge it, which shares no code with what found it.
///
/// Numbers are Rational, exact (number.hpp). Whatever is wrong in a file or an option is an
/// InputError with its place (error.hpp). The modules behind it are explained in
/// docs/development.md; measures/ has margins, radii, maps, qualities and preloads.
#pragma once

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide.hpp"
