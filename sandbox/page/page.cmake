# The page: one HTML file that holds everything, and the same as HTML and WebAssembly.
set(page ${CMAKE_CURRENT_LIST_DIR})

# Only the characters that the program's words need, and Latin, Greek and signs: the browser draws the others.
set(fonts ${CMAKE_CURRENT_BINARY_DIR}/fonts)
add_custom_command(
  OUTPUT ${fonts}/DejaVuSans.ttf
  COMMAND /usr/bin/python3 ${page}/subset_fonts.py ${PROJECT_SOURCE_DIR}/assets ${fonts}
  DEPENDS ${page}/subset_fonts.py ${embedded_inputs}
  COMMENT "Choosing the fonts' characters"
  VERBATIM)
add_custom_target(page_fonts DEPENDS ${fonts}/DejaVuSans.ttf)
add_dependencies(shading-sandbox page_fonts)

set(scripts ${page}/threads.js ${page}/glyphs.js ${page}/browser.js)
list(TRANSFORM scripts PREPEND "--js-library=" OUTPUT_VARIABLE libraries)
target_link_options(shading-sandbox PRIVATE ${libraries} --pre-js=${page}/start.js --embed-file=${fonts}@/usr/share/fonts
  -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=2GB -sINITIAL_MEMORY=64MB -sSTACK_SIZE=2MB -sENVIRONMENT=web -sFORCE_FILESYSTEM=1 -sMALLOC=emmalloc
  -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
  -sEXPORTED_RUNTIME_METHODS=FS,stringToNewUTF8 -sINCOMING_MODULE_JS_API=instantiateWasm,arguments,print,printErr,preRun,canvas,onAbort)
set_target_properties(shading-sandbox PROPERTIES LINK_DEPENDS "${scripts};${page}/start.js;${fonts}/DejaVuSans.ttf")

set(html ${CMAKE_CURRENT_BINARY_DIR}/shading-sandbox.html)
add_custom_command(
  OUTPUT ${html}
  COMMAND /usr/bin/python3 ${page}/pack.py ${page} $<TARGET_FILE_DIR:shading-sandbox> ${CMAKE_CURRENT_BINARY_DIR}
  DEPENDS shading-sandbox ${page}/pack.py ${page}/page.html ${page}/page.css ${page}/licences.html ${page}/loader.js
  COMMENT "Packing the page"
  VERBATIM)
add_custom_target(page ALL DEPENDS ${html})
install(FILES ${html} DESTINATION share/shading-sandbox)
install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/split/ DESTINATION share/shading-sandbox/split)
