#include "harness/results/run_record_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "tests/harness/results/sample_record.h"

namespace rtb {
namespace {

using testing::HasSubstr;

std::string ReadText(const std::string& file) {
  std::ifstream in(std::string(RTB_TEST_SOURCE_DIR) + "/" + file);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

/// What a JSON schema says of keys, and no more: every required key is there,
/// no key is unknown.
class KeyChecker {
 public:
  explicit KeyChecker(Json schema) : root_(std::move(schema)) {}

  void Check(const Json& value) const { Check(value, root_, "record"); }

 private:
  void Check(const Json& value, const Json& schema,
             const std::string& path) const {
    if (schema.contains("$ref")) {
      const std::string ref = schema["$ref"];
      Check(value, root_.at(Json::json_pointer(ref.substr(1))), path);
    }
    for (const auto& key : schema.value("required", Json::array())) {
      EXPECT_TRUE(value.contains(key.get<std::string>())) << path << " " << key;
    }
    if (value.is_array() && schema.contains("items")) {
      for (const Json& item : value) Check(item, schema["items"], path + "[]");
    }
    if (!value.is_object() || schema.contains("$ref")) return;
    for (const auto& [key, child] : value.items()) {
      CheckMember(key, child, schema, path + "." + key);
    }
  }

  void CheckMember(const std::string& key, const Json& child,
                   const Json& schema, const std::string& path) const {
    const Json properties = schema.value("properties", Json::object());
    if (properties.contains(key)) {
      Check(child, properties[key], path);
    } else if (schema.contains("additionalProperties") &&
               schema["additionalProperties"].is_object()) {
      Check(child, schema["additionalProperties"], path);
    } else {
      ADD_FAILURE() << path << " is not in the schema";
    }
  }

  Json root_;
};

TEST(RunRecordJsonTest, HasTheFormOfTheCommittedRecord) {
  EXPECT_EQ(FormatRecord(SampleRecord()),
            ReadText("tests/data/results/record.json"));
}

TEST(RunRecordJsonTest, HasTheKeysOfTheSchema) {
  const KeyChecker checker(Json::parse(ReadText("results/record.schema.json")));
  checker.Check(RecordToJson(SampleRecord()));
  checker.Check(RecordToJson(SampleFailure()));
}

TEST(RunRecordJsonTest, SumsUpTimes) {
  const Json json = TimesToJson({"render", {6, 2, 4}, {1, 3}});
  EXPECT_EQ(json.at("median"), 4.0);
  EXPECT_EQ(json.at("lo"), 2.0);
  EXPECT_EQ(json.at("hi"), 6.0);
  EXPECT_EQ(json.at("cv"), 0.5);
  EXPECT_EQ(json.at("cpu_median"), 2.0);
  EXPECT_EQ(json.at("samples"), Json({6.0, 2.0, 4.0}));
}

TEST(RunRecordJsonTest, UndefinedMetricsAreNull) {
  const std::vector<MetricValue> metrics = {
      {"psnr", std::nullopt},
      {"mse", 0.0},
      {"broken", std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(MetricsToJson(metrics).dump(),
            R"({"psnr":null,"mse":0.0,"broken":null})");
}

// Only what sits under `ms` and `volatile` may change with the circumstances.
TEST(RunRecordJsonTest, CircumstancesStayInTheirPlace) {
  const RunRecord first = SampleRecord();
  RunRecord second = first;
  second.conditions = {"2027-02-28T00:00:00Z",
                       {"other"},
                       3,
                       {"another CPU", 64, "x", "y", "z", 9}};
  second.runs[0].times = {{"render", {1}, {}}};
  const auto rest = [](const RunRecord& record) {
    Json json = RecordToJson(record);
    json.erase("volatile");
    for (Json& run : json["runs"]) run.erase("ms");
    return json.dump();
  };
  EXPECT_EQ(rest(first), rest(second));
  EXPECT_NE(FormatRecord(first), FormatRecord(second));
}

TEST(RunRecordJsonTest, NeverFailsOnBytesThatAreNoUtf8) {
  RunRecord record = SampleRecord();
  record.conditions.command = {"\xff"};
  EXPECT_THAT(FormatRecord(record), HasSubstr("\xEF\xBF\xBD"));
}

TEST(ParseRecordTest, ReadsWhatWasWritten) {
  const std::string text = FormatRecord(SampleRecord());
  const auto record = ParseRecord(text, "here");
  ASSERT_TRUE(record.has_value()) << record.error().ToString();
  EXPECT_EQ(FormatRecord(*record), text);
}

TEST(ParseRecordTest, ReadsEveryMeasure) {
  const RunRecord wanted = SampleRecord();
  const RunRecord record = ParseRecord(FormatRecord(wanted), "here").value();
  EXPECT_EQ(record.runs[0].rays, std::nullopt);
  EXPECT_EQ(record.runs[0].decomposition, std::nullopt);
  EXPECT_EQ(record.runs[1].rays, wanted.runs[1].rays);
  EXPECT_EQ(record.runs[1].bytes_per_frame, wanted.runs[1].bytes_per_frame);
  EXPECT_EQ(record.runs[1].pictures, wanted.runs[1].pictures);
  EXPECT_EQ(record.runs[1].bound, wanted.runs[1].bound);
  EXPECT_EQ(record.runs[1].decomposition, wanted.runs[1].decomposition);
  EXPECT_EQ(record.runs[1].temporal, wanted.runs[1].temporal);
  EXPECT_EQ(record.runs[1].live, wanted.runs[1].live);
  EXPECT_TRUE(record.runs[1].times.empty());
}

TEST(ParseRecordTest, ReadsUnitsAndFailures) {
  const RunRecord wanted = SampleFailure();
  const std::string text = FormatRecord(wanted);
  const RunRecord record = ParseRecord(text, "here").value();
  EXPECT_EQ(record.unit, wanted.unit);
  EXPECT_EQ(record.failure, wanted.failure);
  EXPECT_EQ(FormatRecord(record), text);
}

// A bound that is not known is said not to be; one that was not asked for is
// not spoken of.
TEST(RunRecordJsonTest, AnUnknownBoundIsNull) {
  RunRecord record = SampleRecord();
  record.runs[1].bound.reset();
  const Json json = RecordToJson(record);
  EXPECT_FALSE(json["runs"][0].contains("bound"));
  EXPECT_TRUE(json["runs"][1]["bound"].is_null());
  EXPECT_EQ(FormatRecord(*ParseRecord(FormatRecord(record), "here")),
            FormatRecord(record));
}

void ExpectRefused(const std::string& text, const std::string& reason) {
  const auto record = ParseRecord(text, "a.json");
  ASSERT_FALSE(record.has_value());
  EXPECT_EQ(record.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(record.error().place, "a.json");
  EXPECT_THAT(record.error().what, HasSubstr(reason));
}

TEST(ParseRecordTest, RefusesWhatIsNoRecord) {
  ExpectRefused("", "is no record");
  ExpectRefused("[1]", "is no record");
  ExpectRefused("{}", "schema");
  ExpectRefused(R"({"schema": 2})", "schema version 2, expected 1");
  ExpectRefused(R"({"schema": 1})", "manifest");
}

TEST(ParseRecordTest, RefusesWrongTypesAndMissingSamples) {
  Json json = RecordToJson(SampleRecord());
  json["runs"][0]["grid"] = "120x40";
  ExpectRefused(json.dump(), "is no record");
  json = RecordToJson(SampleRecord());
  json["runs"][0]["ms"]["render"]["samples"] = Json::array();
  ExpectRefused(json.dump(), "no samples of stage 'render'");
}

}  // namespace
}  // namespace rtb
