# Install rules: programs, libraries, headers and what find_package needs.
include(CMakePackageConfigHelpers)
include(MusclewarpManuals)
set(MUSCLEWARP_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/musclewarp)

# Every program is an executable of tools/ named musclewarp-<verb>; the target
# musclewarp_programs builds them all, without the tests.
add_custom_target(musclewarp_programs)
get_property(
  MUSCLEWARP_PROGRAMS
  DIRECTORY tools
  PROPERTY BUILDSYSTEM_TARGETS)
list(FILTER MUSCLEWARP_PROGRAMS INCLUDE REGEX "^musclewarp-")
if(MUSCLEWARP_PROGRAMS)
  add_dependencies(musclewarp_programs ${MUSCLEWARP_PROGRAMS})
  install(TARGETS ${MUSCLEWARP_PROGRAMS} DESTINATION ${CMAKE_INSTALL_BINDIR}
          COMPONENT programs)
  musclewarp_manuals(programs ${MUSCLEWARP_PROGRAMS})
endif()

# Cohorts: a script that calls Snakemake, and its workflow.
set(COHORT ${PROJECT_SOURCE_DIR}/cohort)
install(PROGRAMS ${COHORT}/musclewarp-cohort DESTINATION ${CMAKE_INSTALL_BINDIR}
        COMPONENT cohort)
install(
  DIRECTORY ${COHORT}/
  DESTINATION ${CMAKE_INSTALL_DATADIR}/musclewarp/cohort
  USE_SOURCE_PERMISSIONS
  COMPONENT cohort
  PATTERN musclewarp-cohort EXCLUDE
  PATTERN __pycache__ EXCLUDE)
musclewarp_manuals(cohort ${COHORT}/musclewarp-cohort)

# Libraries outside src/ and problems/ (the commands behind the programs) are
# not for others to link.
get_property(MUSCLEWARP_LIBRARIES GLOBAL PROPERTY MUSCLEWARP_LIBRARIES)
foreach(LIBRARY IN LISTS MUSCLEWARP_LIBRARIES)
  get_target_property(FOLDER ${LIBRARY} SOURCE_DIR)
  file(RELATIVE_PATH FOLDER ${PROJECT_SOURCE_DIR} ${FOLDER})
  if(NOT FOLDER MATCHES "^(src|problems)/")
    list(REMOVE_ITEM MUSCLEWARP_LIBRARIES ${LIBRARY})
  endif()
endforeach()

# musclewarp::musclewarp is all of them.
add_library(musclewarp INTERFACE)
add_library(musclewarp::musclewarp ALIAS musclewarp)
target_link_libraries(musclewarp INTERFACE ${MUSCLEWARP_LIBRARIES})

install(TARGETS musclewarp ${MUSCLEWARP_LIBRARIES} EXPORT musclewarpTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(
  EXPORT musclewarpTargets
  NAMESPACE musclewarp::
  DESTINATION ${MUSCLEWARP_CONFIG_DIR}
  COMPONENT dev)
# Include paths are those of the sources; a folder of their own keeps
# "problems/..." out of the way of others.
install(DIRECTORY src/musclewarp problems
        DESTINATION ${MUSCLEWARP_INSTALL_INCLUDEDIR} COMPONENT dev
        FILES_MATCHING PATTERN "*.h"
        PATTERN archived_fields.h EXCLUDE
        PATTERN preparation_archive.h EXCLUDE)

configure_package_config_file(
  cmake/musclewarpConfig.cmake.in ${PROJECT_BINARY_DIR}/musclewarpConfig.cmake
  INSTALL_DESTINATION ${MUSCLEWARP_CONFIG_DIR})
# Before 1.0 a minor version may break what came before it.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/musclewarpConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/musclewarpConfig.cmake
              ${PROJECT_BINARY_DIR}/musclewarpConfigVersion.cmake
              cmake/MusclewarpDependencies.cmake
        DESTINATION ${MUSCLEWARP_CONFIG_DIR} COMPONENT dev)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
