# What holds for every target made of this repository's own sources.
option(MAREY_WARNINGS_AS_ERRORS "Stop at a compiler warning in Marey's own code" ON)

find_program(CCACHE ccache)
mark_as_advanced(CCACHE)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
  if(EMSCRIPTEN) # ccache does not know em++ by its name.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_COMPILERTYPE=clang ${CCACHE})
  endif()
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# Native and wasm give the same numbers: no contraction into fused operations, no -ffast-math anywhere.
add_compile_options(-ffp-contract=off)
if(EMSCRIPTEN)
  # A want of memory is an exception, which the bindings and the program's panels catch: docs/decisions/out-of-memory.md.
  # clang 14 joins neighbouring numbers into wrong lanes: docs/decisions/wasm-build.md.
  add_compile_options(-msimd128 -fno-slp-vectorize -fwasm-exceptions -fno-rtti)
  add_link_options(-fwasm-exceptions)
  if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.25)
    add_link_options(-sTOTAL_STACK=1MB)
  else()
    add_link_options(-sSTACK_SIZE=1MB)
  endif()
endif()

# The sources below FOLDERS (relative to the repository), noticed when they appear; OUT is empty when there are none.
function(marey_find_sources OUT)
  set(patterns)
  foreach(folder IN LISTS ARGN)
    list(APPEND patterns "${PROJECT_SOURCE_DIR}/${folder}/*.cpp")
  endforeach()
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${patterns})
  set(${OUT} "${found}" PARENT_SCOPE)
endfunction()

function(marey_own_target TARGET)
  target_include_directories(${TARGET} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_compile_options(${TARGET} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
    # GCC 12 sees overlaps in `"text" + std::string` where there are none (GCC bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    $<$<BOOL:${MAREY_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# TARGET reads these headers of others once instead of in each of its files. They take longer than most of its own code.
function(marey_read_headers_once TARGET)
  target_precompile_headers(${TARGET} PRIVATE ${ARGN}
    <algorithm> <array> <cmath> <functional> <optional> <string> <string_view> <vector>)
  # GCC 12 then takes what it makes of std::string for our own code, and sees copies of half the memory in it. What these
  # warnings are for is left to the build with sanitizers.
  target_compile_options(${TARGET} PRIVATE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds;-Wno-stringop-overflow>)
endfunction()
