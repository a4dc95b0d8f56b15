// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A line of a batch, from the file of grasps to its line of results. What `stickslip batch`
/// and the workers of `python3 -m stickslip.batch` do with a line is this, so their results are
/// the same byte for byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <optional>
#include <string>

#include "stickslip/core/error.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/quality_answer.hpp"

namespace stickslip {

/// The lines of a file that begin at its bytes from `begin` to before `end`; by default all.
struct FilePart {
  std::uintmax_t begin = 0;                                         ///< where a line begins
  std::uintmax_t end = std::numeric_limits<std::uintmax_t>::max();  ///< not in the part
  std::size_t lines_before = 0;                                     ///< blank ones counted
};

/// A line that is not blank.
struct BatchLine {
  std::size_t number = 0;                  ///< in the file, from 1, blank ones counted
  std::string text{};                      ///< without its end; empty if it is too long
  std::optional<InputError> unreadable{};  ///< why, if it is too long
};

/// The lines of a part of a file, one at a time; memory holds one.
class BatchLines {
 public:
  /// Reads from `in`, which must outlive this; goes to where the part begins, if that is not
  /// the beginning.
  explicit BatchLines(std::istream& in, const FilePart& part = {});

  std::optional<BatchLine> next();  ///< nothing at the end of the part
  void put_back(BatchLine line);    ///< the last, which is then the next

  std::size_t number() const {
    return put_back_ ? number_before_ : lines_.number();
  }  ///< of the last line read
  std::uintmax_t end() const {
    return put_back_ ? end_before_ : lines_.end();
  }  ///< where the next line begins

 private:
  TextLines lines_;
  std::uintmax_t end_;
  std::optional<BatchLine> put_back_;
  std::size_t number_before_ = 0;  ///< the last line
  std::uintmax_t end_before_ = 0;
};

/// What became of a line.
enum class LineOutcome { kDecided, kUndecided, kUnreadable };

/// A line of results.
struct LineResult {
  std::size_t number = 0;                       ///< of the line that was decided
  std::string text{};                           ///< with its end
  LineOutcome outcome = LineOutcome::kDecided;  ///< what the text says
};

/// What is asked about every line.
struct BatchOptions {
  QuestionOptions question{};  ///< as the command's options say
  std::size_t node_limit = 0;  ///< of each line; 0 is none
  /// Asks for the class of rigid contacts, not the verdict: the numbers of inertia_of; or none,
  /// for a centre of mass in the origin and a radius of gyration of 1.
  std::optional<RationalRow> inertia{};
  /// Asks for the quality beside the verdict; of balls of this shape. Not with `inertia`.
  std::optional<QualityAsked> quality{};
  std::string certificates{};  ///< the folder for certificates, as results name it; or empty
  std::string certificate_folder{};  ///< the same folder, as this process finds it
};

/// Decides lines. Threads may share one.
class LineDecider {
 public:
  explicit LineDecider(BatchOptions options);  ///< of all lines

  /// 16 digits that tell whether a result is that of this line and these options. Nothing is
  /// proved by them.
  std::string key(const std::string& line) const;

  /// 16 digits that tell whether results are of the same options, certificates included.
  std::string options_key() const;

  /// The line's result, with its certificate written if a folder was named. What is wrong with
  /// the line is its result; throws InputError if the certificate cannot be written.
  LineResult decide(const BatchLine& line) const;

  /// The result of a line that has no verdict, for this reason.
  LineResult failed(const BatchLine& line, const InputError& error) const;

 private:
  /// Of a question that is stable: adds to the result what is known of its quality. The
  /// certificate of the ball of loads that is resisted; empty if there is none.
  std::string add_quality(Json& result, const Question& question,
                          const std::string& line) const;

  BatchOptions options_;
  std::string options_text_;
};

/// Makes the folder for certificates. With `resume`, removes the files of write_whole_file that
/// a killed run left there: what it was writing is to be written again.
void open_certificate_folder(const std::string& folder, bool resume);

}  // namespace stickslip
