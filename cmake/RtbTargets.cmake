# Flags that every target of the project shares, and the helpers that make
# targets: rtb_library(name) takes every .cc below the calling folder.

add_library(rtb_flags INTERFACE)
target_include_directories(rtb_flags INTERFACE ${PROJECT_SOURCE_DIR})
# No contraction, never fast-math: + - * / and sqrt agree bit for bit between
# compilers and devices.
target_compile_options(rtb_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off)
# GCC 12 sees overlaps in "text" + std::string that cannot be (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND
   CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(rtb_flags INTERFACE -Wno-restrict)
endif()
if(RTB_WARNINGS_AS_ERRORS)
  target_compile_options(rtb_flags INTERFACE -Werror)
endif()
if(RTB_SANITIZE)
  target_compile_options(rtb_flags INTERFACE
    -fsanitize=${RTB_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  target_link_options(rtb_flags INTERFACE -fsanitize=${RTB_SANITIZE})
endif()
if(RTB_COVERAGE)
  target_compile_options(rtb_flags INTERFACE --coverage)
  target_link_options(rtb_flags INTERFACE --coverage)
endif()

# Headers of libraries are not ours to warn about.
function(rtb_link target)
  target_link_libraries(${target} PUBLIC rtb_flags ${ARGN})
endfunction()

function(rtb_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cc)
  list(FILTER sources EXCLUDE REGEX "/main\\.cc$|/cuda/[^/]*$")
  add_library(${name} STATIC ${sources})
  rtb_link(${name})
endfunction()
