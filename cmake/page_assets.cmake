# Makes a C++ source of a style sheet and scripts, given as FILES with commas between: the definitions of
# compare/documents/page/assets.hpp. The scripts follow one another in one function, as they are listed.
string(REPLACE "," ";" files "${FILES}")
set(style "")
set(script "")
foreach(file IN LISTS files)
  file(READ ${file} text)
  if(file MATCHES "\\.css$")
    string(APPEND style "${text}")
  else()
    string(APPEND script "${text}")
  endif()
endforeach()
file(WRITE ${OUTPUT} "#include \"compare/documents/page/assets.hpp\"\n\nnamespace validate {\n\n"
  "const std::string_view page_style = R\"ASSET(${style})ASSET\";\n\n"
  "const std::string_view page_script = R\"ASSET(${script})ASSET\";\n\n}  // namespace validate\n")
