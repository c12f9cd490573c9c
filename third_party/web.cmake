# The same targets for WebAssembly: header libraries as the system has them, the others built from the sources of the
# same Debian packages (web_tools.sh).
include(ExternalProject)
set(sources ${SANDBOX_WEB_TOOLS}/sources)

# Not /usr/include itself: the system's C library is another machine's here.
set(headers ${CMAKE_CURRENT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(library glm nlohmann CLI) # libglm-dev, nlohmann-json3-dev, libcli11-dev
  if(NOT EXISTS /usr/include/${library})
    message(FATAL_ERROR "/usr/include/${library} is missing: run third_party/install.sh web")
  endif()
  file(CREATE_LINK /usr/include/${library} ${headers}/${library} SYMBOLIC)
endforeach()
add_library(web_headers INTERFACE)
target_include_directories(web_headers SYSTEM INTERFACE ${headers})
foreach(target glm::glm nlohmann_json::nlohmann_json CLI11::CLI11)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_link_libraries(${target} INTERFACE web_headers)
endforeach()
# None: one thread, the browser's canvas, WebGL's functions linked; of GLFW the names of keys.
foreach(target Threads::Threads OpenGL::EGL glfw::glfw glad::gl33)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
endforeach()

add_library(web_fmt STATIC ${sources}/fmtlib/src/format.cc)
target_include_directories(web_fmt SYSTEM PUBLIC ${sources}/fmtlib/include)
add_library(fmt::fmt ALIAS web_fmt)

file(GLOB zlib_sources ${sources}/zlib/*.c)
list(FILTER zlib_sources EXCLUDE REGEX "/gz[a-z]*\\.c$")
add_library(web_zlib STATIC ${zlib_sources})
target_include_directories(web_zlib SYSTEM PUBLIC ${sources}/zlib)
add_library(ZLIB::ZLIB ALIAS web_zlib)

add_library(web_spng STATIC ${sources}/libspng/spng/spng.c)
target_include_directories(web_spng SYSTEM PUBLIC ${sources}/libspng/spng)
target_link_libraries(web_spng PUBLIC web_zlib)
add_library(PkgConfig::SPNG ALIAS web_spng)

set(jpeg ${CMAKE_CURRENT_BINARY_DIR}/jpeg)
ExternalProject_Add(web_jpeg_build
  SOURCE_DIR ${sources}/libjpeg-turbo
  BINARY_DIR ${jpeg}
  CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=${CMAKE_TOOLCHAIN_FILE} -DCMAKE_BUILD_TYPE=Release -DENABLE_SHARED=OFF -DWITH_SIMD=OFF
             -DWITH_TURBOJPEG=OFF
  BUILD_COMMAND ${CMAKE_COMMAND} --build . --target jpeg-static
  BUILD_BYPRODUCTS ${jpeg}/libjpeg.a
  INSTALL_COMMAND "")
add_library(JPEG::JPEG INTERFACE IMPORTED GLOBAL)
add_dependencies(JPEG::JPEG web_jpeg_build)
target_include_directories(JPEG::JPEG SYSTEM INTERFACE ${sources}/libjpeg-turbo ${jpeg})
target_link_libraries(JPEG::JPEG INTERFACE ${jpeg}/libjpeg.a)

set(imgui ${sources}/imgui)
add_library(web_imgui STATIC ${imgui}/imgui.cpp ${imgui}/imgui_draw.cpp ${imgui}/imgui_tables.cpp ${imgui}/imgui_widgets.cpp
            ${imgui}/backends/imgui_impl_opengl3.cpp ${imgui}/misc/cpp/imgui_stdlib.cpp)
target_include_directories(web_imgui SYSTEM PUBLIC ${imgui} ${imgui}/misc/cpp)
# What no page uses; the debugging tools by their names in 1.86 and in 1.90.
target_compile_definitions(web_imgui PUBLIC IMGUI_IMPL_OPENGL_ES3 IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_METRICS_WINDOW
                           IMGUI_DISABLE_DEBUG_TOOLS IMGUI_DISABLE_OBSOLETE_KEYIO)
add_library(imgui::imgui ALIAS web_imgui)
set(IMGUI_INCLUDE_DIRS ${imgui} PARENT_SCOPE)
