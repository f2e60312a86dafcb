# cmake -DROOT=dir -DOUTPUT=sources_hash.cc -DBUILT_WITH=text -P SourcesHash.cmake
#
# Writes the source file of build_info/build_info.h: a hash of the names and
# contents of all sources of the library and the programs, and of the files that
# say how they are built. It is the same for the same sources, with or without
# git, wherever they lie.
include(${CMAKE_CURRENT_LIST_DIR}/MusclewarpSources.cmake)
musclewarp_sources(${ROOT} FILES)
foreach(FILE IN LISTS FILES)
  file(SHA256 ${ROOT}/${FILE} HASH)
  string(APPEND LISTING "${HASH} ${FILE}\n")
endforeach()
string(SHA256 HASH "${LISTING}")
string(SUBSTRING ${HASH} 0 16 HASH)
file(WRITE ${OUTPUT}
     "// Made by cmake/SourcesHash.cmake.\n"
     "#include \"musclewarp/build_info/build_info.h\"\n\n"
     "namespace musclewarp {\n\n"
     "const char* const kSourcesHash = \"${HASH}\";\n"
     "const char* const kBuiltWith = \"${BUILT_WITH}\";\n\n"
     "}  // namespace musclewarp\n")
