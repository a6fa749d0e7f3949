# rtb_cuda(target folder): gives the target what a folder named cuda holds -
# the .cu files and the .cc files around them, or no_cuda.cc alone where CUDA
# is not wanted (RTB_CUDA) or there is no nvcc.
#
# RTB_CUDA_FLAGS is what every .cu file is compiled with; scripts/cuda_report
# reads it here.

option(RTB_CUDA "Build the CUDA backend where nvcc is found" OFF)
set(RTB_CUDA_ARCHITECTURES
    75-real 80-real 86-real 89-real 90-real 100-real 120
    CACHE STRING "GPUs to compile for; the last also as PTX, for newer ones")

# + - * / and sqrt round as the host's do: no contraction, IEEE division and
# roots, denormals kept. Imath's conversions between vector types need host
# code; std::array's members are constexpr, not marked for devices.
set(RTB_CUDA_FLAGS
    --fmad=false --prec-div=true --prec-sqrt=true --ftz=false
    --expt-relaxed-constexpr -DIMATH_FOREIGN_VECTOR_INTEROP=0)

set(RTB_CUDA_FOUND OFF)
if(RTB_CUDA)
  include(CheckLanguage)
  # Where CUDA's packages put it, which no PATH names by itself.
  find_program(RTB_NVCC nvcc HINTS /usr/local/cuda/bin)
  if(RTB_NVCC AND NOT CMAKE_CUDA_COMPILER AND NOT DEFINED ENV{CUDACXX})
    set(CMAKE_CUDA_COMPILER ${RTB_NVCC})
  endif()
  check_language(CUDA)
  if(CMAKE_CUDA_COMPILER)
    set(CMAKE_CUDA_ARCHITECTURES ${RTB_CUDA_ARCHITECTURES})
    enable_language(CUDA)
    find_package(CUDAToolkit REQUIRED)
    set(RTB_CUDA_FOUND ON)
    # CMake 3.25 does not know that nvcc 13 has C++20.
    if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)
      set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
      set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20)
    endif()
  else()
    message(WARNING "RTB_CUDA is on, but there is no nvcc: the backend cuda is "
                    "not built")
  endif()
endif()

function(rtb_cuda target folder)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/${folder})
  if(NOT RTB_CUDA_FOUND)
    target_sources(${target} PRIVATE ${folder}/no_cuda.cc)
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cc)
  list(FILTER sources EXCLUDE REGEX "/no_cuda\\.cc$")
  file(GLOB kernels CONFIGURE_DEPENDS ${folder}/*.cu)
  find_package(Imath REQUIRED)
  find_package(tl-expected REQUIRED)
  # A library of its own: the host compiler's warnings are not nvcc's.
  add_library(${target}_kernels OBJECT ${kernels})
  target_include_directories(${target}_kernels PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${target}_kernels PRIVATE
    ${RTB_CUDA_FLAGS} -Xcompiler=-ffp-contract=off)
  target_link_libraries(${target}_kernels PRIVATE Imath::Imath tl::expected)
  target_sources(${target} PRIVATE ${sources}
                                   $<TARGET_OBJECTS:${target}_kernels>)
  # The static runtime looks for the driver when it is first asked.
  target_link_libraries(${target} PRIVATE CUDA::cudart_static)
endfunction()
