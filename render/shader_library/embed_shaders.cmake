# cmake -DFOLDER=shaders -DOUT=embedded_shaders.cpp -P embed_shaders.cmake: writes the body of embeddedShader() with every
# file below FOLDER.
set(body "")
file(GLOB_RECURSE files RELATIVE ${FOLDER} ${FOLDER}/*)
list(SORT files)
foreach(file ${files})
    file(READ ${FOLDER}/${file} text)
    string(APPEND body "    if (file == \"${file}\") return R\"shader(${text})shader\";\n")
endforeach()
file(WRITE ${OUT} "#include \"render/shader_library/embedded_shaders.h\"

namespace rubble {

std::optional<std::string_view> embeddedShader(std::string_view file) {
${body}    return {};
}

}  // namespace rubble
")
