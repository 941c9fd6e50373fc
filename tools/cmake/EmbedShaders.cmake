# eikonal_embed_shaders(TARGET): compiles every file below shaders/ into TARGET as a table of name and text, so that the
# program needs no files at run time.
function(eikonal_embed_shaders target)
  file(GLOB_RECURSE shader_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/*.glsl ${CMAKE_SOURCE_DIR}/shaders/*.h)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/embedded_shaders.cpp)
  add_custom_command(
    OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${generated} -DROOT=${CMAKE_SOURCE_DIR}/shaders
            -P ${CMAKE_SOURCE_DIR}/tools/cmake/embed_shaders_script.cmake
    DEPENDS ${shader_files} ${CMAKE_SOURCE_DIR}/tools/cmake/embed_shaders_script.cmake
    COMMENT "Embedding shaders")
  target_sources(${target} PRIVATE ${generated})
endfunction()
