#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "encoders/registry.h"

namespace rtb {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The one-line message of a SPEC that must fail as bad input.
std::string ErrorOf(std::string_view spec) {
  const auto encoder = MakeEncoder(spec);
  if (encoder) return "no error";
  EXPECT_EQ(encoder.error().kind, ErrorKind::kBadInput);
  return encoder.error().ToString();
}

TEST(EncoderSpecTest, SplitsNameAndParameters) {
  const auto spec = ParseEncoderSpec("quadrant:split=best:blend=oklab");
  ASSERT_TRUE(spec);
  EXPECT_EQ(spec->name, "quadrant");
  EXPECT_EQ(spec->parameters,
            (EncoderParameters{{"split", "best"}, {"blend", "oklab"}}));
  EXPECT_EQ(spec->text, "quadrant:split=best:blend=oklab");
}

TEST(EncoderSpecTest, QuotesProtectSeparators) {
  const auto specs = ParseEncoderSpecs("quadrant:split='a,b:c=d',half");
  ASSERT_TRUE(specs) << specs.error().ToString();
  ASSERT_EQ(specs->size(), 2u);
  EXPECT_EQ((*specs)[0].parameters.at("split"), "a,b:c=d");
  EXPECT_EQ((*specs)[0].text, "quadrant:split='a,b:c=d'");
  EXPECT_EQ((*specs)[1].name, "half");
  EXPECT_TRUE(MakeEncoder("quadrant:split='best'"));
}

TEST(EncoderSpecTest, AllNamesEveryEncoderThatCanRunHere) {
  const auto specs = ParseEncoderSpecs("all");
  ASSERT_TRUE(specs);
  auto spec = specs->begin();
  for (const EncoderEntry& entry : EncoderEntries()) {
    if (entry.info.needs_parameters || !entry.info.why_not.empty()) continue;
    ASSERT_NE(spec, specs->end());
    EXPECT_EQ(spec->name, entry.info.name);
    EXPECT_TRUE(MakeEncoder(*spec));
    ++spec;
  }
  EXPECT_EQ(spec, specs->end());
}

TEST(EncoderSpecTest, UnknownEncoderListsThemAndSuggests) {
  EXPECT_THAT(ErrorOf("quadrnt"), AllOf(HasSubstr("unknown encoder `quadrnt`"),
                                        HasSubstr("half, quadrant, "),
                                        HasSubstr("did you mean `quadrant`?")));
}

TEST(EncoderSpecTest, UnknownParameterListsThemAndSuggests) {
  EXPECT_THAT(
      ErrorOf("quadrant:spilt=best"),
      AllOf(HasSubstr("unknown parameter `spilt`"), HasSubstr("split, blend"),
            HasSubstr("did you mean `split`?")));
  // Beside its own an encoder takes the modifiers; tiv has none of its own.
  EXPECT_THAT(ErrorOf("tiv:blend=srgb"),
              HasSubstr("tiv takes color, temporal, sigma, dither, atlas"));
}

TEST(EncoderSpecTest, UnknownValueListsThemAndSuggests) {
  EXPECT_THAT(ErrorOf("quadrant:blend=oklap"),
              AllOf(HasSubstr("quadrant:blend=oklap"),
                    HasSubstr("unknown value `oklap`; expected "
                              "srgb|linear|oklab"),
                    HasSubstr("did you mean `oklab`?")));
  EXPECT_THAT(ErrorOf("quadrant:split="), HasSubstr("unknown value ``"));
}

TEST(EncoderSpecTest, MalformedSpecsSayWhatIsWrong) {
  EXPECT_THAT(ErrorOf(""), HasSubstr("SPEC is empty"));
  EXPECT_THAT(ErrorOf("quadrant:best"),
              HasSubstr("expected key=value, found `best`"));
  EXPECT_THAT(ErrorOf("quadrant:=best"), HasSubstr("found `=best`"));
  EXPECT_THAT(ErrorOf("quadrant:"), HasSubstr("expected key=value"));
  EXPECT_THAT(ErrorOf("quadrant:split=best:split=range"),
              HasSubstr("parameter `split` is given more than once"));
  EXPECT_THAT(ErrorOf("quadrant:split='best"), HasSubstr("not closed"));
}

TEST(EncoderSpecTest, EveryItemOfAListMustBeGood) {
  for (const char* list : {"", "half,", ",half", "half,,tiv", "half,hlaf"}) {
    EXPECT_FALSE(ParseEncoderSpecs(list)) << list;
  }
}

// No complaint about the quote, the colon or the comma in the command.
TEST(EncoderSpecTest, ExternalTakesTheRestOfTheText) {
  const auto specs = ParseEncoderSpecs("half,external:it's -a:b, c=d:e");
  ASSERT_TRUE(specs) << specs.error().ToString();
  ASSERT_EQ(specs->size(), 2u);
  EXPECT_EQ((*specs)[1].parameters,
            (EncoderParameters{{"command", "it's -a:b, c=d:e"}}));
}

TEST(EncoderSpecTest, ExternalsParametersStandBeforeItsCommand) {
  const auto spec = ParseEncoderSpec("external:timeout=5:samples=1x2:a=b c:d");
  ASSERT_TRUE(spec) << spec.error().ToString();
  EXPECT_EQ(spec->parameters,
            (EncoderParameters{
                {"timeout", "5"}, {"samples", "1x2"}, {"command", "a=b c:d"}}));
  EXPECT_THAT(ErrorOf("external:command=a:b"), HasSubstr("more than once"));
}

// A SPEC built by hand is checked like a parsed one.
TEST(EncoderSpecTest, MakeEncoderChecksNamesAndKeys) {
  EXPECT_FALSE(MakeEncoder(EncoderSpec{"nope", {}, "nope"}));
  EXPECT_FALSE(MakeEncoder(EncoderSpec{"half", {{"x", "1"}}, "half"}));
}

TEST(RegistryTest, EveryEntryDescribesItself) {
  for (const EncoderEntry& entry : EncoderEntries()) {
    EXPECT_FALSE(entry.info.description.empty());
    EXPECT_FALSE(entry.info.glyphs.empty());
    EXPECT_GT(entry.info.samples_per_cell, 0);
    for (const EncoderParameter& parameter : entry.info.parameters) {
      EXPECT_FALSE(parameter.values.empty()) << parameter.name;
      EXPECT_FALSE(parameter.description.empty()) << parameter.name;
    }
  }
}

}  // namespace
}  // namespace rtb
