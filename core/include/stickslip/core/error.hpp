// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The two kinds of error: bad input from a user (InputError, with place and remedy) and a
/// broken contract inside a program (ContractError). Both are checked in every build type. The
/// functions that put together the words of messages are here as well.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// An error in the input. `file` may be empty when the data did not come from a file; `place`
/// is a JSON path such as "contacts[2].normal", a "line:column", or an option name.
class InputError : public std::runtime_error {
 public:
  /// Makes the error. what() is "file: place: problem; remedy", without the parts that are
  /// empty.
  InputError(std::string file, std::string place, std::string problem, std::string remedy);

  const std::string& file() const { return file_; }        ///< the file; may be empty
  const std::string& place() const { return place_; }      ///< the place in the input
  const std::string& problem() const { return problem_; }  ///< the fault at that place
  const std::string& remedy() const { return remedy_; }    ///< the right thing to do there

  /// Returns the same error, naming the file it came from.
  InputError in_file(const std::string& file) const;

 private:
  std::string file_;
  std::string place_;
  std::string problem_;
  std::string remedy_;
};

/// Returns `text` for use in a message: in double quotes, with control characters escaped, and
/// cut after some forty characters.
std::string quote(std::string_view text);

/// Returns `did you mean "..."? ` with the known word that is nearest to an unknown one; an
/// empty string if none is near. At most half of its characters may be wrong, not counting the
/// dashes of options.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

/// Returns the same, followed by `introduction` and all known words with commas between them.
std::string choice_of(const std::string& word, const std::vector<std::string>& known,
                      const std::string& introduction);

/// An error of the program: a caller broke a documented requirement, or an internal check
/// failed.
class ContractError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws ContractError when `condition` is false, in every build type.
void require(bool condition, const char* message);

}  // namespace stickslip
