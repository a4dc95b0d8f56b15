// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A batch in shards, each decided on a machine of its own and written to a file of its own:
/// the first line of that file, the *head*, says of what it is a shard, and the results follow.
///
/// Shard I of N has the lines that begin in the I-th of N equally long parts of the bytes of
/// the file of grasps. Line numbers are those of the whole file, so a shard reads what stands
/// before its part, to count the lines: on average half of the file, whereas of shards that
/// take every N-th line each would read all of it. And what it has read goes into the head, as
/// a hash of the bytes before its part and of those up to its end: shards are of one file if
/// and only if (but for collisions of 64 bits) each begins with the hash that the one before
/// ends with.
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
  std::size_t index = 1;  ///< at most count
  std::size_t count = 1;  ///< of shards
};

/// "2/4" in the value of --shard. Throws InputError naming the option.
Shard shard_option(const std::string& value);

/// "2/4"
std::string to_string(const Shard& shard);

/// What the first line of a shard's file says.
struct ShardHead {
  Shard shard{};               ///< which one it is
  std::string options{};       ///< LineDecider::options_key
  std::size_t first_line = 1;  ///< its number
  std::size_t lines = 0;       ///< blank ones counted
  std::size_t results = 0;     ///< that there will be
  std::string before{};        ///< hash of the file before this shard
  std::string after{};         ///< hash of the file up to this shard's end
};

/// The line of JSON, with its end.
std::string head_text(const ShardHead& head);

/// Reads the head that a shard's file begins with; nothing if the file has no whole line.
/// Throws InputError naming `file` if the line is no head.
std::optional<ShardHead> read_head(std::istream& in, const std::string& file);

/// A shard of a file of grasps.
struct MeasuredShard {
  FilePart part{};   ///< of the file
  ShardHead head{};  ///< of the results
};

/// Reads the file of `bytes` bytes up to the end of the shard.
MeasuredShard measure_shard(std::istream& grasps, std::uintmax_t bytes, const Shard& shard,
                            const LineDecider& decider);

/// A shard's file with all its results.
struct CompleteShard {
  std::string file{};        ///< its name
  ShardHead head{};          ///< its first line
  std::uintmax_t begin = 0;  ///< of the results in the file
  std::uintmax_t end = 0;    ///< of the file
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
