# Writes OUTPUT: a C++ table of every shader below ROOT, name relative to ROOT and text.
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/*.glsl ${ROOT}/*.h)
set(rows "")
foreach(name ${files})
  file(READ ${ROOT}/${name} text)
  string(APPEND rows "    {\"${name}\", R\"glsl_text(${text})glsl_text\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"common/gpu/shader_source.h\"\n\nnamespace eikonal::gpu {\n\n"
     "const std::vector<EmbeddedShader>& embeddedShaders() {\n"
     "  static const std::vector<EmbeddedShader> table = {\n${rows}  };\n  return table;\n}\n\n} // namespace eikonal::gpu\n")
