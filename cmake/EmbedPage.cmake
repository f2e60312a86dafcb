# cmake -DPAGE=page.html -DOUTPUT=page_bundle.cc -P EmbedPage.cmake
file(READ ${PAGE} TEXT)
if(TEXT MATCHES "\\)PAGE\"")
  message(FATAL_ERROR "${PAGE} holds )PAGE\", by which it is quoted here")
endif()
file(WRITE ${OUTPUT}
     "// Made from ${PAGE}.\n"
     "#include \"musclewarp/page/page.h\"\n\n"
     "namespace musclewarp {\n\n"
     "const char kPageBundle[] = R\"PAGE(${TEXT})PAGE\";\n"
     "const unsigned long kPageBundleSize = sizeof(kPageBundle) - 1;\n\n"
     "}  // namespace musclewarp\n")
