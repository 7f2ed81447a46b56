# SPDX-License-Identifier: LGPL-2.1-or-later
# FAIRING_SANITIZE is a list for -fsanitize=, such as "address,undefined". Everything is built with it or nothing is.
# The second one's checks of every pointer and reference are left out: the first one sees the access that goes wrong,
# and without them building takes a third less time.
set(FAIRING_SANITIZE "" CACHE STRING "Sanitizers to build with, separated by commas")

if(FAIRING_SANITIZE)
  add_compile_options(-fsanitize=${FAIRING_SANITIZE} -fno-sanitize=null,alignment,object-size,vptr
                      -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${FAIRING_SANITIZE})
endif()
