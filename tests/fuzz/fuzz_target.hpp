// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a fuzz target is: libFuzzer's entry point, and seeds made from the test corpus. Linked
/// with libFuzzer (scripts/fuzz.sh) or with replay_main.cpp (ctest).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/core/error.hpp"

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

/// Texts that are short to write and long to read: deep nesting, huge exponents, long numbers.
std::vector<Seed> hostile_texts();

/// Prints the message and aborts, so that libFuzzer keeps the input.
[[noreturn]] void broken(const std::string& message);

/// An error about a text says what is wrong and what would be right, and a line:column that it
/// names is in the text or just behind it.
void expect_useful(const InputError& error, std::string_view text);

}  // namespace stickslip::fuzz
