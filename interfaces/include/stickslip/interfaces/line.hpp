// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A line of a batch, from the file of grasps to its line of results. `stickslip batch` and the
/// workers of `python3 -m stickslip.batch` both do this with a line, so their results are the
/// same byte for byte.
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
#include "stickslip/interfaces/comparison_answer.hpp"
#include "stickslip/interfaces/quality_answer.hpp"
#include "stickslip/interfaces/states_answer.hpp"

namespace stickslip {

/// The lines of a file that begin at its bytes from `begin` to before `end`; by default all.
struct FilePart {
  std::uintmax_t begin = 0;  ///< the byte where a line begins
  std::uintmax_t end = std::numeric_limits<std::uintmax_t>::max();  ///< the first byte behind
                                                                    ///< the part
  std::size_t lines_before = 0;                                     ///< blank ones counted
};

/// A line that is not blank.
struct BatchLine {
  std::size_t number = 0;  ///< its number in the file, from 1, blank lines counted
  std::string text{};      ///< without its end; empty if it is too long
  std::optional<InputError> unreadable{};  ///< the error, if the line is too long
};

/// The lines of a part of a file, one at a time; memory holds one.
class BatchLines {
 public:
  /// Reads from `in`, which must outlive this. Goes to the beginning of the part, unless that
  /// is the beginning of the file.
  explicit BatchLines(std::istream& in, const FilePart& part = {});

  std::optional<BatchLine> next();  ///< nothing at the end of the part
  void put_back(BatchLine line);    ///< puts back the last line, which is then the next

  std::size_t number() const {
    return put_back_ ? number_before_ : lines_.number();
  }  ///< the number of the last line read
  std::uintmax_t end() const {
    return put_back_ ? end_before_ : lines_.end();
  }  ///< the byte where the next line begins

 private:
  TextLines lines_;
  std::uintmax_t end_;
  std::optional<BatchLine> put_back_;
  std::size_t number_before_ = 0;  ///< the last line
  std::uintmax_t end_before_ = 0;
};

/// The outcome of a line.
enum class LineOutcome { kDecided, kUndecided, kUnreadable };

/// A line of results.
struct LineResult {
  std::size_t number = 0;                       ///< the number of the line that was decided
  std::string text{};                           ///< the result with its end of line
  LineOutcome outcome = LineOutcome::kDecided;  ///< the outcome that the text states
};

/// The question about every line.
struct BatchOptions {
  QuestionOptions question{};  ///< the question by the command's options
  std::size_t node_limit = 0;  ///< the limit for each line; 0 is none
  /// The numbers of inertia_of, to ask for the class of rigid contacts, not the verdict. An
  /// empty row is a centre of mass in the origin and a radius of gyration of 1.
  std::optional<RationalRow> inertia{};
  /// The balls of the quality to ask for beside the verdict. Not with `inertia`.
  std::optional<QualityAsked> quality{};
  /// The states to count in place of a verdict. Not with `inertia`, `quality` or certificates.
  std::optional<StatesAsked> states{};
  /// The methods and measures to ask in place of a verdict. Not with these or certificates.
  std::optional<ComparisonAsked> measures{};
  std::string certificates{};  ///< the folder for certificates, as results name it; or empty
  std::string certificate_folder{};  ///< the same folder, as this process finds it
};

/// Decides lines. Threads may share one.
class LineDecider {
 public:
  explicit LineDecider(BatchOptions options);  ///< takes the options of all lines

  /// Returns 16 digits that tell whether a result is that of this line and these options. They
  /// prove nothing.
  std::string key(const std::string& line) const;

  /// Returns 16 digits that tell whether results are of the same options, certificates
  /// included.
  std::string options_key() const;

  /// Returns the line's result, with its certificate written if a folder was named. An error in
  /// the line is its result. Throws InputError if the certificate cannot be written.
  LineResult decide(const BatchLine& line) const;

  /// Returns the result of a line that has no verdict, for this reason.
  LineResult failed(const BatchLine& line, const InputError& error) const;

 private:
  /// Adds the counts of states to the result. Returns whether the limit ended them.
  LineOutcome add_states(Json& result, const std::string& line) const;

  /// Adds the rows of a comparison to the result.
  void add_measures(Json& result, const std::string& line) const;

  /// Adds the quality to the result of a question that is stable. Returns the certificate of
  /// the ball of loads that is resisted; empty if there is none.
  std::string add_quality(Json& result, const Question& question,
                          const std::string& line) const;

  BatchOptions options_;
  std::string options_text_;
};

/// Makes the folder for certificates. With `resume`, removes the files of write_whole_file that
/// a killed run left there: what it was writing is to be written again.
void open_certificate_folder(const std::string& folder, bool resume);

}  // namespace stickslip
