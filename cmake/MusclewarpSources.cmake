# musclewarp_sources(<root> <variable>) lists the files that decide what the
# library and the programs compute, relative to the root and sorted: their C++
# sources, and how these are built.
function(musclewarp_sources ROOT VARIABLE)
  if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(WATCH CONFIGURE_DEPENDS) # a new file is noticed by the next build
  endif()
  file(GLOB FILES RELATIVE ${ROOT} ${WATCH} ${ROOT}/CMakeLists.txt
       ${ROOT}/cmake/*.cmake)
  foreach(FOLDER src problems tools)
    foreach(NAME *.h *.cc CMakeLists.txt)
      list(APPEND PATTERNS ${ROOT}/${FOLDER}/${NAME})
    endforeach()
  endforeach()
  file(GLOB_RECURSE SOURCES RELATIVE ${ROOT} ${WATCH} ${PATTERNS})
  # The report page is no part of what is computed.
  list(FILTER SOURCES EXCLUDE REGEX "^tools/report/")
  list(APPEND FILES ${SOURCES})
  list(SORT FILES)
  set(${VARIABLE} ${FILES} PARENT_SCOPE)
endfunction()
