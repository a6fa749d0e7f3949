cmake_minimum_required(VERSION 3.25)

# cmake -DGIT=... -DSOURCE=... -DOUTPUT=... -P WriteCommit.cmake
# Writes the commit of the SOURCE folder and whether tracked files differ from
# it. Without git, or outside a repository of its own, the commit is unknown.

set(ENV{GIT_OPTIONAL_LOCKS} 0)
# A hook's variables would lead git elsewhere.
unset(ENV{GIT_DIR})
unset(ENV{GIT_INDEX_FILE})
unset(ENV{GIT_WORK_TREE})

function(ask variable)
  set(${variable} "" PARENT_SCOPE)
  if(NOT GIT)
    return()
  endif()
  execute_process(COMMAND ${GIT} ${ARGN} WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE answer RESULT_VARIABLE failed ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failed)
    set(${variable} "${answer}" PARENT_SCOPE)
  endif()
endfunction()

set(commit unknown)
set(dirty false)
# The prefix is empty at a repository's root alone: an unpacked archive inside
# another repository is not that repository's commit.
ask(inside rev-parse --is-inside-work-tree)
ask(prefix rev-parse --show-prefix)
if(inside STREQUAL "true" AND prefix STREQUAL "")
  ask(head rev-parse HEAD)
  ask(changes status --porcelain --untracked-files=no)
  if(head)
    set(commit ${head})
  endif()
  if(NOT changes STREQUAL "")
    set(dirty true)
  endif()
endif()

file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT
"// Written in every build.
constexpr char kCommit[] = \"@commit@\";
constexpr bool kDirty = @dirty@;
")
