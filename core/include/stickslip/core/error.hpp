// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The two ways to be wrong: bad input from a user (InputError, with place and
/// remedy) and a broken contract inside a program (ContractError). Both are checked
/// in every build type. And what messages are made of.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// Bad input. `file` may be empty when the data did not come from a file; `place` is a
/// JSON path such as "contacts[2].normal", a "line:column", or an option name.
class InputError : public std::runtime_error {
 public:
  /// what() is "file: place: problem; remedy", without the parts that are empty.
  InputError(std::string file, std::string place, std::string problem, std::string remedy);

  const std::string& file() const { return file_; }        ///< may be empty
  const std::string& place() const { return place_; }      ///< where in the input
  const std::string& problem() const { return problem_; }  ///< what is wrong there
  const std::string& remedy() const { return remedy_; }    ///< what would be right

  /// The same error, naming the file it came from.
  InputError in_file(const std::string& file) const;

 private:
  std::string file_;
  std::string place_;
  std::string problem_;
  std::string remedy_;
};

/// `text` as it may stand in a message: in double quotes, control characters escaped, and
/// cut after some forty characters.
std::string quote(std::string_view text);

/// `did you mean "..."? `, of the known word that is nearest to one that is not known. Nothing
/// if none is near: at most half of its characters may be wrong, not counting the dashes of
/// options.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

/// The same, and then all that is known: `introduction`, and the words with commas between.
std::string choice_of(const std::string& word, const std::vector<std::string>& known,
                      const std::string& introduction);

/// A caller broke a documented requirement, or an internal check failed.
class ContractError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws ContractError when `condition` is false, in every build type.
void require(bool condition, const char* message);

}  // namespace stickslip
