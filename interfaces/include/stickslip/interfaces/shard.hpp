// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A batch in shards. Each is decided on a machine of its own and written to a file of its own:
/// the first line of that file, the *head*, says which shard it is, and the results follow.
///
/// Shard I of N has the lines that begin in the I-th of N equally long parts of the bytes of
/// the file of grasps. Line numbers are those of the whole file, so a shard reads the part
/// before its own to count the lines: on average half of the file. (Shards that take every N-th
/// line would each read all of it.) The head also has a hash of the bytes before its part and
/// of those up to its end. Shards are of one file if and only if (but for collisions of 64
/// bits) each begins with the hash that the one before ends with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/interfaces/line.hpp"
#include "stickslip/interfaces/results.hpp"

namespace stickslip {

/// Shard `index` of `count`, from 1.
struct Shard {
  std::size_t index = 1;  ///< its number, at most count
  std::size_t count = 1;  ///< the number of shards
};

/// Reads "2/4", the value of --shard. Throws InputError naming the option.
Shard shard_option(const std::string& value);

/// Returns "2/4".
std::string to_string(const Shard& shard);

/// The first line of a shard's file.
struct ShardHead {
  Shard shard{};               ///< the shard
  std::string options{};       ///< LineDecider::options_key
  std::size_t first_line = 1;  ///< the number of its first line
  std::size_t lines = 0;       ///< its number of lines, blank ones counted
  std::size_t results = 0;     ///< the number of results that there will be
  std::string before{};        ///< the hash of the file before this shard
  std::string after{};         ///< the hash of the file up to this shard's end
};

/// Returns the line of JSON, with its end.
std::string head_text(const ShardHead& head);

/// Reads the head that a shard's file begins with; nothing if the file has no whole line.
/// Throws InputError naming `file` if the line is no head.
std::optional<ShardHead> read_head(std::istream& in, const std::string& file);

/// A shard of a file of grasps: its part of the file, and its head.
struct MeasuredShard {
  FilePart part{};   ///< the part of the file
  ShardHead head{};  ///< the head of the results
};

/// Reads the file of `bytes` bytes up to the end of the shard.
MeasuredShard measure_shard(std::istream& grasps, std::uintmax_t bytes, const Shard& shard,
                            const LineDecider& decider);

/// A shard's file with all its results.
struct CompleteShard {
  std::string file{};        ///< its name
  ShardHead head{};          ///< its first line
  std::uintmax_t begin = 0;  ///< the byte where the results begin
  std::uintmax_t end = 0;    ///< the size of the file
};

/// All shards of a batch, in their order.
struct CompleteShards {
  std::vector<CompleteShard> shards{};  ///< the results, one file after the other
  BatchTally tally{};                   ///< of all results
};

/// Reads the files, which must be all shards of one batch, each once and complete. Throws
/// InputError naming the file or the shard that is not as it should be.
CompleteShards complete_shards(const std::vector<std::string>& files);

}  // namespace stickslip
