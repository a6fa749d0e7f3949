// Encoder `chafa`: what libchafa, the library of the terminal graphics program
// of that name, chooses from 8 x 8 pixels a cell.
#include "encoders/chafa.h"

#include "encoders/parameters.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

/// chafa's own default.
const EncoderParameter& SymbolsParameter() {
  static const EncoderParameter parameter{
      "symbols", "block+border+space-wide-inverted", "chafa's --symbols",
      "classes of characters, joined by + and -; wide ones are never used"};
  return parameter;
}

const EncoderParameter& WorkParameter() {
  static const EncoderParameter parameter{"work", "9", "1|2|3|4|5|6|7|8|9",
                                          "how hard to look, chafa's --work"};
  return parameter;
}

const EncoderParameter& ExtractorParameter() {
  static const EncoderParameter parameter{
      "extractor", "average", "average|median",
      "how colors come from pixels, chafa's --color-extractor"};
  return parameter;
}

const EncoderParameter& SpaceParameter() {
  static const EncoderParameter parameter{
      "space", "rgb", "rgb|din99d",
      "where colors are compared, chafa's --color-space"};
  return parameter;
}

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  ChafaOptions options;
  options.symbols = ValueOf(SymbolsParameter(), given);
  RTB_ASSIGN_OR_RETURN(const int work, ReadChoice(WorkParameter(), given));
  options.work = work + 1;
  RTB_ASSIGN_OR_RETURN(const int median,
                       ReadChoice(ExtractorParameter(), given));
  options.median = median == 1;
  RTB_ASSIGN_OR_RETURN(const int din99d, ReadChoice(SpaceParameter(), given));
  options.din99d = din99d == 1;
  return MakeChafa(options);
}

}  // namespace

EncoderEntry chafa_entry() {
  EncoderInfo info{"chafa",
                   "what libchafa chooses",
                   64,
                   "its own; by default blocks and box drawing",
                   {SymbolsParameter(), WorkParameter(), ExtractorParameter(),
                    SpaceParameter()}};
  info.version = ChafaVersion();
  if (info.version.empty()) info.why_not = "built without libchafa";
  return {info, Make};
}

}  // namespace rtb
