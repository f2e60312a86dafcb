# CPack runs this on what it has staged, before it packs it: adds to every
# package what Debian wants (copyright, changelog) and compresses man pages.
file(READ ${CPACK_MUSCLEWARP_LICENCES} LICENCES)
# The page of a run is inside of what is built; its own foot has its licences.
file(READ ${CPACK_MUSCLEWARP_PAGE} PAGE)
string(REGEX MATCH "<pre>(musclewarp [^<]+)</pre>" FOUND "${PAGE}")
if(NOT FOUND)
  message(FATAL_ERROR "${CPACK_MUSCLEWARP_PAGE} has no licences at its foot")
endif()
string(STRIP "${CMAKE_MATCH_1}" OF_PAGE)
string(REGEX REPLACE "\n[ \t]*(\n[ \t]*)+" "\n.\n" OF_PAGE "${OF_PAGE}")
string(REGEX REPLACE "\n" "\n " OF_PAGE "${OF_PAGE}")
string(REPLACE "&lt;" "<" OF_PAGE "${OF_PAGE}")
string(REPLACE "&gt;" ">" OF_PAGE "${OF_PAGE}")
string(REPLACE "&amp;" "&" OF_PAGE "${OF_PAGE}")

# In English, and the time of the commit if scripts/deb.sh makes the package.
set(ENV{LC_ALL} C)
string(TIMESTAMP DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(CHANGES
    "musclewarp (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) bookworm; urgency=medium

  * Built from the sources, whose CHANGELOG.md says what changed.

 -- ${CPACK_PACKAGE_CONTACT}  ${DATE}
")

foreach(COMPONENT IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${COMPONENT} UPPER)
  set(STAGE ${CPACK_TEMPORARY_DIRECTORY}/${COMPONENT}/usr)
  set(DOCS ${STAGE}/share/doc/${CPACK_DEBIAN_${UPPER}_PACKAGE_NAME})
  file(WRITE ${DOCS}/copyright "${LICENCES} ${OF_PAGE}\n")
  file(WRITE ${DOCS}/changelog.Debian "${CHANGES}")
  file(GLOB PLAIN ${DOCS}/changelog.Debian ${STAGE}/share/man/man1/*.1)
  execute_process(COMMAND gzip -9nf ${PLAIN} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
