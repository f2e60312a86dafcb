# Makes a staged tree self-contained: copies the shared libraries that its
# programs and modules need into a folder of it, and lets each file find them
# from where it lies, so that the tree may be moved. Needs Debian, whose
# packages say whose a library is, and patchelf.
#
#   cmake -DSTAGE=FOLDER -DLIBRARIES=lib -DLICENCES=licences
#         -P packaging/bundle_libraries.cmake
#
# LIBRARIES and LICENCES are folders of STAGE. LICENCES gets the copyright file
# of each package of which something is in the tree, the common licences that
# these refer to, and packages.txt: each package, its version and files.
cmake_minimum_required(VERSION 3.22)

# What stays with the system:
# - glibc, which goes with the kernel and cannot be carried beside another;
set(OF_SYSTEM
    ld-linux-x86-64 libc libm libmvec libpthread libdl librt libresolv libutil
    libnsl libanl libnss_[a-z]+ libthread_db libBrokenLocale)
# - the runtime of g++: a driver of the graphics card, or another module in the
#   same Python, may need a newer one than we were built with, and a process can
#   have but one. Newer ones take what was built for older ones.
list(APPEND OF_SYSTEM libstdc\\+\\+ libgcc_s)

# A library is carried as libz-musclewarp.so.1 instead of libz.so.1, so that it
# is never mistaken for another version, which a driver or another module has
# loaded. Only the dispatchers of OpenGL keep their names, which drivers share.
set(SHARED_BY_NAME "^lib(EGL|GL|GLX|GLdispatch|OpenGL)\\.so\\.")

# Of what is compiled in, from headers and static libraries.
set(COMPILED_IN libceres-dev libcereal-dev libcgal-dev libeigen3-dev
                libnanoflann-dev nlohmann-json3-dev pybind11-dev)

foreach(NAME STAGE LIBRARIES LICENCES)
  if(NOT ${NAME})
    message(FATAL_ERROR "bundle: -D${NAME}=... is missing")
  endif()
endforeach()
get_filename_component(STAGE ${STAGE} ABSOLUTE)
foreach(TOOL dpkg-query objdump patchelf strip)
  find_program(HAS_${TOOL} ${TOOL})
  if(NOT HAS_${TOOL})
    message(FATAL_ERROR "bundle: ${TOOL} is not here")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Copies the copyright file of PACKAGE and the licences that it refers to.
function(copy_licence PACKAGE)
  set(COPYRIGHT /usr/share/doc/${PACKAGE}/copyright)
  configure_file(${COPYRIGHT} ${STAGE}/${LICENCES}/${PACKAGE} COPYONLY)
  file(STRINGS ${COPYRIGHT} LINES REGEX "/usr/share/common-licenses/")
  string(REGEX MATCHALL "/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]"
               TEXTS "${LINES}")
  foreach(TEXT IN LISTS TEXTS)
    get_filename_component(NAME ${TEXT} NAME)
    if(EXISTS ${TEXT}) # some name one that there is not
      configure_file(${TEXT} ${STAGE}/${LICENCES}/common-licenses/${NAME}
                     COPYONLY)
    endif()
  endforeach()
endfunction()

