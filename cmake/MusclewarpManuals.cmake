# musclewarp_manuals(<component> <program>...) makes a man page and a bash
# completion of each program, a target or a script, from its own --help, and
# installs them with the component. Programs that have to run elsewhere, or under
# a sanitizer, are not asked.
function(musclewarp_manuals COMPONENT)
  find_package(Python3 COMPONENTS Interpreter)
  if(NOT Python3_FOUND
     OR CMAKE_CROSSCOMPILING
     OR MUSCLEWARP_SANITIZE OR MUSCLEWARP_SANITIZE_THREADS)
    return()
  endif()
  set(SCRIPT ${PROJECT_SOURCE_DIR}/packaging/manuals.py)
  set(FOLDER ${PROJECT_BINARY_DIR}/manuals)
  foreach(PROGRAM IN LISTS ARGN)
    get_filename_component(NAME ${PROGRAM} NAME)
    list(APPEND PAGES ${FOLDER}/man1/${NAME}.1)
    list(APPEND COMPLETIONS ${FOLDER}/completions/${NAME})
    if(TARGET ${PROGRAM})
      list(APPEND FILES $<TARGET_FILE:${PROGRAM}>)
    else()
      list(APPEND FILES ${PROGRAM})
    endif()
  endforeach()
  add_custom_command(
    OUTPUT ${PAGES} ${COMPLETIONS}
    COMMAND Python3::Interpreter ${SCRIPT} ${FOLDER} ${FILES}
    DEPENDS ${SCRIPT} ${ARGN}
    COMMENT "Making the man pages"
    VERBATIM)
  add_custom_target(musclewarp_manuals_${COMPONENT} ALL
                    DEPENDS ${PAGES} ${COMPLETIONS})
  add_dependencies(musclewarp_programs musclewarp_manuals_${COMPONENT})
  install(FILES ${PAGES} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          COMPONENT ${COMPONENT})
  install(
    FILES ${COMPLETIONS}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    COMPONENT ${COMPONENT})
endfunction()
