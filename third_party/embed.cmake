# Writes OUT: the files of ROOT/shaders and ROOT/assets as constant bytes (scene/embedded.h declares them); textures as
# TEXTURES has them, if there is such a folder.
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/shaders/*.glsl ${ROOT}/assets/scenes/*.json
     ${ROOT}/assets/lessons/*.json ${ROOT}/assets/gallery/*.json ${ROOT}/assets/exercises/*.json ${ROOT}/assets/words/*.json ${ROOT}/assets/textures/*.png ${ROOT}/assets/models/*.obj
     ${ROOT}/assets/stability/*.obj ${ROOT}/assets/stability/*.json ${ROOT}/assets/page/*)
list(SORT files)
set(arrays "")
set(rows "")
set(number 0)
foreach(file IN LISTS files)
  set(source ${ROOT}/${file})
  if(TEXTURES AND file MATCHES "^assets/textures/")
    cmake_path(GET file FILENAME name)
    set(source ${TEXTURES}/${name})
  endif()
  file(READ ${source} hex HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${hex}")
  string(APPEND arrays "constexpr char file_${number}[] = {${bytes}0};\n")
  string(APPEND rows "    {\"${file}\", {file_${number}, sizeof(file_${number}) - 1}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUT} "#include \"scene/embedded.h\"\n\n#include <array>\n\nnamespace sandbox {\nnamespace {\n${arrays}\n"
     "constexpr std::array<EmbeddedFile, ${number}> files{{\n${rows}}};\n} // namespace\n\n"
     "std::span<const EmbeddedFile> embedded_files() { return files; }\n} // namespace sandbox\n")
