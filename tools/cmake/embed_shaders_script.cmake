# Writes OUTPUT: a C++ table of every shader below ROOT, name relative to ROOT and text.
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/*.glsl ${ROOT}/*.h)
list(SORT files)
set(rows "")
foreach(name IN LISTS files)
  file(READ "${ROOT}/${name}" text)
  string(FIND "${text}" ")glsl_text\"" delimiter)
  if(NOT delimiter EQUAL -1)
    message(FATAL_ERROR "${name} contains the end mark of the raw strings that shaders are embedded as")
  endif()
  string(APPEND rows "    {\"${name}\", R\"glsl_text(${text})glsl_text\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"common/gpu/shader_source.h\"\n\nnamespace eikonal::gpu {\n\n"
     "const std::vector<EmbeddedShader>& embeddedShaders() {\n"
     "  static const std::vector<EmbeddedShader> table = {\n${rows}  };\n  return table;\n}\n\n} // namespace eikonal::gpu\n")
