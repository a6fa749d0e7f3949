#include "encoders/modifiers/modifiers.h"

#include <vector>

#include "encoders/blend.h"
#include "encoders/parameters.h"

namespace rtb {
namespace {

constexpr char kGeometric[] = "geometric";

const EncoderParameter& ColorParameter() {
  static const EncoderParameter parameter{
      "color", "mean", "mean|median",
      "the two colors: as the encoder averages them, or the geometric median "
      "of each side"};
  return parameter;
}

const EncoderParameter& TemporalParameter() {
  static const EncoderParameter parameter{
      "temporal", "0", "number from 0 to 100",
      "keep the last frame's cell while noise explains the difference; 3 is a "
      "good value, 0 is off"};
  return parameter;
}

const EncoderParameter& SigmaParameter() {
  static const EncoderParameter parameter{
      "sigma", "auto", "auto or a number from 0 to 255",
      "standard deviation of a sample's noise, in 8-bit codes; auto: as the "
      "renderer estimates it with --spp > 1, else 0"};
  return parameter;
}

const EncoderParameter& DitherParameter() {
  static const EncoderParameter parameter{
      "dither", "none", "none|bayer|noise|fs",
      "with --color=256|16|mono: how the error of the palette is spread"};
  return parameter;
}

const EncoderParameter& AtlasParameter() {
  static const EncoderParameter parameter{
      "atlas", kGeometric, "geometric or a font file",
      "coverage masks used for choosing; a font's decide by least squares"};
  return parameter;
}

}  // namespace

std::span<const EncoderParameter> ModifierParameters() {
  static const std::vector<EncoderParameter> parameters = {
      ColorParameter(), TemporalParameter(), SigmaParameter(),
      DitherParameter(), AtlasParameter()};
  return parameters;
}

Result<Modifiers> ReadModifiers(const EncoderParameters& given) {
  Modifiers modifiers;
  RTB_ASSIGN_OR_RETURN(const int color, ReadChoice(ColorParameter(), given));
  modifiers.color = static_cast<ColorRule>(color);
  RTB_ASSIGN_OR_RETURN(modifiers.temporal,
                       ReadNumber(TemporalParameter(), given, 0, 100));
  if (ValueOf(SigmaParameter(), given) != SigmaParameter().default_value) {
    RTB_ASSIGN_OR_RETURN(const double sigma,
                         ReadNumber(SigmaParameter(), given, 0, 255));
    modifiers.sigma = sigma / 255;
  }
  RTB_ASSIGN_OR_RETURN(const int dither, ReadChoice(DitherParameter(), given));
  modifiers.dither = static_cast<Dither>(dither);
  const std::string& atlas = ValueOf(AtlasParameter(), given);
  if (atlas != kGeometric) modifiers.atlas = atlas;
  return modifiers;
}

}  // namespace rtb
