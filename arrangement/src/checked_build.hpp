// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Stops the build that checks CGAL's assertions if something has switched them off. To be
/// included after CGAL.
#pragma once

#ifdef STICKSLIP_CHECKED
#if defined(NDEBUG) || defined(CGAL_NDEBUG) || !defined(CGAL_CHECK_EXPENSIVE) || \
    !defined(CGAL_CHECK_EXACTNESS)
#error "the checked build must not switch off the assertions of CGAL"
#endif
static_assert(CGAL_ASSERTIONS_ENABLED, "the checked build needs the assertions of CGAL");
#endif
