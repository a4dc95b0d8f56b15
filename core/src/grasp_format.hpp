// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Constants that the reader and the writer of grasp files share.
#pragma once

namespace stickslip::core_detail {

/// \{ The values of the member "format".
inline constexpr const char* kVersion1 = "stickslip-grasp/1";
inline constexpr const char* kVersion2 = "stickslip-grasp/2";
inline constexpr const char* kVersion3 = "stickslip-grasp/3";  ///< for several bodies
/// \}

}  // namespace stickslip::core_detail
