# musclewarp_manuals(<program>...) makes a man page and a bash completion of each
# program from its own --help, and installs them with the programs. Programs
# that have to run elsewhere, or under a sanitizer, are not asked.
function(musclewarp_manuals)
  find_package(Python3 COMPONENTS Interpreter)
  if(NOT Python3_FOUND
     OR CMAKE_CROSSCOMPILING
     OR MUSCLEWARP_SANITIZE)
    return()
  endif()
  set(SCRIPT ${PROJECT_SOURCE_DIR}/packaging/manuals.py)
  set(FOLDER ${PROJECT_BINARY_DIR}/manuals)
  list(TRANSFORM ARGN REPLACE "(.+)" "${FOLDER}/man1/\\1.1"
                              OUTPUT_VARIABLE PAGES)
  list(TRANSFORM ARGN PREPEND ${FOLDER}/completions/
                      OUTPUT_VARIABLE COMPLETIONS)
  list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_FILE:\\1>"
                              OUTPUT_VARIABLE FILES)
  add_custom_command(
    OUTPUT ${PAGES} ${COMPLETIONS}
    COMMAND Python3::Interpreter ${SCRIPT} ${FOLDER} ${FILES}
    DEPENDS ${SCRIPT} ${ARGN}
    COMMENT "Making the man pages"
    VERBATIM)
  add_custom_target(musclewarp_manuals ALL DEPENDS ${PAGES} ${COMPLETIONS})
  add_dependencies(musclewarp_programs musclewarp_manuals)
  install(FILES ${PAGES} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          COMPONENT programs)
  install(
    FILES ${COMPLETIONS}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    COMPONENT programs)
endfunction()
