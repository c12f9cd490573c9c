# Checks of the code itself, where their tools are installed: targets format-check, format and tidy.
file(GLOB_RECURSE our_code CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/sandbox/*.cpp ${PROJECT_SOURCE_DIR}/sandbox/*.h
     ${PROJECT_SOURCE_DIR}/tests/*.cpp ${PROJECT_SOURCE_DIR}/tests/*.h)

find_program(CLANG_FORMAT clang-format)
if(CLANG_FORMAT)
  add_custom_target(format-check COMMAND ${CLANG_FORMAT} --dry-run --Werror ${our_code} VERBATIM)
  add_custom_target(format COMMAND ${CLANG_FORMAT} -i ${our_code} VERBATIM)
endif()

find_program(RUN_CLANG_TIDY run-clang-tidy)
if(RUN_CLANG_TIDY)
  # A build by GCC names warnings that Clang does not know.
  add_custom_target(tidy COMMAND ${RUN_CLANG_TIDY} -quiet -extra-arg=-Wno-unknown-warning-option -p ${PROJECT_BINARY_DIR}
                                 "/(sandbox|tests)/.*\\.cpp$" VERBATIM)
endif()
