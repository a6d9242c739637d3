# find_package(reliefbake): the program reliefbake::reliefbake, and a function that bakes assets as a part of a build (docs/BUILD_SYSTEMS.md).
cmake_minimum_required(VERSION 3.22)
get_filename_component(_reliefbake_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET reliefbake::reliefbake)
    add_executable(reliefbake::reliefbake IMPORTED)
    set_target_properties(reliefbake::reliefbake PROPERTIES IMPORTED_LOCATION "${_reliefbake_prefix}/bin/reliefbake")
endif()
unset(_reliefbake_prefix)

# reliefbake_add_assets(TARGET SOURCES FILE...
#     [COMMAND cone|acm|cone-normal|cone-stack|shape|bump|quadric]   default cone
#     [OPTIONS OPTION...]          of that command; files by their whole path
#     [OUTPUT_NAME PATTERN]        default "{stem}_{kind}.exr"; {stem}: of the source, {kind}: the command
#     [OUTPUT_DIRECTORY DIR]       default ${CMAKE_CURRENT_BINARY_DIR}/TARGET
#     [OUTPUTS VARIABLE])          set to the files that are baked
#
# A target that bakes each source when it, or a file that it names, has changed. A file whose bytes come out equal keeps its time, so that
# nothing that depends on it is built again; what depends on it from another target also wants add_dependencies(OTHER TARGET).
function(reliefbake_add_assets target)
    cmake_parse_arguments(PARSE_ARGV 1 A "" "COMMAND;OUTPUT_NAME;OUTPUT_DIRECTORY;OUTPUTS" "SOURCES;OPTIONS")
    if(A_UNPARSED_ARGUMENTS OR A_KEYWORDS_MISSING_VALUES)
        message(FATAL_ERROR "reliefbake_add_assets(${target}): cannot use: ${A_UNPARSED_ARGUMENTS} ${A_KEYWORDS_MISSING_VALUES}")
    endif()
    if(NOT A_SOURCES)
        message(FATAL_ERROR "reliefbake_add_assets(${target}): name SOURCES")
    endif()
    if(NOT A_COMMAND)
        set(A_COMMAND cone)
    endif()
    if(NOT A_OUTPUT_NAME)
        set(A_OUTPUT_NAME "{stem}_{kind}.exr")
    endif()
    if(NOT A_OUTPUT_DIRECTORY)
        set(A_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/${target}")
    endif()
    get_filename_component(folder "${A_OUTPUT_DIRECTORY}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
    set(notes "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.reliefbake") # stamps and depfiles
    file(MAKE_DIRECTORY "${folder}" "${notes}")

    set(outputs "")
    set(stamps "")
    foreach(source IN LISTS A_SOURCES)
        get_filename_component(source "${source}" ABSOLUTE)
        get_filename_component(stem "${source}" NAME_WLE)
        string(REPLACE "{stem}" "${stem}" name "${A_OUTPUT_NAME}")
        string(REPLACE "{kind}" "${A_COMMAND}" name "${name}")
        set(output "${folder}/${name}")
        if(output IN_LIST outputs)
            message(FATAL_ERROR "reliefbake_add_assets(${target}): two sources would both bake ${output}; give each a target, or another OUTPUT_NAME")
        endif()
        set(stamp "${notes}/${name}.stamp")
        add_custom_command(
            OUTPUT "${stamp}"
            BYPRODUCTS "${output}"
            COMMAND reliefbake::reliefbake ${A_COMMAND} "${source}" -o "${output}" ${A_OPTIONS} --quiet --if-changed -MF "${stamp}.d" -MT "${stamp}"
            COMMAND "${CMAKE_COMMAND}" -E touch "${stamp}"
            DEPENDS "${source}" reliefbake::reliefbake
            DEPFILE "${stamp}.d"
            COMMENT "Baking ${name}"
            VERBATIM)
        list(APPEND outputs "${output}")
        list(APPEND stamps "${stamp}")
    endforeach()
    add_custom_target(${target} ALL DEPENDS ${stamps})
    set_property(TARGET ${target} PROPERTY RELIEFBAKE_OUTPUTS "${outputs}")
    if(A_OUTPUTS)
        set(${A_OUTPUTS} "${outputs}" PARENT_SCOPE)
    endif()
endfunction()
