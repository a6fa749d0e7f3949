/// @file
/// Checks of our own invariants. They stay on in every build: a wrong number
/// is worse than none.
#pragma once

#include <sstream>
#include <string>

namespace rtb {

/// Prints the failed check to stderr and aborts.
[[noreturn]] void CheckFailed(const char* file, int line,
                              const std::string& message);

/// `text (a vs. b)`, for the comparing checks.
template <class A, class B>
std::string CheckMessage(const char* text, const A& a, const B& b) {
  std::ostringstream out;
  out << text << " (" << a << " vs. " << b << ")";
  return out.str();
}

}  // namespace rtb

/// Aborts with file and line when `condition` is false.
#define RTB_CHECK(condition)                                              \
  do {                                                                    \
    if (!(condition)) ::rtb::CheckFailed(__FILE__, __LINE__, #condition); \
  } while (false)

#define RTB_CHECK_OP(op, a, b)                                   \
  do {                                                           \
    const auto& rtb_a = (a);                                     \
    const auto& rtb_b = (b);                                     \
    if (!(rtb_a op rtb_b))                                       \
      ::rtb::CheckFailed(                                        \
          __FILE__, __LINE__,                                    \
          ::rtb::CheckMessage(#a " " #op " " #b, rtb_a, rtb_b)); \
  } while (false)

/// @name Comparing checks that print both operands.
/// @{
#define RTB_CHECK_EQ(a, b) RTB_CHECK_OP(==, a, b)
#define RTB_CHECK_LT(a, b) RTB_CHECK_OP(<, a, b)
#define RTB_CHECK_LE(a, b) RTB_CHECK_OP(<=, a, b)
#define RTB_CHECK_GE(a, b) RTB_CHECK_OP(>=, a, b)
#define RTB_CHECK_GT(a, b) RTB_CHECK_OP(>, a, b)
/// @}
