# vdamf_library(<name> PUBLIC <targets>... PRIVATE <targets>...)
#
# A static library `vdamf::<name>` from all sources below src/. What a library does not link, it
# cannot include: MRPT installs every module's headers in a folder of its own, so the link lines
# enforce the floors of the house.
function(vdamf_library name)
    cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/*.cpp)
    add_library(vdamf_${name} STATIC ${sources})
    add_library(vdamf::${name} ALIAS vdamf_${name})
    set_target_properties(vdamf_${name} PROPERTIES EXPORT_NAME ${name})
    target_compile_features(vdamf_${name} PUBLIC cxx_std_17)
    target_include_directories(vdamf_${name}
        PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
               $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
        PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
    target_link_libraries(vdamf_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    vdamf_compile_options(vdamf_${name})
    install(TARGETS vdamf_${name} EXPORT vdamf-targets)
    install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# Warnings and sanitizers, the same for every target of the project.
function(vdamf_compile_options target)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor
        $<$<BOOL:${VDAMF_WARNINGS_AS_ERRORS}>:-Werror>)
    if(VDAMF_SANITIZE)
        target_compile_options(${target} PRIVATE
            -fsanitize=${VDAMF_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
        target_link_options(${target} PUBLIC -fsanitize=${VDAMF_SANITIZE})
    endif()
endfunction()
