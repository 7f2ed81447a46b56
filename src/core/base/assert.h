// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cassert>

/// A programmer's mistake. On in Debug and wherever FAIRING_ASSERTIONS is defined; never in a
/// release inside FreeCAD.
#ifdef FAIRING_ASSERTIONS
#include <cstdio>
#include <cstdlib>
#define FAIRING_ASSERT(condition) \
  ((condition)                    \
       ? static_cast<void>(0)     \
       : (std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition), std::abort()))
#else
#define FAIRING_ASSERT(condition) static_cast<void>(0)
#endif
