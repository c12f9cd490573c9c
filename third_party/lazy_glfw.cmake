# Writes OUT: each function of GLFW's HEADER as one that looks for it in the library, which the first call opens. Only a
# window needs GLFW and the X11 that it brings; linked, they would make every start slower, and be needed by servers.
file(STRINGS ${HEADER} prototypes REGEX "^GLFWAPI ")
set(functions "")
foreach(prototype IN LISTS prototypes)
  if(NOT prototype MATCHES "Vk|vk" AND prototype MATCHES "^GLFWAPI (.*[ *])(glfw[A-Za-z0-9]+)\\((.*)\\)[;]$")
    set(result ${CMAKE_MATCH_1})
    set(name ${CMAKE_MATCH_2})
    set(parameters ${CMAKE_MATCH_3})
    string(REGEX REPLACE "[^,]*[ *]([A-Za-z]+)(,|$)" ", \\1" arguments " ${parameters}")
    string(REPLACE ", void" "" arguments "${arguments}")
    string(APPEND functions
           "${result}${name}(${parameters}) { return call<${result}>(\"${name}\"${arguments}); }\n")
  endif()
endforeach()
file(WRITE ${OUT} "#define GLFW_INCLUDE_NONE\n#include <GLFW/glfw3.h>\n#include <dlfcn.h>\n\nnamespace {\n
void *library() {
    static void *const opened = dlopen(\"libglfw.so.3\", RTLD_NOW);
    return opened;
}

/// 0 without the library.
template <class Result, class... Arguments> Result call(const char *name, Arguments... arguments) {
    void *const found = library() != nullptr ? dlsym(library(), name) : nullptr;
    return found != nullptr ? reinterpret_cast<Result (*)(Arguments...)>(found)(arguments...) : Result();
}
\n} // namespace\n\n${functions}")
