# SPDX-License-Identifier: LGPL-2.1-or-later
# fairing::warnings: what every target of ours is compiled with. Foreign headers are SYSTEM and stay silent.
option(FAIRING_ASSERTIONS "Check preconditions at run time (FAIRING_ASSERT)" OFF)

add_library(fairing_warnings INTERFACE)
add_library(fairing::warnings ALIAS fairing_warnings)
target_compile_options(fairing_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wpedantic -Werror)
target_compile_definitions(fairing_warnings INTERFACE $<$<BOOL:${FAIRING_ASSERTIONS}>:FAIRING_ASSERTIONS>)
