# cmake -DPAGE=page.html -DHEADER=page.h -DNAME=kPageBundle
#       -DOUTPUT=page_bundle.cc -P EmbedPage.cmake
file(READ ${PAGE} TEXT)
if(TEXT MATCHES "\\)PAGE\"")
  message(FATAL_ERROR "${PAGE} holds )PAGE\", by which it is quoted here")
endif()
file(WRITE ${OUTPUT}
     "// Made from ${PAGE}.\n"
     "#include \"musclewarp/page/${HEADER}\"\n\n"
     "namespace musclewarp {\n\n"
     "const char ${NAME}[] = R\"PAGE(${TEXT})PAGE\";\n"
     "const unsigned long ${NAME}Size = sizeof(${NAME}) - 1;\n\n"
     "}  // namespace musclewarp\n")
