#include "encoders/parse/command_words.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace rtb {
namespace {

class Splitter {
 public:
  explicit Splitter(std::string_view text) : text_(text) {}

  Result<std::vector<std::string>> Split() {
    while (!text_.empty()) {
      const char c = Take();
      if (c == ' ' || c == '\t' || c == '\n') {
        EndWord();
      } else if (c == '\'' || c == '"') {
        RTB_RETURN_IF_ERROR(TakeQuoted(c));
      } else if (c == '\\' && !text_.empty()) {
        Word() += Take();
      } else {
        Word() += c;
      }
    }
    EndWord();
    return std::move(words_);
  }

 private:
  char Take() {
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }

  /// The word that has begun; quotes can begin an empty one.
  std::string& Word() { return word_ ? *word_ : word_.emplace(); }

  void EndWord() {
    if (word_) words_.push_back(std::move(*word_));
    word_.reset();
  }

  Status TakeQuoted(char quote) {
    std::string& word = Word();
    while (!text_.empty()) {
      const char c = Take();
      if (c == quote) return {};
      const bool quotes = c == '\\' && quote == '"' && !text_.empty() &&
                          (text_.front() == '\\' || text_.front() == '"');
      word += quotes ? Take() : c;
    }
    return Fail(BadInput("command",
                         std::string("a quote (") + quote + ") is not closed"));
  }

  std::string_view text_;
  std::optional<std::string> word_;
  std::vector<std::string> words_;
};

}  // namespace

Result<std::vector<std::string>> CommandWords(std::string_view command) {
  return Splitter(command).Split();
}

}  // namespace rtb
