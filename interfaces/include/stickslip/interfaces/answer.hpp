// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The page's answer about a grasp, one JSON object, "stickslip-page/1" (docs/page.md).
///
/// Exact numbers are strings, each with its nearest double in a member X_float beside it;
/// numbers for drawing are doubles. A part that was not asked for is left out. A part that
/// cannot be had is null, and a sentence of `messages` says why.
///
/// - `format` is "stickslip-page/1"; `live`: whether a server answers further questions.
/// - `name` of the grasp; `dimension` of a body's motions, 3 in the plane and 6 in space.
/// - `grasp`: the grasp file as text, of version 2, or 3 of several bodies. Places on the
///   outline are written as positions and normals, and loads as a wrench. In space it has the
///   bodies that are given; the texts of `examples` and the files in `decide` leave them out.
/// - `question`: `wrench`, `case`, `preload`, `normal_law` and `uncertain`, as text; a member
///   is null if the file's own is asked about.
/// - `cases`: the names of the file's cases. If there are some and none is chosen, the first is
///   asked about.
/// - `contacts`: `position`, `normal` (of length 1), `friction`, `stiffness`, `preload` and, if
///   it is not 0, `torsion` of each, and `wrench`, the load: doubles, of intervals their
///   middle.
/// - `outline`: a list of rings of points, or null.
/// - `mechanism`: null, or of several bodies `coordinates`, the names of those of a state z;
///   `bodies`, of each its `name`, `outline`, `link` (null, or `slides`, `at`, `axis` and `on`)
///   and `motion`, the rows of J, with which it moves by J z; and `springs`, `kind`, `name` and
///   `place` of each. A contact then has `of` and `by`, indices of bodies, null of the ground.
/// - `decide`: the output of `decide --json --floats`; `certificate`: its text, or null.
/// - `near`: for a stable verdict that is proved without stating an equilibrium, a motion and
///   forces near one, for drawing: `twist_float`, and of `contacts` `force_float` and `closed`.
///   It proves nothing.
/// - `examples`: for a fragile verdict the answers about its two grasps, `stable` and
///   `unstable`, with `decide` and the members that it brings; else null, and also if the
///   verdict's time is limited.
/// - `states`: the sphere of motions, cut by a circle for each contact. `circles`: of each [a,
///   b, c], for a x + b y + c r = 0. `vertices`: a motion (x, y, r) each. `cells`: `kind`
///   (face, edge or vertex), a `motion` inside, `states` (a character a contact; exact), and
///   `boundary`, indices of vertices: of a face in order, counterclockwise from outside.
///   Vectors have length 1.
/// - `region`: the output of `region --json --floats`, about forces with the torque of the
///   load; in space about forces along the two axes along which the load has most. Null of
///   several bodies, as are `states` and `map`.
/// - `margin`: the output of `margin --json --floats` along the load.
/// - `map`: the output of `map --json --floats` over factors of friction and load, from 0 to 2.
/// - `quality`: the output of `quality --json --floats`, to 5 %, with the ball's point, length
///   and body of the question, if it has a ball. Of several bodies null without one.
/// - `lost`: the answer about the load of `quality` that is not resisted, with `decide` and the
///   members that it brings; null if there is no such load.
/// - `compare`: the output of `compare --json --floats`, with the length of the question's ball
///   if it has one. Null of several bodies.
/// - `messages`: sentences for people. If only loads in a ball are uncertain, `region`,
///   `margin`, `map` and `compare` are about the load in the centre.
#pragma once

#include <chrono>
#include <cstddef>
#include <set>
#include <string>

#include "stickslip/core/number_text.hpp"
#include "stickslip/interfaces/question_text.hpp"

namespace stickslip {

/// \{ The most contacts whose cells are listed, and whose region is found.
inline constexpr std::size_t kMostContactsWithCells = 20;
inline constexpr std::size_t kMostContactsWithRegion = 100;
/// \}

/// A part of the object that may be asked for.
enum class PagePart {
  kDecide,    ///< the verdict; brings `certificate`, `near`, `examples`
  kStates,    ///< the sphere of motions
  kRegion,    ///< the resisted loads of a plane
  kMargin,    ///< the multiples of the load
  kMap,       ///< verdicts over friction and load
  kQuality,   ///< brings `lost`
  kCompare,   ///< what earlier methods say
  kWarnings,  ///< the model's traps in `decide`; they take longer than the verdict
};
using PageParts = std::set<PagePart>;  ///< the parts that are asked for

/// Returns all parts.
PageParts all_page_parts();

/// The limits of the work for each part.
struct PageLimits {
  std::size_t node_limit = 0;         ///< the limit of each search, as of `stickslip decide`
  std::chrono::milliseconds time{0};  ///< 0: none
  bool limits_verdict = false;        ///< whether the time limits the verdict, too
};

/// Returns the object. `name` stands for the file in errors. Throws InputError if the question
/// cannot be asked.
Json page_answer(const GraspFile& file, const QuestionText& asked, const PageParts& parts,
                 const PageLimits& limits, const std::string& name);

/// A server's reply to a request.
struct PageReply {
  int status;        ///< the HTTP status: 200, or 400 if the request is wrong
  std::string body;  ///< JSON
};

/// Returns the reply to `{"grasp": TEXT, "options": {...}, "parts": [...]}`: a live answer with
/// these parts, all if none are named, or `{"error": {"message", "place"}}`. The options are
/// those of `question`; a wrench may be an array of numbers, and `"bilateral": true` is a
/// normal law. `"snap": true` asks about the grasp with rational unit normals in the plane, as
/// `stickslip snap` makes it; that is then the answer's `grasp`. `"warnings": false` is
/// quicker. A wrong request throws nothing; a Cancellation in force throws as usual.
PageReply reply_to(const std::string& request, const PageLimits& limits);

}  // namespace stickslip
