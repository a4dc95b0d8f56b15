// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a fuzz target is: libFuzzer's entry point, and seeds made from the test corpus. Linked
/// with libFuzzer (scripts/fuzz.sh) or with replay_main.cpp (ctest).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// Aborts when a property does not hold. Lets no exception pass.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace stickslip::fuzz {

struct Seed {
  std::string name;
  std::string bytes;
};

/// Of the target that is linked in, sorted by name. `corpus` is tests/corpus.
std::vector<Seed> seeds(const std::filesystem::path& corpus);

/// Every file below a folder, as seeds.
std::vector<Seed> files_below(const std::filesystem::path& folder);

/// Prints the message and aborts, so that libFuzzer keeps the input.
[[noreturn]] void broken(const std::string& message);

}  // namespace stickslip::fuzz
