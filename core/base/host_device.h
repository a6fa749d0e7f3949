/// @file
/// RTB_HD marks functions that compile for the host and, under nvcc, for the
/// device. Such code allocates nothing, throws nothing and makes no virtual
/// calls.
#pragma once

#ifdef __CUDACC__
#define RTB_HD __host__ __device__
#else
#define RTB_HD
#endif
