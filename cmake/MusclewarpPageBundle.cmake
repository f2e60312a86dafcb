# musclewarp_page_bundle(<page> <header> <name> <file.cc>) makes a source file
# that holds a page of tools/report ("run" or "joints") as <name>, which
# page/<header> declares. Node.js bundles the page; without it the page that a
# source package brings along is taken (scripts/package.sh). The global property
# MUSCLEWARP_PAGE names the page of runs itself.
option(MUSCLEWARP_WITH_NODE "Make the report page, with Node.js" ON)
if(MUSCLEWARP_WITH_NODE)
  find_program(MUSCLEWARP_NODE NAMES node nodejs)
  find_program(MUSCLEWARP_NPM npm)
endif()

function(musclewarp_page_bundle KIND HEADER NAME OUTPUT)
  set(SOURCES ${PROJECT_SOURCE_DIR}/tools/report)
  set(FILES_run page.html)
  set(FILES_joints joints.html)
  set(FILE ${FILES_${KIND}})
  set(PACKAGED ${SOURCES}/packaged/${FILE})
  if(MUSCLEWARP_WITH_NODE
     AND MUSCLEWARP_NODE
     AND MUSCLEWARP_NPM)
    message(STATUS "Report page ${FILE}: made with ${MUSCLEWARP_NODE}")
    set(PAGE ${PROJECT_BINARY_DIR}/report/${FILE})
    _musclewarp_build_page(${SOURCES} ${KIND} ${PAGE})
  elseif(EXISTS ${PACKAGED})
    message(STATUS "Report page ${FILE}: the one that came with this package; "
                   "to make it anew, install Node.js with npm")
    set(PAGE ${PACKAGED})
  else()
    message(
      FATAL_ERROR
        "The report page is made with Node.js 18 or newer and npm (Debian: "
        "nodejs, npm), and they are not here. Install them, or build from a "
        "source package, which brings the page (scripts/package.sh makes one).")
  endif()
  if(KIND STREQUAL run)
    set_property(GLOBAL PROPERTY MUSCLEWARP_PAGE ${PAGE})
  endif()
  set(EMBED ${PROJECT_SOURCE_DIR}/cmake/EmbedPage.cmake)
  add_custom_command(
    OUTPUT ${OUTPUT}
    COMMAND ${CMAKE_COMMAND} -DPAGE=${PAGE} -DHEADER=${HEADER} -DNAME=${NAME}
            -DOUTPUT=${OUTPUT} -P ${EMBED}
    DEPENDS ${PAGE} ${EMBED}
    VERBATIM)
endfunction()

# Packages go where editors look for them; the rest stays in the build folder.
function(_musclewarp_build_page SOURCES KIND PAGE)
  set(INSTALLED ${SOURCES}/node_modules/.package-lock.json)
  # Once for all pages.
  get_property(IS_KNOWN GLOBAL PROPERTY MUSCLEWARP_PAGE_PACKAGES)
  if(NOT IS_KNOWN)
    add_custom_command(
      OUTPUT ${INSTALLED}
      COMMAND ${MUSCLEWARP_NPM} ci --ignore-scripts --no-progress
      COMMAND ${CMAKE_COMMAND} -E touch ${INSTALLED}
      WORKING_DIRECTORY ${SOURCES}
      DEPENDS ${SOURCES}/package.json ${SOURCES}/package-lock.json
      COMMENT "Installing what the report page is made of"
      VERBATIM)
    set_property(GLOBAL PROPERTY MUSCLEWARP_PAGE_PACKAGES ON)
  endif()
  file(GLOB_RECURSE PAGE_SOURCES CONFIGURE_DEPENDS ${SOURCES}/src/*)
  add_custom_command(
    OUTPUT ${PAGE}
    COMMAND ${MUSCLEWARP_NODE} build.mjs ${KIND} ${PAGE}
    WORKING_DIRECTORY ${SOURCES}
    DEPENDS ${PAGE_SOURCES} ${SOURCES}/build.mjs ${INSTALLED}
    COMMENT "Making the page of ${KIND}"
    VERBATIM)
endfunction()
