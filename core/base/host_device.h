/// @file
/// RTB_HD marks functions that compile for the host and, under nvcc, for the
/// device. Such code allocates nothing, throws nothing and makes no virtual
/// calls. RTB_HD_CALLED marks those that device code keeps one copy of and
/// calls: large ones with several callers, such as the walk through a scene.
#pragma once

#ifdef __CUDACC__
#define RTB_HD __host__ __device__
#define RTB_HD_CALLED __host__ __device__ __noinline__
#else
#define RTB_HD
#define RTB_HD_CALLED
#endif
