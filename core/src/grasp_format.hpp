// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the reader and the writer of grasp files share.
#pragma once

namespace stickslip::core_detail {

/// \{ The member "format".
inline constexpr const char* kVersion1 = "stickslip-grasp/1";
inline constexpr const char* kVersion2 = "stickslip-grasp/2";
inline constexpr const char* kVersion3 = "stickslip-grasp/3";  ///< several bodies
/// \}

}  // namespace stickslip::core_detail
