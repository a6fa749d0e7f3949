# rtb_build_info(target): lets the target include "build_info.inc" (how it is
# built, known when CMake runs) and "commit.inc" (what it is built from, asked
# of git in every build; the file changes only when the answer does).

set(RTB_BUILD_INFO_DIR ${CMAKE_CURRENT_LIST_DIR})

function(rtb_build_info target)
  set(folder ${CMAKE_BINARY_DIR}/build_info)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_target_property(options rtb_flags INTERFACE_COMPILE_OPTIONS)
  list(JOIN options " " options)
  string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${options}"
         RTB_FLAGS)
  configure_file(${RTB_BUILD_INFO_DIR}/build_info.inc.in
                 ${folder}/build_info.inc @ONLY)

  find_package(Git QUIET)
  add_custom_target(rtb_commit
    COMMAND ${CMAKE_COMMAND} -DGIT=${GIT_EXECUTABLE}
            -DSOURCE=${PROJECT_SOURCE_DIR} -DOUTPUT=${folder}/commit.inc
            -P ${RTB_BUILD_INFO_DIR}/WriteCommit.cmake
    BYPRODUCTS ${folder}/commit.inc
    COMMENT "Asking git for the commit"
    VERBATIM)
  add_dependencies(${target} rtb_commit)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
