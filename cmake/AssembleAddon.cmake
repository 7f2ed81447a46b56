# SPDX-License-Identifier: LGPL-2.1-or-later
# cmake -D SOURCE=<project> -D ADDON=<folder> -P AssembleAddon.cmake
# Copies what changed and removes what the project no longer has; the native module is left alone.
foreach(file InitGui.py Init.py package.xml LICENSE README.md)
  if(EXISTS ${SOURCE}/${file})
    file(COPY ${SOURCE}/${file} DESTINATION ${ADDON})
  endif()
endforeach()

function(mirror from to)
  file(COPY ${SOURCE}/${from}/ DESTINATION ${ADDON}/${to} PATTERN __pycache__ EXCLUDE PATTERN *.pyc EXCLUDE)
  file(GLOB_RECURSE copies RELATIVE ${ADDON}/${to} ${ADDON}/${to}/*)
  list(FILTER copies EXCLUDE REGEX "\\.so$|__pycache__")
  foreach(copy ${copies})
    if(NOT EXISTS ${SOURCE}/${from}/${copy})
      file(REMOVE ${ADDON}/${to}/${copy})
    endif()
  endforeach()
endfunction()

foreach(pair Mod/fairing:fairing resources:resources)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 from)
  list(GET pair 1 to)
  if(EXISTS ${SOURCE}/${from})
    mirror(${from} ${to})
  endif()
endforeach()

# Without Qt's lrelease (Debian: qttools5-dev-tools) the add-on speaks English only.
# Debian's /usr/bin/lrelease asks qtchooser which Qt is meant, which may not know.
find_program(LRELEASE NAMES lrelease PATHS /usr/lib/qt5/bin /usr/lib/qt6/bin NO_DEFAULT_PATH)
find_program(LRELEASE NAMES lrelease)
if(LRELEASE)
  file(GLOB texts ${SOURCE}/resources/translations/*.ts)
  foreach(text ${texts})
    cmake_path(GET text STEM name)
    execute_process(COMMAND ${LRELEASE} -silent ${text} -qm ${ADDON}/resources/translations/${name}.qm
                    COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endif()
