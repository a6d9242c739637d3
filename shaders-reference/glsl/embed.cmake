# Writes every shader text into one C++ file, as a table of name and text. Runs at configure time; the plain files stay
# the source, and editing one makes CMake run again.
function(reliefbake_embed_shaders output)
    file(GLOB shaders CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/glsl/*.glsl ${CMAKE_CURRENT_SOURCE_DIR}/glsl/*.vert
        ${CMAKE_CURRENT_SOURCE_DIR}/glsl/*.frag)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${shaders})
    set(rows "")
    foreach(shader IN LISTS shaders)
        get_filename_component(name ${shader} NAME)
        file(READ ${shader} text)
        string(APPEND rows "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
    endforeach()
    file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Made by glsl/embed.cmake from the files beside it.
#include \"shaders-reference/renderer/shader_source.h\"

namespace reliefbake {

const std::vector<ShaderText>& shader_texts() {
    static const std::vector<ShaderText> texts = {
@rows@    };
    return texts;
}

} // namespace reliefbake
")
endfunction()
