# Toolchain file: the emsdk that EMSDK names, else the Emscripten of the system (3.1.6 or newer).
if(DEFINED ENV{EMSDK})
  set(EMSCRIPTEN_ROOT_PATH "$ENV{EMSDK}/upstream/emscripten")
else()
  find_path(EMSCRIPTEN_ROOT_PATH cmake/Modules/Platform/Emscripten.cmake
    PATHS /usr/share/emscripten /usr/lib/emscripten /opt/homebrew/opt/emscripten/libexec
    NO_DEFAULT_PATH REQUIRED)
  # Debian's Emscripten takes its JavaScript optimiser's parser from there, and does not look by itself.
  if(EXISTS /usr/share/nodejs/acorn)
    set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)
  endif()
endif()
include("${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake")
