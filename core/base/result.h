/// @file
/// Result<T>: a value or an Error. Built on tl::expected, the reference
/// implementation of C++23's std::expected.
#pragma once

#include <tl/expected.hpp>
#include <utility>

#include "core/base/error.h"

namespace rtb {

/// A T, or the Error that explains why there is none.
template <class T>
using Result = tl::expected<T, Error>;

/// Success without a value, or an Error.
using Status = tl::expected<void, Error>;

/// Wraps an Error for returning: `return Fail(BadInput(...));`.
inline tl::unexpected<Error> Fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace rtb

#define RTB_CONCAT_INNER(a, b) a##b
#define RTB_CONCAT(a, b) RTB_CONCAT_INNER(a, b)

/// Returns the Error of a Result or Status expression from the calling
/// function, if it holds one.
#define RTB_RETURN_IF_ERROR(expression)                                 \
  do {                                                                  \
    auto rtb_status = (expression);                                     \
    if (!rtb_status) return ::rtb::Fail(std::move(rtb_status.error())); \
  } while (false)

/// `RTB_ASSIGN_OR_RETURN(auto x, F());` binds the value of F(), or returns its
/// Error from the calling function.
#define RTB_ASSIGN_OR_RETURN(declaration, expression)                       \
  RTB_ASSIGN_OR_RETURN_IMPL(RTB_CONCAT(rtb_result_, __LINE__), declaration, \
                            expression)
#define RTB_ASSIGN_OR_RETURN_IMPL(result, declaration, expression) \
  auto result = (expression);                                      \
  if (!result) return ::rtb::Fail(std::move(result.error()));      \
  declaration = std::move(*result)
