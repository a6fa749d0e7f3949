#include "encoders/parse/terminal_input.h"

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "encoders/parse/ansi_token.h"
#include "encoders/parse/sgr.h"

namespace rtb {
namespace {

/// More columns than any terminal has.
constexpr int kMaxNumber = 9999;
/// libvterm 0.1.4 has room for 16.
constexpr int kMaxNumbers = 15;

bool Contains(std::string_view set, char c) {
  return set.find(c) != std::string_view::npos;
}

/// Whether a token changes what cells show. Line ends do not: see
/// TerminalInput.
bool Draws(const AnsiToken& token) {
  switch (token.kind) {
    case AnsiKind::kText:
      return true;
    case AnsiKind::kEscape:  // RIS, RI, DECALN.
      return token.intermediate.empty()
                 ? Contains("cM", token.final)
                 : token.intermediate == "#" && token.final == '8';
    case AnsiKind::kCsi:  // ICH, ED, EL, IL, DL, DCH, SU, SD, ECH, REP.
      return token.intermediate.empty() && Contains("@JKLMPSTXb", token.final);
    default:
      return false;
  }
}

/// The graphics that a token holds, or nothing.
std::string_view GraphicsOf(const AnsiToken& token) {
  if (token.kind != AnsiKind::kString) return "";
  const std::string_view body = token.body;
  const std::size_t data = body.find_first_not_of("0123456789;");
  if (token.final == 'P' && data != body.npos && body[data] == 'q') {
    return "sixel";
  }
  if (token.final == '_' && body.starts_with("G")) return "kitty";
  if (token.final == ']' && body.starts_with("1337;File=")) return "iTerm2";
  return "";
}

/// Calls `take` with each token and its end's distance from the beginning.
template <class Take>
void ForTokens(std::string_view text, const Take& take) {
  for (std::size_t at = 0; at < text.size();) {
    const AnsiToken token = FirstAnsiToken(text.substr(at));
    at += token.text.size();
    take(token, at);
  }
}

Status RefuseGraphics(std::string_view output) {
  std::string_view graphics;
  ForTokens(output, [&](const AnsiToken& token, std::size_t) {
    if (graphics.empty()) graphics = GraphicsOf(token);
  });
  if (graphics.empty()) return {};
  return Fail(BadInput(
      "ANSI text", "holds " + std::string(graphics) + " graphics, not cells",
      "have the program print characters (chafa: --format=symbols; timg: "
      "-p h or -p q)"));
}

std::size_t EndOfDrawing(std::string_view output) {
  std::size_t end = 0;
  ForTokens(output, [&](const AnsiToken& token, std::size_t token_end) {
    if (Draws(token)) end = token_end;
  });
  return end;
}

/// Writes what libvterm gets.
class InputWriter {
 public:
  void Write(const AnsiToken& token) {
    switch (token.kind) {
      case AnsiKind::kText:
        last_ = LastCharacter(token.text);
        input_ += token.text;
        break;
      case AnsiKind::kControl:
        if (token.final == '\n') input_ += '\r';
        input_ += token.final;
        break;
      case AnsiKind::kEscape:
        input_ += token.text;
        break;
      case AnsiKind::kCsi:
        WriteCsi(token);
        break;
      default:
        break;
    }
  }

  /// Of what draws nothing, the screen's reversal (DECSCNM) alone.
  void WriteRest(const AnsiToken& token) {
    const bool mode = token.IsCsi('h') || token.IsCsi('l');
    if (mode && token.body == "?5") WriteCsi(token);
  }

  std::string Take() { return std::move(input_); }

 private:
  static std::string_view LastCharacter(std::string_view text) {
    std::size_t begin = text.size() - 1;
    while (begin > 0 && (text[begin] & 0xC0) == 0x80) --begin;
    return text.substr(begin);
  }

  void WriteCsi(const AnsiToken& token) {
    const bool is_private =
        !token.body.empty() && Contains("<=>?", token.body[0]);
    if (token.IsCsi('m') && !is_private) {
      input_ += PortableSgr(token.body);
    } else if (token.IsCsi('b') && !is_private) {
      Repeat(token.body);
    } else {
      input_ += "\x1b[" + Bounded(token.body) +
                std::string(token.intermediate) + token.final;
    }
  }

  void Repeat(std::string_view count) {
    const int times = std::max(BoundedNumber(count), 1);
    for (int i = 0; i < times; ++i) input_ += last_;
  }

  static int BoundedNumber(std::string_view text) {
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    const bool large = result.ec == std::errc::result_out_of_range;
    return large ? kMaxNumber : std::clamp(number, 0, kMaxNumber);
  }

  /// Parameters that libvterm can hold, as many as it can hold.
  static std::string Bounded(std::string_view parameters) {
    std::string text;
    for (int count = 0; !parameters.empty() && count < kMaxNumbers;) {
      const std::size_t digits = std::min(
          parameters.find_first_not_of("0123456789"), parameters.size());
      if (digits > 0) {
        text += std::to_string(BoundedNumber(parameters.substr(0, digits)));
        parameters.remove_prefix(digits);
      } else {
        if (Contains(";:", parameters[0])) ++count;
        text += parameters[0];
        parameters.remove_prefix(1);
      }
    }
    return text;
  }

  std::string input_;
  std::string_view last_;  ///< The last character written.
};

}  // namespace

Result<std::string> TerminalInput(std::string_view output) {
  RTB_RETURN_IF_ERROR(RefuseGraphics(output));
  const std::size_t drawn = EndOfDrawing(output);
  InputWriter writer;
  ForTokens(output, [&](const AnsiToken& token, std::size_t end) {
    end <= drawn ? writer.Write(token) : writer.WriteRest(token);
  });
  return writer.Take();
}

}  // namespace rtb