# The programs and modules are what is an ELF file.
file(GLOB_RECURSE FILES LIST_DIRECTORIES FALSE ${STAGE}/*)
foreach(FILE IN LISTS FILES)
  file(READ ${FILE} MAGIC LIMIT 4 HEX)
  if(MAGIC STREQUAL 7f454c46)
    list(APPEND PROGRAMS ${FILE})
  endif()
endforeach()

set(CMAKE_GET_RUNTIME_DEPENDENCIES_PLATFORM linux+elf)
set(CMAKE_GET_RUNTIME_DEPENDENCIES_TOOL objdump)
list(JOIN OF_SYSTEM | OF_SYSTEM)
file(
  GET_RUNTIME_DEPENDENCIES
  EXECUTABLES ${PROGRAMS}
  RESOLVED_DEPENDENCIES_VAR NEEDED
  PRE_EXCLUDE_REGEXES "^(${OF_SYSTEM})\\.so(\\.|$)")

list(SORT NEEDED)
foreach(LIBRARY IN LISTS NEEDED)
  file(REAL_PATH ${LIBRARY} REAL)
  # Where /lib is a link to /usr/lib, packages name either.
  string(REGEX REPLACE "^/usr/" "/" SHORT ${REAL})
  list(APPEND PATHS ${REAL} ${SHORT})
endforeach()
# Fails for one of each two paths.
execute_process(COMMAND dpkg-query --search ${PATHS} OUTPUT_VARIABLE OWNERS
                ERROR_QUIET)

foreach(LIBRARY IN LISTS NEEDED)
  get_filename_component(NAME ${LIBRARY} NAME)
  file(REAL_PATH ${LIBRARY} REAL)
  string(REGEX REPLACE "^/usr/" "" SHORT ${REAL})
  string(REPLACE "+" "\\+" SHORT ${SHORT})
  if(NOT "\n${OWNERS}" MATCHES "\n([^:\n]+)(:[^:\n]+)?: (/usr)?/${SHORT}\n")
    message(FATAL_ERROR "bundle: no package of Debian has ${REAL}")
  endif()
  set(PACKAGE ${CMAKE_MATCH_1})
  if(NOT NAME MATCHES ${SHARED_BY_NAME})
    set(SONAME ${NAME})
    string(REPLACE ".so" "-musclewarp.so" NAME ${SONAME})
    list(APPEND RENAME --replace-needed ${SONAME} ${NAME})
  endif()
  configure_file(${REAL} ${STAGE}/${LIBRARIES}/${NAME} COPYONLY)
  list(APPEND CARRIED ${STAGE}/${LIBRARIES}/${NAME})
  list(APPEND PACKAGES ${PACKAGE})
  list(APPEND FILES_OF_${PACKAGE} ${NAME})
endforeach()

list(APPEND PACKAGES ${COMPILED_IN})
list(REMOVE_DUPLICATES PACKAGES)
list(SORT PACKAGES)
set(TABLE "package\tversion\tfiles\n")
foreach(PACKAGE IN LISTS PACKAGES)
  copy_licence(${PACKAGE})
  execute_process(
    COMMAND dpkg-query --show --showformat \${Version} ${PACKAGE}
    OUTPUT_VARIABLE VERSION COMMAND_ERROR_IS_FATAL ANY)
  if(NOT FILES_OF_${PACKAGE})
    set(FILES_OF_${PACKAGE} "compiled in")
  endif()
  list(JOIN FILES_OF_${PACKAGE} " " NAMES)
  string(APPEND TABLE "${PACKAGE}\t${VERSION}\t${NAMES}\n")
endforeach()
file(WRITE ${STAGE}/${LICENCES}/packages.txt ${TABLE})

# strip first: it does not expect what patchelf does to a file. patchelf 0.14
# spoils names if one call does it all.
foreach(FILE IN LISTS CARRIED PROGRAMS)
  get_filename_component(FOLDER ${FILE} DIRECTORY)
  get_filename_component(NAME ${FILE} NAME)
  file(RELATIVE_PATH PATH ${FOLDER} ${STAGE}/${LIBRARIES})
  string(REGEX REPLACE "/$" "" PATH "\$ORIGIN/${PATH}")
  run(strip --strip-unneeded ${FILE})
  run(patchelf ${RENAME} ${FILE})
  if(FILE IN_LIST CARRIED)
    run(patchelf --set-soname ${NAME} ${FILE})
  endif()
  run(patchelf --set-rpath ${PATH} ${FILE})
endforeach()
list(LENGTH CARRIED COUNT)
message(STATUS "bundle: ${COUNT} libraries are in ${LIBRARIES}/")
