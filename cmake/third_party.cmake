# Libraries that are not Marey's own: headers of the system, GoogleTest, Dear ImGui. Each is a SYSTEM target, so that
# its warnings are not ours.

# A header-only library of the system as INTERFACE target NAME. Emscripten must not see all of /usr/include, so both
# native and wasm read the header through a folder of links in the build tree.
function(marey_add_header_library NAME HEADER)
  find_path(${NAME}_ROOT ${HEADER} NO_CMAKE_FIND_ROOT_PATH REQUIRED
    PATHS /usr/include /usr/local/include /opt/homebrew/include)
  mark_as_advanced(${NAME}_ROOT)
  string(REGEX REPLACE "/.*" "" folder "${HEADER}")
  set(links "${PROJECT_BINARY_DIR}/include/${NAME}")
  file(MAKE_DIRECTORY "${links}")
  file(CREATE_LINK "${${NAME}_ROOT}/${folder}" "${links}/${folder}" SYMBOLIC)
  add_library(${NAME} INTERFACE)
  target_include_directories(${NAME} SYSTEM INTERFACE "${links}")
endfunction()

marey_add_header_library(glm glm/glm.hpp)
target_compile_definitions(glm INTERFACE GLM_FORCE_EXPLICIT_CTOR GLM_ENABLE_EXPERIMENTAL)
marey_add_header_library(fmt fmt/format.h)
# Nothing here formats a long double or thousands.
target_compile_definitions(fmt INTERFACE FMT_EXCEPTIONS=0 FMT_USE_LONG_DOUBLE=0 FMT_USE_INT128=0 "FMT_STATIC_THOUSANDS_SEPARATOR=','")
# What fmt_library.cpp names is that of {fmt} 9; with another one each file compiles all of it.
file(STRINGS "${fmt_ROOT}/fmt/core.h" fmt_version REGEX "#define FMT_VERSION 9[0-9][0-9][0-9][0-9]$")
if(fmt_version)
  add_library(marey_fmt STATIC EXCLUDE_FROM_ALL "${CMAKE_CURRENT_LIST_DIR}/fmt_library.cpp")
  target_link_libraries(marey_fmt PRIVATE fmt)
  add_library(fmt_library INTERFACE)
  target_link_libraries(fmt_library INTERFACE fmt marey_fmt)
else()
  add_library(fmt_library INTERFACE)
  target_link_libraries(fmt_library INTERFACE fmt)
  target_compile_definitions(fmt_library INTERFACE FMT_HEADER_ONLY)
endif()
marey_add_header_library(fast_float fast_float/fast_float.h)
marey_add_header_library(nlohmann_json nlohmann/json.hpp)
if(NOT EMSCRIPTEN)
  marey_add_header_library(cli11 CLI/CLI.hpp)
endif()

# GoogleTest from its sources where the system has them (Debian), so that it is built with the same flags and for wasm.
find_path(GOOGLETEST_SOURCES googletest/src/gtest-all.cc NO_CMAKE_FIND_ROOT_PATH PATHS /usr/src/googletest)
mark_as_advanced(GOOGLETEST_SOURCES)
if(GOOGLETEST_SOURCES)
  add_library(marey_gtest STATIC EXCLUDE_FROM_ALL
    "${GOOGLETEST_SOURCES}/googletest/src/gtest-all.cc"
    "${GOOGLETEST_SOURCES}/googlemock/src/gmock-all.cc"
    "${GOOGLETEST_SOURCES}/googlemock/src/gmock_main.cc")
  target_include_directories(marey_gtest SYSTEM PUBLIC
    "${GOOGLETEST_SOURCES}/googletest/include" "${GOOGLETEST_SOURCES}/googlemock/include")
  target_include_directories(marey_gtest PRIVATE "${GOOGLETEST_SOURCES}/googletest" "${GOOGLETEST_SOURCES}/googlemock")
else()
  find_package(GTest REQUIRED)
  add_library(marey_gtest INTERFACE)
  target_link_libraries(marey_gtest INTERFACE GTest::gmock_main)
endif()

# Dear ImGui's sources lie where scripts/setup/imgui.mjs puts them.
set(MAREY_IMGUI_DIR "${PROJECT_SOURCE_DIR}/build/deps/imgui" CACHE PATH "Dear ImGui, 1.92.2b, sources")
if(EXISTS "${MAREY_IMGUI_DIR}/imgui.cpp")
  file(GLOB imgui_sources "${MAREY_IMGUI_DIR}/imgui*.cpp" "${MAREY_IMGUI_DIR}/misc/cpp/*.cpp")
  add_library(imgui STATIC EXCLUDE_FROM_ALL ${imgui_sources})
  target_include_directories(imgui SYSTEM PUBLIC "${MAREY_IMGUI_DIR}")
  # WebGL 2 has no base vertex, and a window full of curves can have more than 65536 vertices.
  target_compile_definitions(imgui PUBLIC IMGUI_DISABLE_OBSOLETE_FUNCTIONS IMGUI_DISABLE_DEMO_WINDOWS
    IMGUI_DISABLE_FILE_FUNCTIONS IMGUI_DISABLE_DEFAULT_SHELL_FUNCTIONS IMGUI_DISABLE_DEFAULT_FONT "ImDrawIdx=unsigned int")
  if(EMSCRIPTEN)
    set(renderer "${MAREY_IMGUI_DIR}/backends/imgui_impl_opengl3.cpp")
    target_sources(imgui PRIVATE "${renderer}")
    # See wasm/platform/web/known_gl_state.cpp.
    set_source_files_properties("${renderer}" PROPERTIES COMPILE_DEFINITIONS glGetIntegerv=marey_get_known_gl_state)
    target_compile_definitions(imgui PUBLIC IMGUI_IMPL_OPENGL_ES3)
    # For the first load of the page: all but the drawing of lines and shapes is small rather than quick.
    set(small_imgui ${imgui_sources})
    list(FILTER small_imgui EXCLUDE REGEX "imgui_draw\\.cpp$")
    set_source_files_properties(${small_imgui} PROPERTIES COMPILE_OPTIONS "-Oz")
  endif()
endif()
