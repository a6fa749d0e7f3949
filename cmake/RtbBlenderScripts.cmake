# rtb_blender_scripts(target): lets the target include "blender_scripts.inc",
# the Python files of reference/blender as {name, text} pairs, render.py first,
# so that the program needs no files beside it.

function(rtb_blender_scripts target)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/blender)
  file(GLOB scripts CONFIGURE_DEPENDS ${folder}/*.py)
  list(REMOVE_ITEM scripts ${folder}/render.py)
  list(PREPEND scripts ${folder}/render.py)
  set(table "")
  foreach(script IN LISTS scripts)
    cmake_path(GET script FILENAME name)
    file(READ ${script} text)
    string(APPEND table "{\"${name}\", R\"script(${text})script\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/blender_scripts.inc
       CONTENT "@table@" @ONLY)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
