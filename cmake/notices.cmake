# Puts the version and NOTICES.md into TARGET, so that the page's About has them without asking for a file.
function(marey_add_notices TARGET)
  set(notices "${PROJECT_SOURCE_DIR}/NOTICES.md")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${notices}")
  file(READ "${notices}" MAREY_NOTICES)
  configure_file("${PROJECT_SOURCE_DIR}/wasm/views/notices.cpp.in" "${PROJECT_BINARY_DIR}/generated/notices.cpp" @ONLY)
  target_sources(${TARGET} PRIVATE "${PROJECT_BINARY_DIR}/generated/notices.cpp")
endfunction()
