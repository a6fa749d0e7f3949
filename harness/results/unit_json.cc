#include "harness/results/unit_json.h"

namespace rtb {
namespace {

Json ToJson(const UnitConfiguration& c) {
  return {{"scene", c.scene},
          {"time", c.time},
          {"grid", Json::array({c.grid.columns, c.grid.rows})},
          {"spp", c.spp},
          {"backend", c.backend},
          {"integrator", c.integrator},
          {"color", c.color},
          {"reference", c.reference},
          {"seed", c.seed},
          {"encoders", c.encoders}};
}

UnitConfiguration ToConfiguration(const Json& json) {
  UnitConfiguration c;
  json.at("scene").get_to(c.scene);
  json.at("time").get_to(c.time);
  json.at("grid").at(0).get_to(c.grid.columns);
  json.at("grid").at(1).get_to(c.grid.rows);
  json.at("spp").get_to(c.spp);
  json.at("backend").get_to(c.backend);
  json.at("integrator").get_to(c.integrator);
  json.at("color").get_to(c.color);
  json.at("reference").get_to(c.reference);
  json.at("seed").get_to(c.seed);
  json.at("encoders").get_to(c.encoders);
  return c;
}

}  // namespace

Json ToJson(const Unit& unit) {
  return {{"kind", unit.kind},
          {"suite", unit.suite},
          {"hash", unit.hash},
          {"configuration", ToJson(unit.configuration)}};
}

Unit ToUnit(const Json& json) {
  return {json.at("kind"), json.at("suite"), json.at("hash"),
          ToConfiguration(json.at("configuration"))};
}

Json ToJson(const RunFailure& failure) {
  Json object = {{"kind", failure.kind}};
  if (!failure.encoder.empty()) object["encoder"] = failure.encoder;
  object["place"] = failure.place;
  object["what"] = failure.what;
  object["hint"] = failure.hint;
  return object;
}

RunFailure ToFailure(const Json& json) {
  return {json.at("kind"), json.value("encoder", ""), json.at("place"),
          json.at("what"), json.at("hint")};
}

}  // namespace rtb
