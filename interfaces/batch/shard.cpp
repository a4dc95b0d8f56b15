// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/shard.hpp"

#include <algorithm>
#include <charconv>

#include "hash.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip {
namespace {

std::optional<std::size_t> whole_number_in(std::string_view text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

std::optional<Shard> parse_shard(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto index = whole_number_in(text.substr(0, slash));
  const auto count = whole_number_in(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count) return std::nullopt;
  return Shard{*index, *count};
}

/// Returns the member of a head; `good` becomes false if it is not there or of another kind.
std::string member_text(const JsonNode& head, const char* name, JsonNode::Kind kind,
                        bool& good) {
  const JsonNode* const found = head.find(name);
  good = good && found != nullptr && found->kind == kind;
  return good ? found->text : "";
}

std::size_t member_number(const JsonNode& head, const char* name, bool& good) {
  const auto number = whole_number_in(member_text(head, name, JsonNode::Kind::kNumber, good));
  good = good && number.has_value();
  return number.value_or(0);
}

std::optional<ShardHead> parse_head(const std::string& line) {
  JsonNode json;
  try {
    json = parse_json(line);
  } catch (const InputError&) {
    return std::nullopt;
  }
  bool good = true;
  ShardHead head;
  const auto shard = parse_shard(member_text(json, "shard", JsonNode::Kind::kString, good));
  head.options = member_text(json, "options", JsonNode::Kind::kString, good);
  head.first_line = member_number(json, "first_line", good);
  head.lines = member_number(json, "lines", good);
  head.results = member_number(json, "results", good);
  head.before = member_text(json, "before", JsonNode::Kind::kString, good);
  head.after = member_text(json, "after", JsonNode::Kind::kString, good);
  if (!good || !shard) return std::nullopt;
  head.shard = *shard;
  return head;
}

/// Returns where the part of the shard before ends and that of this one begins, unless a line
/// goes on there.
std::uintmax_t cut(std::uintmax_t bytes, std::size_t shards_before, std::size_t count) {
  return bytes / count * shards_before + bytes % count * shards_before / count;
}

void require_one_batch(const std::vector<CompleteShard>& shards) {
  const ShardHead& first = shards.front().head;
  const auto is_other = [&](const CompleteShard& shard, const std::string& why) {
    return InputError(shard.file, "",
                      "shard " + to_string(shard.head.shard) + " is not of the same batch as " +
                          shards.front().file + ": " + why,
                      "merge the shards of one file under the same options");
  };
  for (const CompleteShard& shard : shards) {
    if (shard.head.shard.count != first.shard.count) {
      throw is_other(shard, "that is shard " + to_string(first.shard));
    }
    if (shard.head.options != first.options) throw is_other(shard, "the options differ");
  }
}

void require_each_once(const std::vector<CompleteShard>& shards) {
  std::string missing;
  std::size_t next = 1;
  const std::size_t count = shards.front().head.shard.count;
  constexpr std::size_t kMostNamed = 200;
  const auto expect = [&](std::size_t index) {
    for (; next < index; ++next) {
      if (missing.size() > kMostNamed) continue;
      missing += (missing.empty() ? "" : ", ") + to_string(Shard{next, count});
    }
  };
  for (std::size_t i = 0; i < shards.size(); ++i) {
    const std::size_t index = shards[i].head.shard.index;
    if (i > 0 && shards[i - 1].head.shard.index == index) {
      throw InputError(shards[i].file, "",
                       "this is shard " + to_string(shards[i].head.shard) + ", and so is " +
                           shards[i - 1].file,
                       "name each shard once");
    }
    expect(index);
    next = index + 1;
  }
  expect(count + 1);
  if (!missing.empty()) {
    throw InputError("", "--merge", "missing: shard " + missing,
                     "name the files of all shards");
  }
}

void require_one_file(const std::vector<CompleteShard>& shards) {
  for (std::size_t i = 1; i < shards.size(); ++i) {
    const ShardHead& before = shards[i - 1].head;
    const ShardHead& head = shards[i].head;
    if (head.before == before.after && head.first_line == before.first_line + before.lines) {
      continue;
    }
    throw InputError(shards[i].file, "",
                     "the grasps of shard " + to_string(head.shard) +
                         " do not follow those of " + shards[i - 1].file +
                         ": they are of another file, or the file has changed",
                     "decide all shards of the same file");
  }
}

/// Reads the results of a shard, which must be complete and end with the file.
void read_results(CompleteShard& shard, InputFile& file, BatchTally& tally) {
  const ShardHead& head = shard.head;
  FinishedResults results(file.stream(), shard.file, 1, shard.begin);
  std::size_t line = head.first_line;
  BatchTally found;
  while (const std::optional<FinishedResult> result = results.next()) {
    if (!result->is_as_written) break;
    if (result->line < line || result->line >= head.first_line + head.lines) {
      throw InputError(
          shard.file, "line " + std::to_string(results.lines()),
          "the result of line " + std::to_string(result->line) + " does not belong here",
          "decide this shard again");
    }
    line = result->line + 1;
    found.count(result->line, result->outcome);
  }
  if (results.changed()) {
    throw InputError(shard.file, "line " + std::to_string(*results.changed()),
                     "this result is not as a batch has written it",
                     "decide it again by --shard " + to_string(head.shard) + " and --resume");
  }
  file.stream().clear();
  file.stream().seekg(0, std::ios::end);
  shard.end = static_cast<std::uintmax_t>(file.stream().tellg());
  if (found.results != head.results || results.bytes() != shard.end) {
    throw InputError(shard.file, "",
                     "shard " + to_string(head.shard) + " is incomplete: it has " +
                         std::to_string(found.results) + " of its " +
                         std::to_string(head.results) + " results",
                     "go on with it by --shard " + to_string(head.shard) + " and --resume");
  }
  tally.add(found);
}

}  // namespace

std::string to_string(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

Shard shard_option(const std::string& value) {
  const auto shard = parse_shard(value);
  if (!shard) {
    throw InputError("", "--shard", quote(value) + " is no shard",
                     "give one of N shards as I/N, I from 1 to N, as in --shard 2/4");
  }
  return *shard;
}

std::string head_text(const ShardHead& head) {
  const Json json = {{"shard", to_string(head.shard)},
                     {"options", head.options},
                     {"first_line", head.first_line},
                     {"lines", head.lines},
                     {"results", head.results},
                     {"before", head.before},
                     {"after", head.after}};
  return json.dump() + "\n";
}

std::optional<ShardHead> read_head(std::istream& in, const std::string& file) {
  std::string line;
  if (!std::getline(in, line) || in.eof()) return std::nullopt;
  const std::optional<ShardHead> head = parse_head(line);
  if (!head || head_text(*head) != line + "\n") {
    throw InputError(file, "line 1", "this is not the head of a shard",
                     "name a file that batch --shard has written");
  }
  return head;
}

MeasuredShard measure_shard(std::istream& grasps, std::uintmax_t bytes, const Shard& shard,
                            const LineDecider& decider) {
  const std::uintmax_t first_cut = cut(bytes, shard.index - 1, shard.count);
  const std::uintmax_t last_cut = cut(bytes, shard.index, shard.count);
  MeasuredShard measured;
  batch_detail::Hash hash;
  std::uintmax_t at = 0;
  std::size_t lines = 0;
  bool inside = false;  // inside of the shard
  bool blank = true;    // the line is blank so far
  std::streambuf& in = *grasps.rdbuf();
  constexpr int kEnd = std::streambuf::traits_type::eof();
  const auto begin = [&] {
    inside = true;
    measured.part.begin = at;
    measured.part.lines_before = lines;
    measured.head.before = hash.digits();
  };
  const auto end_line = [&] {
    ++lines;
    measured.head.results += inside && !blank ? 1 : 0;
    blank = true;
  };
  bool in_line = false;
  for (;;) {
    if (!in_line && !inside && at >= first_cut) begin();
    if (!in_line && at >= last_cut && at < bytes) break;
    const int c = in.sbumpc();
    if (c == kEnd) break;
    hash.add(static_cast<char>(c));
    ++at;
    in_line = c != '\n';
    if (in_line && c != ' ' && c != '\t' && c != '\r') blank = false;
    if (!in_line) end_line();
  }
  if (in_line) end_line();
  if (!inside) begin();
  measured.part.end = at;
  measured.head.shard = shard;
  measured.head.options = decider.options_key();
  measured.head.first_line = measured.part.lines_before + 1;
  measured.head.lines = lines - measured.part.lines_before;
  measured.head.after = hash.digits();
  grasps.clear();
  grasps.seekg(0);
  return measured;
}

CompleteShards complete_shards(const std::vector<std::string>& files) {
  CompleteShards all;
  for (const std::string& file : files) {
    if (file == "-") {
      throw InputError("", "--merge", "standard input cannot be read twice", "name files");
    }
    InputFile in(file, "a shard's file of results");
    const std::optional<ShardHead> head = read_head(in.stream(), file);
    if (!head) {
      throw InputError(file, "", "the file has no results, nor says of which shard",
                       "go on with that shard by --shard and --resume");
    }
    all.shards.push_back({file, *head, head_text(*head).size(), 0});
  }
  const auto index = [](const CompleteShard& shard) { return shard.head.shard.index; };
  std::stable_sort(
      all.shards.begin(), all.shards.end(),
      [&](const CompleteShard& a, const CompleteShard& b) { return index(a) < index(b); });
  require_one_batch(all.shards);
  require_each_once(all.shards);
  require_one_file(all.shards);
  for (CompleteShard& shard : all.shards) {
    InputFile in(shard.file, "a shard's file of results");
    in.stream().seekg(static_cast<std::streamoff>(shard.begin));
    read_results(shard, in, all.tally);
  }
  return all;
}

}  // namespace stickslip
