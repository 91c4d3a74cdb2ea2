// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

/// A checker of JSON against a schema, of the words of JSON Schema that doc/summary.schema.json
/// uses; any other word of a schema is refused, so that nothing passes unchecked.
class Schema {
public:
  using Json = nlohmann::json;

  explicit Schema(const Json &schema) : root(schema) {}

  /// What is wrong with @p value, a line for each fault; empty if it fits.
  std::vector<std::string> faults(const Json &value) const {
    std::vector<std::string> result;
    check(root, value, "", result);
    return result;
  }

private:
  static bool is_of_type(const std::string &type, const Json &value) {
    if (type == "object")
      return value.is_object();
    if (type == "array")
      return value.is_array();
    if (type == "string")
      return value.is_string();
    if (type == "boolean")
      return value.is_boolean();
    if (type == "null")
      return value.is_null();
    if (type == "number")
      return value.is_number();
    if (type == "integer")
      return value.is_number_integer();
    throw std::runtime_error("The schema has the type '" + type + "'.");
  }

  void check_object(const Json &schema, const Json &value, const std::string &place,
                    std::vector<std::string> &result) const {
    const Json properties = schema.value("properties", Json::object());
    for (const Json &name : schema.value("required", Json::array()))
      if (!value.contains(name.get<std::string>()))
        result.push_back(place + ": lacks " + name.get<std::string>());
    for (const auto &[name, one] : value.items()) {
      const std::string at = place + "/" + name;
      if (properties.contains(name))
        check(properties[name], one, at, result);
      else if (const Json others = schema.value("additionalProperties", Json(true));
               others.is_object())
        check(others, one, at, result);
      else if (!others.get<bool>())
        result.push_back(at + ": is not in the schema");
    }
  }

  void check(const Json &schema, const Json &value, const std::string &place,
             std::vector<std::string> &result) const {
    static const std::set<std::string> known = {
        "$schema", "$id",   "title",      "description", "$defs",
        "$ref",    "type",  "properties", "required",    "items",
        "enum",    "const", "minimum",    "anyOf",       "additionalProperties"};
    for (const auto &[word, meaning] : schema.items())
      if (known.count(word) == 0)
        throw std::runtime_error("The schema has the word '" + word + "', which is not checked.");
    if (schema.contains("$ref")) {
      const std::string path = schema["$ref"].get<std::string>();
      check(root.at(Json::json_pointer(path.substr(1))), value, place, result);
    }
    if (schema.contains("type")) {
      const Json &type = schema["type"];
      bool fits = false;
      for (const Json &one : type.is_array() ? type : Json::array({type}))
        fits = fits || is_of_type(one.get<std::string>(), value);
      if (!fits)
        result.push_back(place + ": " + value.dump() + " is not of type " + type.dump());
    }
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
      result.push_back(place + ": " + value.dump() + " is none of " + schema["enum"].dump());
    if (schema.contains("const") && schema["const"] != value)
      result.push_back(place + ": " + value.dump() + " is not " + schema["const"].dump());
    if (schema.contains("minimum") && value.is_number() &&
        value.get<double>() < schema["minimum"].get<double>())
      result.push_back(place + ": " + value.dump() + " is too small");
    if (schema.contains("anyOf")) {
      bool fits = false;
      for (const Json &one : schema["anyOf"]) {
        std::vector<std::string> faults_of_one;
        check(one, value, place, faults_of_one);
        fits = fits || faults_of_one.empty();
      }
      if (!fits)
        result.push_back(place + ": " + value.dump() + " fits none of anyOf");
    }
    if (value.is_object())
      check_object(schema, value, place, result);
    if (value.is_array() && schema.contains("items"))
      for (std::size_t i = 0; i < value.size(); ++i)
        check(schema["items"], value[i], place + "/" + std::to_string(i), result);
  }

  const Json root;
};
